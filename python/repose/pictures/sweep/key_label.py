# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Keys of a scene as labels of axes: in words, with their units."""

import re

PLAIN = ("contact", "method", "grains")  # tables whose keys are clear without their name
REDUCED = {
    "L": "σ", "M": "m", "T": "√(σ/g)", "1/T": "√(g/σ)", "L/T": "√(gσ)", "L/T^2": "g", "M/T^2": "(mg/σ)", "M L/T^2": "mg",
    "1/L": "(1/σ)", "L^2": "σ²",
}  # fmt: skip
SI = {
    "L": "m", "M": "kg", "T": "s", "1/T": "1/s", "L/T": "m/s", "L/T^2": "m/s²", "M/T^2": "N/m", "M L/T^2": "N",
    "1/L": "1/m", "L^2": "m²",
}  # fmt: skip


def words_of(key):
    """Such as "normal stiffness" of "contact.normal.stiffness"."""
    *tables, name = key.split(".")
    return " ".join([*(table for table in tables[-1:] if table not in PLAIN), name]).replace("_", " ")


def key_label(key, comments, units):
    """The words of a key with its unit, as far as the scenes of the sweep say it; `units` of a Units."""
    unit = comments[key].unit if key in comments else ""
    if units.reduced and unit in REDUCED:
        return f"{words_of(key)} / {REDUCED[unit]}"
    return f"{words_of(key)} ({SI.get(unit, unit)})" if unit else words_of(key)


def meaning_of(key, comments):
    """One line that explains the words of a key: the first statement of its meaning. "" where it is not known."""
    if key not in comments:
        return ""
    return f"{words_of(key)}: {re.split(r'[:;(]', comments[key].meaning)[0].strip()}"
