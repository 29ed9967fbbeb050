# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The table of ./dev bench: ratios are those within a round, whatever the machine did in between."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
from driver import bars, machine, process, rounds, table  # noqa: E402
from driver.cases import Case, Contender, Measurement, Options  # noqa: E402


def contender(rates, program="Repose", instructions="", threads=1, peak_mib=10.0):
    """Gives one rate a round."""
    turns = iter(rates)
    return Contender(program, lambda: Measurement(next(turns), 1.0, peak_mib), instructions, threads)


def soft_rows():
    """In the second round the machine has half of its speed."""
    case = Case(
        "soft 2D",
        10_000,
        "moving grain-steps",
        [
            contender([20e6, 10e6], instructions="scalar"),
            contender([80e6, 44e6], instructions="avx512"),
            contender([120e6, 60e6], instructions="avx512", threads=2),
            contender([10e6, 5e6], program="LAMMPS"),
        ],
    )
    return rounds.measure([case], 2, lambda text: None)


def test_ratios_are_those_within_a_round():
    scalar, fast, both, peer = table.json_of(soft_rows())
    assert fast["ratio_to"]["scalar"] == {"median": 4.2, "min": 4.0, "max": 4.4}
    assert fast["ratio_to"]["LAMMPS"] == pytest.approx({"median": 8.4, "min": 8.0, "max": 8.8})
    assert scalar["ratio_to"].keys() == {"LAMMPS"} and peer["ratio_to"] == {}
    # A rate of the clock is compared with one thread alone.
    assert both["ratio_to"].keys() == {"1 thread"} and both["unit"].endswith("per second of the clock")


def test_table_is_one_and_names_each_case_once():
    lines = table.text(soft_rows()).splitlines()
    assert len(lines) == 2 + 4 and len({len(line) for line in lines}) == 1
    assert [line.split("|")[1].strip() for line in lines[2:]] == ["soft 2D", "", "", ""]
    assert "8.4 (8-8.8)" in lines[3] and "YADE" not in lines[0]


def test_bars_are_those_of_the_instructions_and_threads():
    over_lammps, threads = bars.check(soft_rows())
    assert over_lammps == ("soft 2D, 10000 grains, avx512: rate over LAMMPS", pytest.approx(8.4), 6.5, True)
    assert threads[0].endswith("two threads over one")
    assert threads[1:] == (pytest.approx((1.5 + 60 / 44) / 2), 1.85, False)
    assert bars.check([]) == []


def test_sizes():
    options = Options("build", "folder", 1.0, None, False, print)
    assert options.wanted((10, 100), 10) == [10, 100]
    assert Options("build", "folder", 1.0, None, True, print).wanted((10, 100), 10) == [10]
    assert Options("build", "folder", 1.0, [100, 7], True, print).wanted((10, 100), 10) == [100]


def test_sets_of_the_machine_begin_with_the_reference():
    assert machine.instruction_sets()[:2] == ["scalar", "baseline"]


def test_a_program_gets_its_instruction_set_and_reports_what_it_cost():
    done = process.run(["sh", "-c", f"echo ${process.INSTRUCTION_SET}; cat"], "avx2", given="text")
    assert done.output == "avx2\ntext" and done.cpu_seconds < 1.0
    grown = process.run([sys.executable, "-c", "b = bytearray(200 << 20); import time; time.sleep(0.3)"])
    assert grown.peak_mib > 200.0


def test_a_program_that_fails_is_named_with_what_it_said():
    with pytest.raises(process.Failed, match="exit status 3\nwhy"):
        process.run(["sh", "-c", "echo why; exit 3"])
    with pytest.raises(process.Failed, match="No such file"):
        process.run(["no such program"])
