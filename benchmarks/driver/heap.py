# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The heap of Baxter et al. (1997) with Hooke's law, beside LAMMPS: same base, same pour, same number of steps.

`repose_pour_list` says when and where each disc is released, and LAMMPS releases them then and there. The figures are
those of the whole programs: Repose also measures, analyses and writes the run.
"""

import functools
import os
import tempfile

from . import lammps, machine
from .beds import BEDS
from .cases import OWN, Case, Contender, Measurement
from .process import Failed, run

SCENE = os.path.join(BEDS, "paper-heap.toml")
STEPS, TIME_STEP = 2_150_000, 1e-3
SHORT = STEPS // 10
QUICK = STEPS // 25
SKINS = (0.2, 0.4, 0.8, 1.6)  # discs that fall make lists old soon, so a wide skin is the best
TRIED = STEPS // 20  # steps of the search for the best

# What LAMMPS does after it has created discs.
NEW = """set group all diameter 1
set group all density/disc 1.2732395447351628
group moving type 1
"""


class Pour:
    """The fixed discs, and when and where the others are released, at rest."""

    def __init__(self, options):
        rows = [line.split() for line in run([options.program("repose_pour_list"), SCENE]).output.splitlines()]
        self.fixed = [row[1:3] for row in rows if row[0] == "-1"]
        self.poured = [(int(row[0]), *row[1:3]) for row in rows if row[0] != "-1"]
        assert all(float(row[3]) == 0.5 for row in rows)

    def grain_steps(self, steps):
        """Poured discs times steps, those of discs that have left included."""
        return float(sum(max(0, steps - release) for release, _, _ in self.poured))

    def released(self, steps):
        return sum(release <= steps for release, _, _ in self.poured)

    def script(self, steps):
        """Commands of LAMMPS that release the discs and take the steps."""
        lines, now = [], 0
        for release, x, y in self.poured:
            if release > steps:
                break
            if release > now:
                lines.append(f"run {release - now} post no")
            now = release
            lines += [f"create_atoms 1 single {x} {y} 0 units box", "include new.in"]
        return "\n".join([*lines, f"run {steps - now}"]) + "\n"


def cases(options, whole):
    pour = Pour(options)
    steps = STEPS if whole else QUICK if options.quick else SHORT
    name = "paper heap" if whole else f"paper heap, first {100 * steps / STEPS:g} % of the steps"
    contenders = [own(options, pour, steps, one) for one in machine.instruction_sets()]
    if lammps.program():
        contenders.append(contender(pour, steps))
    yield Case(name, pour.released(steps), "moving grain-steps", contenders)


def of_seconds(pour, steps, seconds, peak_mib, more):
    work = pour.grain_steps(steps)
    more = {"steps": steps, **more}
    if steps < STEPS:
        more["seconds_of_the_whole_heap_extrapolated"] = seconds * pour.grain_steps(STEPS) / work
    return Measurement(work / seconds, seconds, peak_mib, more)


def own(options, pour, steps, instructions):
    def measure():
        with tempfile.TemporaryDirectory() as folder:
            command = [options.program("repose"), "run", SCENE, "--out", os.path.join(folder, "heap"), "--quiet"]
            done = run([*command, "--threads", 1, "--set", f"stop.time={steps * TIME_STEP!r}"], instructions)
        return of_seconds(pour, steps, done.cpu_seconds, done.peak_mib, {})

    return Contender(OWN, measure, instructions)


def run_lammps(pour, steps, skin):
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "base.in")
        with open(base, "w", encoding="utf-8") as file:
            file.writelines(f"create_atoms 2 single {x} {y} 0 units box\n" for x, y in pour.fixed)
        with open(os.path.join(folder, "new.in"), "w", encoding="utf-8") as file:
            file.write(NEW)
        with open(os.path.join(folder, "pour.in"), "w", encoding="utf-8") as file:
            file.write(pour.script(steps))
        done, log = lammps.call("lammps_heap.in", folder, skin=skin)
        end = [line for line in log.splitlines() if line.startswith("heap ")]
        if not end:
            raise Failed(f"LAMMPS has not reached the end of the heap\n{log[-2000:]}")
        moving, height = (float(word) for word in end[-1].split()[1:])
        return done, {"skin": skin, "moving": moving, "height_of_mass": height}


@functools.cache
def best_skin(pour):
    return min(SKINS, key=lambda skin: run_lammps(pour, TRIED, skin)[0].cpu_seconds)


def contender(pour, steps):
    def measure():
        done, more = run_lammps(pour, steps, best_skin(pour))
        return of_seconds(pour, steps, done.cpu_seconds, done.peak_mib, more)

    return Contender("LAMMPS", measure)
