# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Studies through the program: verdicts follow from stored runs, models and profiles; figures, page, bad input."""

import json
import re

import pytest
import xxhash
from conftest import HEAP

SWEEP = """title = "small heaps"
scene = "../../../heap.toml"
seeds = 5
[vary]
contact.friction = [0.2, 0.5]
[quick]
seeds = 3
set.source.count = 30
"""
STUDY = """title = "Coordination of small heaps"
source = "Nobody 2026, Fig. 1"
states = "Grains have fewer than six neighbours."
ensemble = "ensembles/heaps.toml"

[[claim]]
text = "fewer than six neighbours"
measure = "coordination"
point = "friction=0.5"
below = 6

[[claim]]
text = "a lattice pile of 60 degrees"
point = "friction=0.5"
against = "pile-lattice"
set = { slope_deg = 60, base_count = 9 }
force = "normal"
below = 0.1

[[claim]]
text = "the spring of the paper"
model = "equivalent-spring"
set = { closest = 0.915 }
number = "stiffness"
above = 450
below = 550

[figure]
[[figure.panel]]
kind = "base"
points = ["friction=0.5"]
[[figure.panel]]
kind = "measure"
measure = "coordination"
over = "contact.friction"
[[figure.panel]]
kind = "claims"
[[figure.panel]]
kind = "grains"
point = "friction=0.2"
[[figure.panel]]
kind = "network"
point = "friction=0.2"
[[figure.panel]]
kind = "forces"
point = "friction=0.2"
[[figure.panel]]
kind = "lines"
point = "friction=0.2"
which = "weakest"
[[figure.panel]]
kind = "bars"
points = ["friction=0.2", "friction=0.5"]
measures = ["coordination", "heap_height"]
[[figure.panel]]
kind = "model"
curves = [{ model = "equivalent-spring", x = "distance", y = "spring", label = "spring" }]
"""


@pytest.fixture
def studies(lab):
    """A folder with one group of one study, on an ensemble of two points."""
    lab.scene(HEAP, "heap.toml")
    (lab.path / "studies/small/ensembles").mkdir(parents=True)
    lab.scene(SWEEP, "studies/small/ensembles/heaps.toml")
    lab.scene(STUDY, "studies/small/heap.toml")
    return lab


def study(lab, *words, expect=0):
    result = lab("study", *words, "--studies", "studies")
    assert result.returncode == expect, result.stderr + result.stdout
    return result


def claims(lab, out):
    return json.loads((lab.path / out / "small/heap/study.json").read_text())["claims"]


def test_both_forms_have_folders_of_their_own(studies):
    study(studies, "run", "small.heap", "--quick", "--quiet")
    study(studies, "run", "all", "--quiet")
    for form, seeds in (("quick", 3), ("full", 5)):
        members = studies.path / f"studies-{form}/small/ensembles/heaps/members"
        assert len(list(members.glob("*/seed-*/run.h5"))) == 2 * seeds
        (first, *_) = claims(studies, f"studies-{form}")
        assert (first["n"], first["verdict"]) == (seeds, "agrees")
        assert (studies.path / f"studies-{form}/small/heap/figure.png").stat().st_size > 10_000
    # the quick form is a complete sweep of its own
    again = studies("sweep", "studies-quick/small/ensembles/heaps/sweep.toml", "--quiet")
    assert again.returncode == 0, again.stderr


