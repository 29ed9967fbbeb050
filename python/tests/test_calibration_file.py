# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Calibration files: what they say, and bad ones with a line for each problem."""

import numpy as np
import pytest

pytest.importorskip("scipy")

from repose.calibration.file_reader import CalibrationError, read_plan  # noqa: E402
from repose.calibration.plan import Design  # noqa: E402
from repose.calibration.sweep_rounds import SweepRounds, sweep_text, values_of  # noqa: E402

GOOD = '''title = "heaps"
scene = "heap.toml"
seeds = 4
[set]
source.count = 40
contact.normal = { law = "hooke", stiffness = 1e4 }
[[parameter]]
key = "contact.friction"
range = [0.1, 0.9]
[[parameter]]
key = "contact.rolling.friction"
range = [0.01, 1]
prior = "log-uniform"
[[parameter]]
key = "grains.density"
range = [1, 3]
prior = { mean = 2, deviation = 0.5 }
[[target]]
measure = "angle_of_repose_deg.mean"
value = 30
error = 1
[design]
start = 10
most = 20
'''


def plan_of(tmp_path, text):
    path = tmp_path / "c.toml"
    path.write_text(text)
    return read_plan(path)


def test_a_file_says_what_it_means(tmp_path):
    plan = plan_of(tmp_path, GOOD)
    assert [p.key for p in plan.parameters] == ["contact.friction", "contact.rolling.friction", "grains.density"]
    assert [p.prior for p in plan.parameters] == ["uniform", "log-uniform", "normal"]
    assert plan.design == Design(start=10, most=20) and plan.seeds == 4
    assert plan.scene == tmp_path.resolve() / "heap.toml"
    assert (plan.targets[0].value, plan.targets[0].error) == (30.0, 1.0)


def test_first_points_are_eight_for_each_parameter(tmp_path):
    assert plan_of(tmp_path, GOOD[: GOOD.index("[design]")]).design == Design(start=24)


def test_a_round_keeps_settings_as_written_and_values_to_the_bit(tmp_path):
    plan = plan_of(tmp_path, GOOD)
    values = plan.values(np.random.default_rng(1).random((5, 3)))
    text = sweep_text(plan, values, first=7, seeds=[5, 6])
    assert 'contact.normal = { law = "hooke", stiffness = 1e4 }' in text and 'name = "p007"' in text
    assert (values_of(plan, text) == values).all()


BAD = [
    ("seeds = 4", "seeds = 1", "seeds = 1: must be a whole number from 2 to 1000"),
    ("seeds = 4", "sedes = 4", "sedes: unknown key; known here: title, scene, seeds, set, parameter, target, design"),
    ('scene = "heap.toml"', "", "scene: missing"),
    ("[0.1, 0.9]", "[0.9, 0.1]", "parameter[0].range = [0.9, 0.1]: must be two numbers, the lower one first"),
    ("[0.1, 0.9]", "0.1", "parameter[0].range = 0.1: must be two numbers"),
    ("[0.01, 1]", "[0, 1]", "parameter[1].range = [0, 1]: must be > 0, as the prior is log-uniform"),
    ('"log-uniform"', '"beta"', 'parameter[1].prior = "beta": must be "uniform", "log-uniform" or a table'),
    ("mean = 2", "mean = 4", "parameter[2].prior.mean = 4: must lie within the range"),
    ("deviation = 0.5", "deviation = 0", "parameter[2].prior.deviation = 0: must be a number > 0"),
    ("deviation = 0.5", "sd = 0.5", "parameter[2].prior.sd: unknown key; known here: mean, deviation"),
    ("contact.rolling.friction", "contact.friction", 'parameter[1].key = "contact.friction": is a parameter already'),
    ("contact.rolling.friction", "source.count", 'parameter[1].key = "source.count": stands under [set] too'),
    ("contact.rolling.friction", "a b", 'parameter[1].key = "a b": must be a key of the scene'),
    ("angle_of_repose_deg.mean", "profile.dip_index", "must be a measure that each member has"),
    ("value = 30", "value = nan", "target[0].value = nan: must be a finite number"),
    ("error = 1", "error = 0", "target[0].error = 0: must be a number > 0"),
    ("error = 1", "", "target[0].error: missing"),
    ("start = 10", "start = 30", "design.most = 20: must be no less than design.start = 30"),
    ("start = 10", 'sequence = "random"', 'design.sequence = "random": must be "sobol" or "halton"'),
    ("start = 10", "stop = -1", "design.stop = -1: must be a number > 0"),
    ("start = 10", "first = 10", "design.first: unknown key"),
    ("[set]\n", "[set\n", "Expected"),
    ("[set]\nsource.count", "set.source.count", "set: must be written as a table under the line [set]"),
]  # fmt: skip


@pytest.mark.parametrize("old, new, message", BAD)
def test_bad_input_is_named(tmp_path, old, new, message):
    assert old in GOOD
    with pytest.raises(CalibrationError) as raised:
        plan_of(tmp_path, GOOD.replace(old, new, 1))
    path = tmp_path / "c.toml"
    assert all(line.startswith(f"{path}: ") and "\n" not in line for line in raised.value.problems)
    assert any(message in line for line in raised.value.problems), raised.value.problems


def test_all_problems_at_once(tmp_path):
    text = GOOD.replace("seeds = 4", "seeds = 0").replace("error = 1", "error = -1").replace("[0.1, 0.9]", "[1, 1]")
    with pytest.raises(CalibrationError) as raised:
        plan_of(tmp_path, text)
    assert len(raised.value.problems) == 3


@pytest.mark.parametrize("table", ["parameter", "target"])
def test_both_lists_are_needed(tmp_path, table):
    blocks = [block for block in GOOD.replace("[[", "\0[[").replace("[design]", "\0[design]").split("\0")]
    text = "".join(block for block in blocks if not block.startswith(f"[[{table}]]"))
    with pytest.raises(CalibrationError, match=f"{table}: must be one table or more"):
        plan_of(tmp_path, text)


@pytest.mark.parametrize("text", ["nonsense", "", '[[point]]\nset = { contact.friction = 0.1 }\n'])
def test_a_damaged_round_is_named(tmp_path, text):
    rounds = SweepRounds(plan_of(tmp_path, GOOD), tmp_path, "repose", None, print)
    assert rounds.planned(1) is None
    (tmp_path / "rounds").mkdir()
    (tmp_path / "rounds/01.toml").write_text(text)
    with pytest.raises(CalibrationError, match="01.toml: is damaged: "):
        rounds.planned(1)
