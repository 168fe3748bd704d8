# SPDX-License-Identifier: GPL-3.0-or-later
"""What a recording holds, bit by bit, but for how long it took."""
import h5py
import numpy


def described(node):
    """What a node of a recording is: its kind, shape and type, its bits, and its attributes."""
    attributes = {name: numpy.asarray(value).tolist() for name, value in node.attrs.items() if name != "wall_seconds"}
    if not isinstance(node, h5py.Dataset):
        return "group", attributes
    values = node[()]
    bits = values if isinstance(values, bytes) else numpy.asarray(values)
    text = bits if isinstance(bits, bytes) else repr(bits.tolist()) if bits.dtype == object else bits.tobytes()
    return node.dtype.str, node.shape, text, attributes


def content(file):
    """Everything in a recording, by path; soft links as what they lead to."""
    all_of_it = {"/": described(file)}

    def add(group):
        for name in group:
            link = group.get(name, getlink=True)
            if isinstance(link, h5py.SoftLink):
                all_of_it[f"{group.name}/{name}"] = link.path
                continue
            all_of_it[group[name].name] = described(group[name])
            if isinstance(group[name], h5py.Group):
                add(group[name])

    add(file)
    return all_of_it


def differences(one, other):
    """The paths at which two recordings differ."""
    with h5py.File(one) as first, h5py.File(other) as second:
        a, b = content(first), content(second)
    return [path for path in sorted({*a, *b}) if a.get(path) != b.get(path)]