def test_planted_runs_and_other_bounds_flip_the_verdicts(studies):
    study(studies, "run", "small.heap", "--quick", "--quiet")
    verdicts = [claim["verdict"] for claim in claims(studies, "studies-quick")]
    # heaps differ, so the deviation of their mean profile is not decided; the spring has 188
    assert verdicts == ["agrees", "undecided", "disagrees"]
    for k, path in enumerate(sorted(studies.path.glob("studies-quick/small/ensembles/heaps/members/*/seed-*/summary.json"))):
        text = re.sub(r'\n  "coordination": [^,]*', f'\n  "coordination": {7.0 + 0.01 * k}', path.read_text())
        body = text[: text.rindex(',\n  "checksum"')]
        path.write_text(f'{body},\n  "checksum": "{xxhash.xxh3_128_hexdigest(body.encode())}"\n}}\n')
    study(studies, "run", "small.heap", "--quick", "--quiet")
    assert claims(studies, "studies-quick")[0]["verdict"] == "disagrees"
    assert claims(studies, "studies-quick")[0]["value"] == pytest.approx(7.04, abs=0.02)
    studies.scene(STUDY.replace("above = 450", "above = 150").replace("below = 550", "below = 200"), "studies/small/heap.toml")
    study(studies, "run", "small.heap", "--quick", "--quiet")
    spring = claims(studies, "studies-quick")[2]
    assert spring["verdict"] == "agrees"
    assert spring["value"] == pytest.approx(188.24, abs=0.01)


# An equilateral pile by springs has the forces of the lattice theory; nothing in it is random, so two runs decide.
def test_a_profile_without_scatter_is_judged_exactly(studies):
    pile = """[method]
kind = "hybrid"
stiffness = 1e5
pin_base = true
relax = true
[contact]
friction = 0.0
[base]
kind = "plane"
[box]
half_width = 20.0
[source]
kind = "lattice"
rows = 11
[analysis]
base_bin = 1.0
[stop]
time = 0.5
"""
    studies.scene(pile, "heap.toml")
    studies.scene('scene = "../../../heap.toml"\nseeds = 2\n', "studies/small/ensembles/heaps.toml")
    text = """title = "pile"
source = "Liffman et al. 1992, (42)"
states = "The forces of the lattice."
ensemble = "ensembles/heaps.toml"
[[claim]]
text = "within {bound} of the lattice"
point = "heap"
against = "pile-lattice"
set = {{ slope_deg = 60, base_count = 11 }}
force = "{force}"
below = {bound}
[figure]
picture = "profiles"
"""
    for force in ("normal", "shear"):
        found = {}
        for bound in (0.02, 1e-6):
            studies.scene(text.format(bound=bound, force=force), "studies/small/heap.toml")
            study(studies, "run", "small", "--quick", "--quiet")
            (claim,) = claims(studies, "studies-quick")
            found[bound] = claim["verdict"]
        assert found == {0.02: "agrees", 1e-6: "disagrees"}, (force, claim)


# The variance of the q-model scatters between its runs: 0.41 +- 0.01 of 20 runs, and so nine times less of 1600.
def test_a_random_model_has_an_interval(studies):
    text = """title = "weights"
source = "nobody"
states = "nothing"
[[claim]]
text = "few runs"
model = "q-model"
set = { runs = 20 }
number = "variance"
above = 0.394
below = 0.454
[[claim]]
text = "many runs"
model = "q-model"
set = { runs = 1600 }
number = "variance"
above = 0.394
below = 0.454
[figure]
"""
    studies.scene(text, "studies/small/heap.toml")
    study(studies, "run", "small", "--quiet")
    few, many = claims(studies, "studies-full")
    assert (few["verdict"], few["n"], few["test"]) == ("undecided", 20, "t")
    assert (many["verdict"], many["n"]) == ("agrees", 1600)
    assert few["high"] - few["low"] == pytest.approx(2.0 * 2.093 * few["error"], rel=1e-3)  # Student's t of 19 degrees


def test_the_profile_of_rigid_grains_is_not_determined(studies):
    rigid = HEAP.replace("[base]", '[method]\nkind = "contact-dynamics"\n[base]', 1).replace("count = 40", "count = 12")
    studies.scene(rigid, "heap.toml")
    study(studies, "run", "small", "--quick", "--quiet")
    assert [claim["verdict"] for claim in claims(studies, "studies-quick")][1] == "not determined"


def test_two_ensembles_of_one_name_are_refused(studies):
    (studies.path / "studies/small/other").mkdir()
    studies.scene(SWEEP, "studies/small/other/heaps.toml")
    studies.scene(STUDY.replace("ensembles/heaps", "other/heaps"), "studies/small/second.toml")
    studies.refused("study", "run", "all", "--studies", "studies", parts=("other/heaps.toml: has the name of",))


