# SPDX-License-Identifier: GPL-3.0-or-later
"""Converts scenes of Python values to TOML."""
from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy


def key_of(name: str) -> str:
    """Returns a key in TOML, in quotes where necessary."""
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name, ensure_ascii=False)


def value_of(value: Any) -> str:
    """Returns a value in TOML, on one line. Raises TypeError if it is not a number, bool, str, path, list, tuple, array
    or mapping."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(value_of(item) for item in value)}]"
    if isinstance(value, Mapping):
        return f"{{ {', '.join(f'{key_of(key)} = {value_of(item)}' for key, item in value.items())} }}"
    raise TypeError(f"a scene has no values of {type(value).__name__}: {value!r}")


def lines_of(table: Mapping[str, Any], path: str = "") -> Iterator[str]:
    """Yields the lines of a table in TOML; tables within it follow under headers of their own."""
    inner = {key: value for key, value in table.items() if isinstance(value, Mapping)}
    if path and (len(inner) < len(table) or not table):
        yield f"[{path}]"
    for key, value in table.items():
        if key not in inner:
            yield f"{key_of(key)} = {value_of(value)}"
    for key, value in inner.items():
        yield from lines_of(value, f"{path}.{key_of(key)}" if path else key_of(key))
