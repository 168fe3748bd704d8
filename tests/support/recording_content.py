# SPDX-License-Identifier: GPL-3.0-or-later
"""Bitwise comparison of recordings, without their wall times."""
import h5py
import numpy


def described(node):
    """Returns type, shape, bits and attributes of a dataset, or the attributes of a group."""
    attributes = {name: numpy.asarray(value).tolist() for name, value in node.attrs.items() if name != "wall_seconds"}
    if not isinstance(node, h5py.Dataset):
        return "group", attributes
    values = node[()]
    bits = values if isinstance(values, bytes) else numpy.asarray(values)
    text = bits if isinstance(bits, bytes) else repr(bits.tolist()) if bits.dtype == object else bits.tobytes()
    return node.dtype.str, node.shape, text, attributes


def content(file):
    """Returns the content of all groups and datasets by path; for soft links, the path to which they lead."""
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
    """Returns the paths at which two recordings differ."""
    with h5py.File(one) as first, h5py.File(other) as second:
        a, b = content(first), content(second)
    return [path for path in sorted({*a, *b}) if a.get(path) != b.get(path)]
