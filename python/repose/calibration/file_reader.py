# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a calibration file, with every problem in one line."""

import json
import math
import re
import tomllib
from pathlib import Path

from repose.calibration.errors import CalibrationError
from repose.calibration.plan import LOG_UNIFORM, NORMAL, UNIFORM, Design, Parameter, Plan, Target
from repose.errors import one_line

KEYS = ("title", "scene", "seeds", "set", "parameter", "target", "design")
DESIGN_KEYS = ("start", "sequence", "batch", "most", "stop", "seed")
MOST_PARAMETERS = 10
MOST_POINTS = 1000  # the cost of a Gaussian process grows with the cube of their number
FIRST_PER_PARAMETER = 8


def shown(value):
    """A value as TOML writes it, in short."""
    if isinstance(value, (dict, list, str, bool)):
        return json.dumps(value, ensure_ascii=False, default=str)
    return str(value)


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def is_whole(value):
    return isinstance(value, int) and not isinstance(value, bool)


class _Reader:
    """Collects the problems of one file."""

    def __init__(self, path):
        self.path = path
        self.problems = []

    def problem(self, what):
        self.problems.append(f"{self.path}: {what}")

    def check_keys(self, table, prefix, known):
        for key in table:
            if key not in known:
                self.problem(f"{prefix}{key}: unknown key; known here: {', '.join(known)}")

    def text(self, table, prefix, key, default=None):
        """Text that is not empty; None without, which is a problem unless there is a default."""
        value = table.get(key, default)
        if value is None:
            self.problem(f"{prefix}{key}: missing")
        elif not isinstance(value, str) or not (value or default == ""):
            self.problem(f"{prefix}{key} = {shown(value)}: must be text")
            return None
        return value

    def number(self, table, prefix, key, positive=False, default=None):
        value = table.get(key, default)
        if value is None:
            self.problem(f"{prefix}{key}: missing")
        elif not is_number(value) or (positive and not value > 0):
            self.problem(f"{prefix}{key} = {shown(value)}: must be a {'number > 0' if positive else 'finite number'}")
        else:
            return float(value)
        return None

    def whole(self, table, prefix, key, least, most, default):
        value = table.get(key, default)
        if not is_whole(value) or not least <= value <= most:
            self.problem(f"{prefix}{key} = {shown(value)}: must be a whole number from {least} to {most}")
            return default
        return value

    def tables(self, root, key):
        """The tables under [[key]]; at least one is needed."""
        found = root.get(key)
        if not isinstance(found, list) or not found or not all(isinstance(entry, dict) for entry in found):
            self.problem(f"{key}: must be one table or more, each headed [[{key}]]")
            return []
        return found


def _range(reader, table, prefix):
    value = table.get("range")
    if value is None:
        reader.problem(f"{prefix}range: missing: give [low, high]")
    elif not isinstance(value, list) or len(value) != 2 or not all(map(is_number, value)) or not value[0] < value[1]:
        reader.problem(f"{prefix}range = {shown(value)}: must be two numbers, the lower one first")
    else:
        return float(value[0]), float(value[1])
    return None


def _prior(reader, table, prefix, ends):
    """Keywords of a Parameter that say its prior."""
    value = table.get("prior", UNIFORM)
    if value == UNIFORM:
        return {}
    if value == LOG_UNIFORM:
        if ends and not ends[0] > 0.0:
            reader.problem(f"{prefix}range = {shown(table['range'])}: must be > 0, as the prior is log-uniform")
        return {"prior": LOG_UNIFORM}
    if not isinstance(value, dict):
        allowed = '"uniform", "log-uniform" or a table with mean and deviation'
        reader.problem(f"{prefix}prior = {shown(value)}: must be {allowed}")
        return {}
    reader.check_keys(value, f"{prefix}prior.", ("mean", "deviation"))
    mean = reader.number(value, f"{prefix}prior.", "mean")
    deviation = reader.number(value, f"{prefix}prior.", "deviation", positive=True)
    if ends and mean is not None and not ends[0] <= mean <= ends[1]:
        reader.problem(f"{prefix}prior.mean = {shown(value['mean'])}: must lie within the range")
    return {"prior": NORMAL, "mean": mean, "deviation": deviation}


