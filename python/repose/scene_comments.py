# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Units and meanings of the keys of a scene, from the comments of the scene.toml that a run folder has."""

import re
from dataclasses import dataclass

TABLE = re.compile(r"\[\[?([\w.]+)\]\]?$")
KEY = re.compile(r"([\w.]+) = .*?  # (?:\[([^\]]*)\] )?(.*)$")


@dataclass(frozen=True)
class KeyComment:
    """What the program writes beside a key."""

    unit: str  # in M, L, T, or in words; "" without
    meaning: str


def key_comments(text):
    """KeyComment by dotted key; of a key in several tables of one name the last."""
    table, known = "", {}
    for line in text.splitlines():
        if head := TABLE.match(line):
            table = head[1] + "."
        elif key := KEY.match(line):
            known[table + key[1]] = KeyComment(key[2] or "", key[3])
    return known
