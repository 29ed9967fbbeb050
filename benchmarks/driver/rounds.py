# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Measures all cases in interleaved rounds.

Machines drift by a quarter within minutes. In a round the contenders of a case run one after the other, and ratios are
those within a round; a case is met again only when all others have had their turn.
"""

from dataclasses import dataclass

from .cases import OWN, Case, Contender, Measurement


@dataclass(frozen=True)
class Row:
    """The measurements of one contender, one for each round."""

    case: Case
    contender: Contender
    measured: list[Measurement]

    @property
    def rates(self):
        return [one.rate for one in self.measured]


def measure(cases, rounds, say):
    rows = [Row(case, contender, []) for case in cases for contender in case.contenders]
    for turn in range(rounds):
        for done, row in enumerate(rows):
            case, contender = row.case, row.contender
            with_threads = f"{contender.threads} threads" if contender.threads > 1 else ""
            how = " ".join(filter(None, [contender.program, contender.instructions, with_threads]))
            say(f"round {turn + 1} of {rounds}, {done + 1} of {len(rows)}: {case.method}, {case.size} grains, {how}")
            row.measured.append(contender.measure())
    return rows


def reference_of(row, rows):
    """The scalar reference of the case of a row of Repose on one thread; None if there is none, or if this is it."""
    if row.contender.program != OWN:
        return None
    for other in rows:
        if other.case is row.case and other.contender.program == OWN and other.contender.instructions == "scalar":
            return other if other is not row else None
    return None


def one_thread_of(row, rows):
    """The row of the same program with the same instructions on one thread."""
    for other in rows:
        same = other.contender.program == row.contender.program
        same = same and other.contender.instructions == row.contender.instructions
        if other.case is row.case and same and other.contender.threads == 1:
            return other
    return None


def peers_of(row, rows):
    """{program: row} of the other programs of a case of Repose."""
    if row.contender.program != OWN:
        return {}
    return {r.contender.program: r for r in rows if r.case is row.case and r.contender.program != OWN}


def ratios(row, other):
    """Of the rates of a row to those of another one, round by round."""
    return [mine / theirs for mine, theirs in zip(row.rates, other.rates)]
