# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is measured: cases, and in each the programs that do the same work."""

from collections.abc import Callable
from dataclasses import dataclass, field

OWN = "Repose"


@dataclass(frozen=True)
class Measurement:
    rate: float  # work per second: of CPU time with one thread, of the clock with more
    seconds: float  # that it took, of the same kind
    peak_mib: float  # largest memory of the process
    more: dict = field(default_factory=dict)


@dataclass(frozen=True)
class Contender:
    """A program with its settings, which does the work of a case when called."""

    program: str
    measure: Callable[[], Measurement]
    instructions: str = ""  # empty: as the program was compiled
    threads: int = 1
    note: str = ""


@dataclass(frozen=True)
class Case:
    """The same work for all contenders. The scalar reference of Repose, if there is one, comes first."""

    method: str
    size: int  # grains
    unit: str  # of the work
    contenders: list[Contender]


@dataclass(frozen=True)
class Options:
    """What the caller wants of the cases of a method."""

    build: str  # folder of the programs
    folder: str  # where beds are kept
    seconds: float  # of CPU time that a program measures itself
    sizes: list[int] | None  # None: all
    quick: bool
    say: Callable[[str], None]  # shows progress

    def wanted(self, sizes, quick):
        """Those of some sizes that are to be measured; `quick` is the largest in a quick run."""
        if self.sizes is not None:
            return [size for size in sizes if size in self.sizes]
        return [size for size in sizes if not self.quick or size <= quick]

    def program(self, name):
        return f"{self.build}/{name}"


def of_cost(cost, threads=1, peak_mib=None):
    """The measurement that one of our own programs printed."""
    seconds = cost["cpu_seconds" if threads == 1 else "wall_seconds"]
    known = ("work", "cpu_seconds", "wall_seconds", "peak_mib")
    more = {name: value for name, value in cost.items() if name not in known}
    return Measurement(cost["work"] / seconds, seconds, peak_mib or cost["peak_mib"], more)
