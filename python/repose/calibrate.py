# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibrates a scene: `python3 -m repose.calibrate PROGRAM FILE DIR [--threads N] [--share I/N --lease S] [--overwrite]
[--check] [--quiet]`, called by `repose calibrate`."""

import argparse
import signal
import sys
from pathlib import Path

from repose.calibration.errors import CalibrationError, NotCalibrated, SweepStopped
from repose.errors import RunFolderError, complain, one_line, say

FORMATS = ("png", "svg")
DPI = 200


def options_of(arguments):
    parser = argparse.ArgumentParser(prog="repose calibrate")
    parser.add_argument("program")
    parser.add_argument("file")
    parser.add_argument("folder")
    parser.add_argument("--threads", type=int)
    parser.add_argument("--share", dest="part")
    parser.add_argument("--lease", default="60")
    for name in ("--overwrite", "--check", "--quiet"):
        parser.add_argument(name, action="store_true")
    return parser.parse_args(arguments)


def part_of(options):
    """The options of the sweeps of a calibration that several programs share; none where one has it alone."""
    return ["--share", options.part, "--lease", options.lease] if options.part else []


def progress(plan, tell):
    """A reporter of fits: how certain each surrogate is, in errors of its target."""

    def report(number, measured, fit):
        ratios = ", ".join(f"{ratio:.2g}" for ratio in fit.ratios(plan))
        tell(f"round {number}: {len(measured.values)} points; deviation of surrogates over target errors: {ratios}"
             f" (stop below {plan.design.stop:g})")  # fmt: skip

    return report


def describe(plan, listing):
    """What --check prints."""
    lines = [plan.title] if plan.title else []
    for p in plan.parameters:
        prior = f"normal {p.mean:g} +- {p.deviation:g}" if p.prior == "normal" else p.prior
        lines.append(f"parameter {p.key}: {p.low:g} to {p.high:g}, {prior}")
    lines += [f"target {t.measure}: {t.value:g} +- {t.error:g}" for t in plan.targets]
    design = plan.design
    first = f"first {design.start} points ({design.sequence})"
    lines.append(f"{first}, then rounds of {design.batch}, at most {design.most}")
    return "\n".join([*lines, "", "The first round:", listing.rstrip()])


def draw(plan, folder, measured, fit):
    """Writes the pictures; returns their paths."""
    from repose import style
    from repose.calibration import picture

    place = Path(folder, "pictures")
    place.mkdir(exist_ok=True)
    paths = [place / f"calibration.{kind}" for kind in FORMATS]
    with style.context():
        figure = picture.draw(plan, measured, fit)
        for path, kind in zip(paths, FORMATS):
            style.save(figure, path, kind, DPI, plan.title or "calibration")
    return paths


def calibrate(options):
    """Exit status of a calibration that the options name. Slow imports come after the checks of the file."""
    from repose.calibration.file_reader import read_plan

    plan = read_plan(options.file)
    from repose.calibration.folder import folder_problem, one_at_a_time, open_folder

    problem = folder_problem(plan, options.folder, options.overwrite)
    if problem:
        raise CalibrationError([problem])
    from repose.calibration import design, sweep_rounds

    part = part_of(options)
    listing = sweep_rounds.check(plan, design.first_points(plan), options.program, part)
    if options.check:
        say(describe(plan, listing))
        return 0
    from repose.calibration import loop, results

    tell = (lambda text: None) if options.quiet else say
    open_folder(plan, options.folder, options.overwrite, bool(part))  # stays locked until the program ends
    rounds = sweep_rounds.SweepRounds(plan, options.folder, options.program, options.threads, tell, part)
    found = loop.calibrate(plan, rounds, progress(plan, tell))
    with one_at_a_time(options.folder):
        content = results.write_results(options.folder, plan, *found)
        pictures = draw(plan, options.folder, *found[:2])
    tell(results.summary_text(content))
    for path in pictures:
        tell(path)
    return 0


def run(options):
    """Exit status; one line on stderr for each problem."""
    try:
        return calibrate(options)
    except ImportError as error:
        packages = "the Debian packages python3-scipy and python3-sklearn"
        complain(f"repose calibrate: needs {packages}: {one_line(error)}")
        return 1
    except SweepStopped as stop:
        return stop.status
    except CalibrationError as error:
        for line in error.problems:
            complain(line)
        return 2
    except RunFolderError as error:
        complain(one_line(error))
        return 2
    except NotCalibrated as error:
        complain(f"repose calibrate: {error}")
        return 1
    except OSError as error:
        complain(f"repose calibrate: {error.filename or options.folder}: {error.strerror}")
        return 2


def interrupt(*_):
    raise KeyboardInterrupt


def main(arguments=None):
    """The exit status that the program wants: 0, 1 after trouble in a run, 2 after bad input, 130 after a signal."""
    for number in (signal.SIGTERM, signal.SIGUSR1):
        signal.signal(number, interrupt)
    try:
        return run(options_of(arguments))
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
