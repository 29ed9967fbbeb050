# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""`repose run --profile` says where the time of a run went, stage by stage, and does not change a bit of it."""

import json

import pytest
from conftest import HEAP, Laboratory, everything_in, summary

BRIEF_HEAP = HEAP.replace("at_rest = 1e-6", "").replace("time = 500", "time = 40")

PACKING = """critical_angle = 50
[base]
kind = "contiguous"
count = 20
[source]
count = 5000
"""

SCENES = {
    "soft": HEAP,
    "contact-dynamics": BRIEF_HEAP,
    "hybrid": BRIEF_HEAP,
    "deposition": PACKING,
}
# Stages that every run of a method has.
STAGES = {
    "soft": {"pair lists", "wall lists", "forces and motion", "sources", "test of rest"},
    "contact-dynamics": {"pair lists", "free velocities", "contact search", "impacts", "solver", "motion", "sources"},
    "hybrid": {"pair lists", "flights and collisions", "solver"},
    "deposition": {"dropping discs"},
}
OF_ANY_RUN = {"time series", "track and progress", "contacts of the state", "analysis", "writing", "other"}


def scene_of(method):
    return f'[method]\nkind = "{method}"\n' + SCENES[method]


@pytest.fixture(scope="module", params=sorted(SCENES))
def profiled(request, tmp_path_factory):
    """The method of a run with a profile, its folder and what it printed."""
    lab = Laboratory(tmp_path_factory.mktemp(request.param))
    said = lab("run", lab.scene(scene_of(request.param)), "--out", "out", "--profile")
    assert said.returncode == 0, said.stderr
    return request.param, lab, said.stdout


def stages(lab):
    return json.loads((lab.path / "out" / "profile.json").read_text())


def test_every_method_has_its_stages(profiled):
    method, lab, _ = profiled
    found = {stage["name"]: stage for stage in stages(lab)["stages"]}
    assert STAGES[method] | OF_ANY_RUN <= set(found)
    assert all(found[name]["calls"] > 0 for name in STAGES[method])


def test_stages_sum_to_the_total(profiled):
    _, lab, _ = profiled
    profile = stages(lab)
    seconds = [stage["seconds"] for stage in profile["stages"]]
    assert min(seconds) >= 0.0
    assert sum(seconds) == pytest.approx(profile["seconds"], rel=1e-12)
    # Almost everything happens in a stage; short runs may wait for the disk outside.
    other = next(stage["seconds"] for stage in profile["stages"] if stage["name"] == "other")
    assert other < 0.2 * profile["seconds"] + 0.2


def test_table_has_the_numbers_of_the_file(profiled):
    _, lab, said = profiled
    table = said[said.index("\nstage ") :]
    rows = {line[:24].strip(): line[24:].split() for line in table.splitlines() if line}
    profile = stages(lab)
    for stage in profile["stages"]:
        assert float(rows[stage["name"]][0]) == pytest.approx(stage["seconds"], rel=0.2, abs=0.01)
    assert sum(float(rows[stage["name"]][1]) for stage in profile["stages"]) == pytest.approx(100.0, abs=1.0)
    assert "million grain-steps per second" in table


def test_bits_are_the_same(profiled):
    method, lab, _ = profiled
    plain = lab.run(scene_of(method), out="plain")
    assert summary(plain)["state_hash"] == summary(lab.path / "out")["state_hash"]
    assert set(everything_in(lab.path / "out")) - set(everything_in(plain)) == {"profile.json"}


def test_a_new_run_removes_an_old_profile(lab):
    lab.run(HEAP, "--profile")
    lab.run(HEAP, "--overwrite")
    assert not (lab.path / "out" / "profile.json").exists()


def test_profile_of_an_interrupted_run(lab):
    scene = lab.scene(HEAP.replace("at_rest = 1e-6", "").replace("time = 500", "time = 1e6"))
    said = lab.shell(f'timeout --foreground --signal=INT 2 "$REPOSE" run {scene} --out out --profile')
    assert "forces and motion" in said.stdout
    assert "checkpoints" in {stage["name"] for stage in stages(lab)["stages"]}