# Three rigid discs on a row have more forces than balances; nothing else is asked of the numbers here.
def test_force_ranges_are_computed_once(studies):
    rigid = HEAP.replace("[base]", '[method]\nkind = "contact-dynamics"\n[base]', 1).replace("count = 40", "count = 6")
    studies.scene(rigid, "heap.toml")
    studies.scene('scene = "../../../heap.toml"\nseeds = 2\n', "studies/small/ensembles/heaps.toml")
    text = """title = "rigid"
source = "nobody"
states = "nothing"
ensemble = "ensembles/heaps.toml"
force_range = true
[[claim]]
text = "there are forces that balance does not determine"
measure = "force_range.degree"
point = "heap"
above = -100
[figure]
"""
    studies.scene(text, "studies/small/heap.toml")
    study(studies, "run", "small", "--quiet")
    (claim,) = claims(studies, "studies-full")
    assert (claim["n"], claim["verdict"]) == (2, "agrees")
    summaries = sorted(studies.path.glob("studies-full/small/ensembles/heaps/members/*/seed-*/summary.json"))
    before = [path.stat().st_mtime_ns for path in summaries]
    study(studies, "run", "small", "--quiet")
    assert [path.stat().st_mtime_ns for path in summaries] == before
    studies.scene(HEAP, "heap.toml")
    studies.refused("study", "list", "--studies", "studies", parts=("force_range: only rigid grains have one",))


def test_list_and_page(studies):
    said = study(studies, "list").stdout
    assert "small.heap" in said and "10 runs" in said and "3 claims" in said
    assert "6 runs" in study(studies, "list", "--quick").stdout
    missing = studies("study", "page", "all", "--studies", "studies")
    assert missing.returncode == 2 and "repose study run" in missing.stderr
    study(studies, "run", "all", "--quick", "--quiet")
    study(studies, "page", "all", "--quick", "--page", "page.md")
    page = (studies.path / "page.md").read_text()
    assert "| fewer than six neighbours | < 6 |" in page
    assert "1 agrees, 1 disagrees, 1 undecided" in page
    (picture,) = re.findall(r"\]\((images/studies/\S+)\)", page)
    assert (studies.path / picture).is_file()


def test_bad_studies_are_refused_with_all_problems(studies):
    wrong = STUDY.replace("states =", "state =").replace('number = "stiffness"', 'number = "stiffnes"')
    wrong = wrong.replace('measure = "coordination"\npoint', 'measure = "coordinatio"\npoint').replace('force = "normal"', 'force = "up"')
    studies.scene(wrong, "studies/small/heap.toml")
    studies.refused(
        "study", "run", "all", "--studies", "studies",
        parts=(
            "heap.toml:3: state: unknown key", "states: missing", 'claim.number = "stiffnes": the model has stiffness, work',
            'claim.force = "up"', 'claim[0].measure = "coordinatio": no such measure',
        ),
    )  # fmt: skip
    studies.scene(STUDY, "studies/small/heap.toml")
    studies.scene(SWEEP.replace("[quick]", "[quick]\nseed = 3"), "studies/small/ensembles/heaps.toml")
    studies.refused("study", "list", "--quick", "--studies", "studies", parts=("quick.seed: unknown key",))
    studies.refused("study", "run", "large", "--studies", "studies", parts=("large: no such study",))
    studies.refused("study", "run", "--studies", "studies", parts=("all runs every one",))
    studies.refused("study", "list", "--studies", "nowhere", parts=("nowhere: holds no studies",))


def test_an_unknown_panel_is_reported_and_the_verdicts_stay(studies):
    studies.scene(STUDY.replace('kind = "claims"', 'kind = "cake"'), "studies/small/heap.toml")
    said = study(studies, "run", "all", "--quick").stdout
    assert 'not drawn: no panel "cake"' in said
    assert "agrees" in said
    assert len(claims(studies, "studies-quick")) == 3