def _parameters(reader, root):
    found = []
    for k, table in enumerate(reader.tables(root, "parameter")):
        prefix = f"parameter[{k}]."
        reader.check_keys(table, prefix, ("key", "range", "prior"))
        key = reader.text(table, prefix, "key")
        if key and not re.fullmatch(r"[A-Za-z0-9_-]+(\.[A-Za-z0-9_-]+)*", key):
            reader.problem(f"{prefix}key = {shown(key)}: must be a key of the scene, such as contact.friction")
        elif key and key in [parameter.key for parameter in found]:
            reader.problem(f"{prefix}key = {shown(key)}: is a parameter already")
        elif key and _has(root.get("set"), key):
            reader.problem(f"{prefix}key = {shown(key)}: stands under [set] too")
        ends = _range(reader, table, prefix)
        prior = _prior(reader, table, prefix, ends)
        found.append(Parameter(key or "", *(ends or (0.0, 1.0)), **prior))
    if len(found) > MOST_PARAMETERS:
        reader.problem(f"parameter: {len(found)} of them: at most {MOST_PARAMETERS}")
    return found


def _has(table, key):
    for step in key.split("."):
        if not isinstance(table, dict) or step not in table:
            return False
        table = table[step]
    return True


def _targets(reader, root):
    found = []
    for k, table in enumerate(reader.tables(root, "target")):
        prefix = f"target[{k}]."
        reader.check_keys(table, prefix, ("measure", "value", "error"))
        measure = reader.text(table, prefix, "measure")
        if measure and measure.startswith("profile."):
            reader.problem(f"{prefix}measure = {shown(measure)}: must be a measure that each member has")
        elif measure and measure in [target.measure for target in found]:
            reader.problem(f"{prefix}measure = {shown(measure)}: is a target already")
        value = reader.number(table, prefix, "value")
        error = reader.number(table, prefix, "error", positive=True)
        found.append(Target(measure or "", value, error))
    return found


def _design(reader, root, parameters):
    table = root.get("design", {})
    if not isinstance(table, dict):
        reader.problem("design: must be a table")
        table = {}
    reader.check_keys(table, "design.", DESIGN_KEYS)
    usual = Design()
    first = FIRST_PER_PARAMETER * max(1, parameters)
    sequence = table.get("sequence", usual.sequence)
    if sequence not in ("sobol", "halton"):
        reader.problem(f'design.sequence = {shown(sequence)}: must be "sobol" or "halton"')
    design = Design(
        start=reader.whole(table, "design.", "start", 4, MOST_POINTS, first),
        sequence=sequence,
        batch=reader.whole(table, "design.", "batch", 1, MOST_POINTS, usual.batch),
        most=reader.whole(table, "design.", "most", 4, MOST_POINTS, max(usual.most, first)),
        stop=reader.number(table, "design.", "stop", positive=True, default=usual.stop),
        seed=reader.whole(table, "design.", "seed", 0, 2**31 - 1, usual.seed),
    )
    if design.most < design.start:
        reader.problem(f"design.most = {design.most}: must be no less than design.start = {design.start}")
    return design


HEADER = re.compile(r"\s*\[\[?\s*([A-Za-z0-9_-]+)")


def settings_text(text):
    """The lines of the table [set] and of those below it, as written: inline tables stay what they are."""
    kept, inside = [], False
    for line in text.splitlines():
        header = HEADER.match(line)
        if header and line.lstrip().startswith("["):
            inside = header[1] == "set"
        if inside:
            kept.append(line)
    return "".join(line + "\n" for line in kept)


def _settings(reader, root, text):
    if "set" not in root:
        return ""
    if not isinstance(root["set"], dict):
        reader.problem(f"set = {shown(root['set'])}: must be a table of keys of the scene")
        return ""
    kept = settings_text(text)
    try:
        same = tomllib.loads(kept).get("set") == root["set"]
    except tomllib.TOMLDecodeError:
        same = False
    if not same:
        reader.problem("set: must be written as a table under the line [set], a key to a line")
    return kept


def _parsed(path):
    try:
        text = Path(path).read_text(encoding="utf-8")
        return text, tomllib.loads(text)
    except OSError as error:
        raise CalibrationError([f"{path}: cannot read: {error.strerror}"]) from error
    except UnicodeDecodeError as error:
        raise CalibrationError([f"{path}: is no text in UTF-8"]) from error
    except tomllib.TOMLDecodeError as error:
        raise CalibrationError([f"{path}: {one_line(error)}"]) from error


def read_plan(path):
    """The Plan of a calibration file. CalibrationError with every problem; the program checks the scene."""
    text, root = _parsed(path)
    reader = _Reader(path)
    reader.check_keys(root, "", KEYS)
    title = reader.text(root, "", "title", default="")
    scene = reader.text(root, "", "scene")
    seeds = reader.whole(root, "", "seeds", 2, 1000, 3)
    parameters = _parameters(reader, root)
    targets = _targets(reader, root)
    design = _design(reader, root, len(parameters))
    settings = _settings(reader, root, text)
    if reader.problems:
        raise CalibrationError(reader.problems)
    place = (Path(path).parent / scene).resolve()
    return Plan(parameters, targets, design, seeds, title, str(path), text, place, settings)
