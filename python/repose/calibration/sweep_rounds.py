# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures rounds of points by `repose sweep`: DIR/rounds/NN.toml is the sweep of round NN, DIR/rounds/NN its
folder."""

import ctypes
import json
import os
import signal
import subprocess
import tempfile
import tomllib
from pathlib import Path

import numpy as np

from repose.calibration.errors import CalibrationError, SweepStopped
from repose.errors import one_line
from repose.sweep_folder import SweepFolder

RUN_TROUBLE, BAD_INPUT, INTERRUPTED = 1, 2, 130
PR_SET_PDEATHSIG = 1


def sweep_text(plan, values, first=1, seeds=None, names=None):
    """A sweep file with a point for each row of values (n, d), named from p001 on, and the seeds."""
    lines = [f"title = {json.dumps(plan.title, ensure_ascii=False)}"] if plan.title else []
    lines += [f"scene = {json.dumps(str(plan.scene), ensure_ascii=False)}", f"seeds = {seeds or plan.seeds}"]
    if plan.settings:
        lines += ["", plan.settings.rstrip()]
    for k, row in enumerate(values):
        settings = ", ".join(f"{p.key} = {float(value)!r}" for p, value in zip(plan.parameters, row))
        name = names[k] if names else point_name(first + k)
        lines += ["", "[[point]]", f'name = "{name}"', f"set = {{ {settings} }}"]
    return "\n".join(lines) + "\n"


def point_name(number):
    return f"p{number:03}"


def values_of(plan, text):
    """The values (n, d) of a text that sweep_text wrote."""
    return np.array([[_value(point["set"], p.key) for p in plan.parameters] for point in tomllib.loads(text)["point"]])


def _value(table, key):
    for step in key.split("."):
        table = table[step]
    return float(table)


def _written(path, text):
    """A file beside `path` with this text, under a name that no other program has on any machine."""
    temporary = path.with_name(f".{path.name}.{os.uname().nodename}.{os.getpid()}")
    temporary.write_text(text, encoding="utf-8")
    return temporary


def write_text(path, text):
    """Writes a file under another name and renames it: no file is ever incomplete."""
    os.replace(_written(path, text), path)


def write_first(path, text):
    """Writes a file unless it exists; of several programs that do so, one does. No file is ever incomplete."""
    if path.is_file():
        return
    temporary = _written(path, text)
    try:
        os.link(temporary, path)
    except FileExistsError:
        pass
    except OSError:
        os.replace(temporary, path)  # a file system without hard links
    finally:
        temporary.unlink(missing_ok=True)


def _end_with_parent():
    """The sweep ends with the calibration, however that ends."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


class SweepRounds:
    """Rounds of a calibration in its folder."""

    def __init__(self, plan, folder, program, threads, report, part=()):
        """`threads` members run side by side (None: the program decides); `report` takes lines of progress; `part` holds
        the options of a sweep that several programs share."""
        self.plan, self.folder = plan, Path(folder, "rounds")
        self.program, self.threads, self.report, self.part = program, threads, report, part
        self.points = 0  # of the rounds so far

    def planned(self, number):
        """Values (n, d) of a round that has been begun, or None."""
        path = self.folder / f"{number:02}.toml"
        if not path.is_file():
            return None
        try:
            return values_of(self.plan, path.read_text(encoding="utf-8"))
        except (ValueError, KeyError, TypeError) as error:
            raise CalibrationError([f"{path}: is damaged: {one_line(error)}"]) from error

    def run(self, number, values):
        """Measures the values (n, d) of a round: the values, results (n, S, T) and numbers of failed members (n). The
        values are those of another program where that was the first to begin the round. Members that have ended are not
        run again. SweepStopped where the sweep does not end well."""
        path, out = self.folder / f"{number:02}.toml", self.folder / f"{number:02}"
        seeds = [self.plan.seeds * (number - 1) + k for k in range(1, self.plan.seeds + 1)]
        self.folder.mkdir(parents=True, exist_ok=True)
        # All parts run the round of the first, even where arithmetic differs from machine to machine.
        write_first(path, sweep_text(self.plan, values, self.points + 1, seeds))
        values = self.planned(number)
        self.points += len(values)
        self.report(f"round {number}: {len(values)} points, {len(values) * len(seeds)} members")
        words = [] if self.threads is None else ["--threads", str(self.threads)]
        status = call([self.program, "sweep", path, "--out", out, "--quiet", *words, *self.part])
        if status not in (0, RUN_TROUBLE):
            raise SweepStopped(status)
        return values, *self._results(out, len(values), len(seeds))

    def _results(self, folder, points, members):
        sweep = SweepFolder(folder)
        self._check_measures(sweep)
        found = np.full((points, members, len(self.plan.targets)), np.nan)
        for k, target in enumerate(self.plan.targets):
            column = sweep.values.get(target.measure, np.full(points * members, np.nan))
            found[:, :, k] = np.reshape(column, (points, members))  # seeds of the first point come first
        ended = np.reshape([status == "finished" for status in sweep.members["status"]], (points, members))
        return np.where(ended[:, :, None], found, np.nan), np.sum(~ended, axis=1)

    def _check_measures(self, sweep):
        """CalibrationError for measures that no member has."""
        if "finished" not in sweep.members["status"]:
            return
        known = ", ".join(sorted(sweep.values))
        problems = [
            f"{self.plan.path}: target[{k}].measure = {json.dumps(target.measure)}: no member has it; they have {known}"
            for k, target in enumerate(self.plan.targets)
            if target.measure not in sweep.values
        ]
        if problems:
            raise CalibrationError(problems)


def call(words):
    """The exit status of a program; Ctrl-C and SIGTERM are handed to it, and it ends in its own time."""
    process = subprocess.Popen(list(map(str, words)), preexec_fn=_end_with_parent)
    try:
        return process.wait()
    except KeyboardInterrupt:
        process.terminate()
        process.wait()
        return INTERRUPTED


def check(plan, values, program, part=()):
    """Lines that describe the first round. CalibrationError with the program's problems of the scene at these values
    and at both ends of all ranges, and of the options of a part."""
    ends = np.array([[getattr(p, end) for p in plan.parameters] for end in ("low", "high")])
    names = ["low", "high", *(point_name(k + 1) for k in range(len(values)))]
    _checked(plan, np.vstack([ends, values]), names, program, part)
    return _checked(plan, values, None, program, part)


def _checked(plan, values, names, program, part):
    with tempfile.TemporaryDirectory(prefix="repose-calibrate-") as folder:
        path = Path(folder, "round.toml")
        path.write_text(sweep_text(plan, values, names=names), encoding="utf-8")
        words = [program, "sweep", path, "--out", Path(folder, "out"), "--check", *part]
        result = subprocess.run(list(map(str, words)), capture_output=True, text=True, errors="replace")
        if result.returncode != 0:
            raise CalibrationError(_problems(plan, result.stderr, str(path)))
        return result.stdout.replace(str(path), plan.path)


def _problems(plan, said, path):
    """The lines that the program said, with the name of the calibration in place of that of its sweep, whose lines have
    other numbers."""
    lines = []
    for line in said.splitlines():
        if path in line:
            before, _, after = line.partition(path)
            number, colon, rest = after.lstrip(":").partition(":")
            line = before + plan.path + (colon + rest if number.isdigit() else after)
        lines.append(line.removeprefix("repose sweep: ").removeprefix("repose: "))
    return list(dict.fromkeys(lines)) or [f"{plan.path}: cannot be checked"]
