# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Python values as the text of a scene file."""

import json
import math
import re
from numbers import Integral, Real
from os import PathLike, fspath

PLAIN_KEY = re.compile(r"[A-Za-z0-9_-]+")


def toml_text(value):
    """A bool, number, text, path, list or dict (of numpy too) as TOML; TypeError for anything else."""
    if hasattr(value, "tolist"):
        value = value.tolist()  # of numpy
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Integral):
        return str(int(value))
    if isinstance(value, Real):
        return repr(float(value)) if math.isfinite(value) else str(float(value))
    if isinstance(value, PathLike):
        value = fspath(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # escapes as TOML does
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{toml_key(key)} = {toml_text(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_text, value)) + "]"
    raise TypeError(f"{value!r}: no value of a scene: must be a bool, a number, text, a list or a dict")


def toml_key(key):
    """A key, in quotes where it needs them."""
    return key if PLAIN_KEY.fullmatch(key) else json.dumps(key)
