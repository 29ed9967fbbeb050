#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes python/repose/scene_keys.py: the keys of scenes as classes with types and docstrings, for editors and mypy.

usage: write_scene_keys.py FOLDER [--check] [ROOT]
       FOLDER holds the compiled module (build/release/python); --check: exit status 1 if the file is stale
"""

import keyword
import sys
from pathlib import Path

TYPES = {
    "number": "float",
    "number or word": "float | str",
    "whole number": "int",
    "true or false": "bool",
    "text": "str",
    "vector": "list[float]",
    "list": "list[float]",
}
HEAD = '''# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The keys of a scene with their types, by tables. `./dev docs` writes this file from what the program knows."""

from __future__ import annotations

from repose.keys import Keys
'''
WIDTH = 120


def class_name(prefix):
    """"contact.normal." becomes ContactNormalKeys."""
    return "".join(part.title() for step in prefix.split(".") for part in step.split("_")) + "Keys"


def lists_of(keys):
    """Names of the lists of tables, in order."""
    return list(dict.fromkeys(key.split("[]")[0] for key, *_ in keys if "[]" in key))


def tables_of(keys):
    """For each table prefix, its steps in order: name -> list of entries (own keys) or None (a table)."""
    tables = {"": {}}
    for key, *entry in keys:
        if "[]" in key:
            continue
        steps = key.split(".")
        for depth in range(len(steps) - 1):
            prefix = "".join(step + "." for step in steps[:depth])
            tables[prefix].setdefault(steps[depth], None)
            tables.setdefault(prefix + steps[depth] + ".", {})
        prefix = "".join(step + "." for step in steps[:-1])
        known = tables[prefix].setdefault(steps[-1], [])
        if known is not None:
            known.append(entry)
    return tables


def type_of(entries):
    """The type of a key that may mean different things."""
    return " | ".join(dict.fromkeys(part for entry in entries for part in TYPES[entry[0]].split(" | ")))


def comment_of(entries):
    """Unit, meaning and default of a key, shortened to a line."""
    _, unit, _, fallback, about = entries[0]
    text = (f"[{unit}] " if unit else "") + " ".join(about.split()) + (f"; default {fallback}" if fallback else "")
    return text


def written(keys):
    """The text of the file."""
    text = HEAD
    tables = tables_of(keys)
    for prefix in sorted(tables, key=lambda name: -name.count(".")):
        title = f"Keys under {prefix[:-1]}." if prefix else "Keys of a scene."
        text += f'\n\nclass {class_name(prefix) if prefix else "SceneKeys"}(Keys):\n    """{title}"""\n\n'
        for step, entries in tables[prefix].items():
            name = step + "_" if keyword.iskeyword(step) else step
            if entries is None:
                text += f"    {name}: {class_name(prefix + step + '.')}\n"
                continue
            line = f"    {name}: {type_of(entries)}  # {comment_of(entries)}"
            text += (line if len(line) <= WIDTH else line[: WIDTH - 3] + "...") + "\n"
        if not prefix:
            text += "".join(f"    {name}: list[dict[str, object]]  # [[{name}]]; Scene.add appends\n" for name in lists_of(keys))
    return text


def main(arguments):
    """Exit status."""
    folder, *rest = arguments
    root = Path(next((word for word in rest if not word.startswith("-")), Path(__file__).resolve().parent.parent))
    sys.path.insert(0, folder)
    import repose_compiled

    path = root / "python/repose/scene_keys.py"
    fresh = written(repose_compiled.scene_keys())
    old = path.read_text(encoding="utf-8") if path.is_file() else ""
    if fresh == old:
        return 0
    if "--check" in rest:
        print(f"{path}: is stale: run ./dev docs")
        return 1
    path.write_text(fresh, encoding="utf-8")
    return 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
