# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims of a sweep through the program, against tests computed here from the members' own files."""

import csv
import json

import h5py
import numpy as np
import pytest
from conftest import HEAP, Laboratory

SEEDS = 6
ANGLE = "angle_of_repose_deg.mean"
SWEEP = f"""scene = "heap.toml"
seeds = {SEEDS}
[vary]
contact.friction = [0.1, 0.5, 0.6]
"""
CLAIMS = {
    "steeper": (ANGLE, 'difference = ["friction=0.5", "friction=0.1"]\nabove = 0'),
    "flat": (ANGLE, 'point = "friction=0.1"\nbelow = 20'),
    "steep": (ANGLE, 'point = "friction=0.5"\nabove = 10\nbelow = 40'),
    "steep too": (ANGLE, 'point = "friction=0.6"\nabove = 1'),
    "alike": (ANGLE, 'equivalent = ["friction=0.5", "friction=0.6"]\nmargin = 30'),
    "all alike": (ANGLE, 'equivalent = ["friction=0.1", "friction=0.5", "friction=0.6"]\nmargin = 0.01'),
    "dips": ("profile.dip_index", 'point = "friction=0.5"\nabove = 1'),
    "dips more": ("profile.dip_index", 'difference = ["friction=0.5", "friction=0.1"]\nabove = 0'),
    "ratio": ("profile.max_over_centre", 'point = "friction=0.5"\nbelow = 100'),
    "unknown": ("packing.solid_fraction.mean", 'point = "friction=0.5"\nabove = 1'),
}
TEXT = SWEEP + "".join(
    f'[[claim]]\ntext = "{name}"\nmeasure = "{measure}"\n{what}\n' for name, (measure, what) in CLAIMS.items()
)
LEVEL = 0.025


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Swept:
    """A sweep that has run: its claims by text, its table by point, values of members by point and seed."""

    def __init__(self, folder):
        self.folder = folder
        self.claims = {row["claim"]: row for row in rows_of(folder / "claims.csv")}
        self.table = {row["point"]: row for row in rows_of(folder / "table.csv")}
        self.members = rows_of(folder / "members.csv")

    def values(self, friction, measure=ANGLE):
        mine = [row for row in self.members if row["point"] == f"friction={friction}"]
        return np.array([float(row[measure] or "nan") for row in sorted(mine, key=lambda row: int(row["seed"]))])

    def pairs(self, first, second):
        """Differences of the angle seed by seed, where both heaps have one: heaps of so few grains may not."""
        differences = self.values(first) - self.values(second)
        return differences[np.isfinite(differences)]

    def bases(self, friction):
        folders = [self.folder / f"members/friction={friction}/seed-{seed}" for seed in range(1, SEEDS + 1)]
        return np.array([json.loads((folder / "summary.json").read_text())["base_profile"]["normal"]
                         for folder in folders])


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp("claims"))
    lab.scene(HEAP.replace("count = 40", "count = 30"), "heap.toml")
    lab.scene(TEXT, "sweep.toml")
    lab.result = lab("sweep", "sweep.toml", "--out", "out")
    assert lab.result.returncode == 0, lab.result.stderr
    return lab


@pytest.fixture(scope="module")
def swept(lab):
    return Swept(lab.path / "out")


def number(row, key):
    return float(row[key])


def tail(t, freedom):
    """P(T > t) of Student's t with whole degrees of freedom (Abramowitz and Stegun, 26.7.3 and 26.7.4)."""
    angle = np.arctan(abs(t) / np.sqrt(freedom))
    odd = freedom % 2
    powers = range(odd, freedom - 1, 2)  # of the cosine
    terms, factor = [], 1.0
    for power in powers:
        terms.append(factor * np.cos(angle) ** power)
        factor *= (power + 1) / (power + 2)
    within = np.sin(angle) * sum(terms)
    within = 2.0 / np.pi * (angle + within) if odd else within
    return 0.5 * (1.0 - within) if t >= 0.0 else 0.5 * (1.0 + within)


def p_above(values, bound):
    """P-value of a mean above a bound."""
    return tail((values.mean() - bound) / standard_error(values), len(values) - 1)


def standard_error(values):
    return values.std(ddof=1) / np.sqrt(len(values))


def same_p(p_value):
    """Probabilities are written to ten digits; tails are computed here to 1e-15."""
    return pytest.approx(p_value, rel=1e-8, abs=1e-14)


def test_the_tail_of_students_t():
    """Entries of the usual tables."""
    assert tail(12.7062, 1) == pytest.approx(0.025, rel=1e-4)
    assert tail(2.77645, 4) == pytest.approx(0.025, rel=1e-4)
    assert tail(-2.57058, 5) == pytest.approx(0.975, rel=1e-4)


def word(p_holds, p_fails, words=("agrees", "disagrees")):
    return words[0] if p_holds <= LEVEL else words[1] if p_fails <= LEVEL else "undecided"


def test_intervals_of_the_table_are_students_t(swept):
    values = swept.values("0.5")
    row = swept.table["friction=0.5"]
    low, high = (number(row, f"{ANGLE}:{end}") for end in ("low", "high"))
    assert low + high == pytest.approx(2.0 * values.mean(), rel=1e-9)
    assert tail((high - values.mean()) / standard_error(values), SEEDS - 1) == pytest.approx(LEVEL, rel=1e-7)
    assert (row[f"{ANGLE}:count"], row[f"{ANGLE}:missing"]) == (str(SEEDS), "0")
    with h5py.File(swept.folder / "sweep.h5", "r") as file:
        assert file.attrs["interval"] == 0.95 and file.attrs["resamples"] == 9999
        np.testing.assert_allclose(file[f"measures/{ANGLE}/low"][1], low, rtol=1e-9)
        assert np.isnan(file[f"measures/{ANGLE}/bias"][1])


def test_a_difference_is_of_pairs(swept):
    claim = swept.claims["steeper"]
    pairs = swept.pairs("0.5", "0.1")
    p_holds = p_above(pairs, 0.0)
    assert claim["test"] == "paired t" and claim["n"] == str(SEEDS) and claim["n_missing"] == "0"
    assert number(claim, "p_holds") == same_p(p_holds)
    assert number(claim, "value") == pytest.approx(pairs.mean(), rel=1e-12)
    assert number(claim, "error") == pytest.approx(standard_error(pairs), rel=1e-12)
    assert claim["verdict"] == word(p_holds, 1.0 - p_holds)


def test_a_mean_within_bounds(swept):
    values = swept.values("0.5")
    claim = swept.claims["steep"]
    above, below = p_above(values, 10.0), p_above(-values, -40.0)
    assert number(claim, "p_holds") == same_p(max(above, below))
    assert number(claim, "p_fails") == same_p(min(1.0 - above, 1.0 - below))
    assert claim["verdict"] == word(max(above, below), min(1.0 - above, 1.0 - below))


def equivalence(swept, first, second, margin):
    """One-sided p-values of two tests: of a difference within the margin, and beyond it."""
    pairs = swept.pairs(first, second)
    above, below = p_above(pairs, -margin), p_above(-pairs, -margin)
    return max(above, below), min(1.0 - above, 1.0 - below)


def test_equivalence_is_two_one_sided_tests(swept):
    claim = swept.claims["alike"]
    p_holds, p_fails = equivalence(swept, "0.5", "0.6", 30.0)
    assert number(claim, "p_holds") == same_p(p_holds)
    assert claim["verdict"] == word(p_holds, p_fails, ("equivalent", "different")) == "equivalent"
    assert (claim["kind"], claim["above"], claim["below"]) == ("equivalence", "-30", "30")
    assert claim["pair"] == "friction=0.5 friction=0.6"


def test_points_of_which_one_pair_differs(swept):
    """Every pair at a third of the level; the pair that differs most decides."""
    claim = swept.claims["all alike"]
    pairs = [("0.1", "0.5"), ("0.1", "0.6"), ("0.5", "0.6")]
    p_values = [equivalence(swept, *pair, 0.01) for pair in pairs]
    p_holds, p_fails = max(p[0] for p in p_values), min(1.0, 3.0 * min(p[1] for p in p_values))
    assert number(claim, "p_holds") == same_p(p_holds)
    assert number(claim, "p_fails") == same_p(p_fails)
    assert claim["verdict"] == word(p_holds, p_fails, ("equivalent", "different"))
    decides = min if p_fails <= LEVEL else max
    pair = decides(zip(p_values, pairs), key=lambda both: both[0][1 if p_fails <= LEVEL else 0])[1]
    assert claim["pair"] == f"friction={pair[0]} friction={pair[1]}"


def dip_index(normal, x):
    """By the definition in docs/reference/analysis.md."""
    smooth = np.array([normal[max(0, k - 2):k + 3].mean() for k in range(len(normal))])
    loaded = np.flatnonzero(smooth > 0.1 * smooth.max())
    centre, half = 0.5 * (x[loaded[-1]] + x[loaded[0]]), 0.5 * (x[loaded[-1]] - x[loaded[0]])
    place = np.abs(x - centre) / half
    return normal[(place > 0.15) & (place <= 0.45)].mean() / normal[place <= 0.15].mean()


def test_errors_of_the_dip_are_by_a_bootstrap(swept):
    """Against other draws of 4000 resamples. Two errors of finite bootstraps are 1.3 %; four are allowed, 5.4 %."""
    with h5py.File(swept.folder / "sweep.h5", "r") as file:
        x = file["profiles/0001/x"][()]
        attributes = dict(file["profiles/0001"].attrs)
    rng = np.random.default_rng(1)
    bases = {friction: swept.bases(friction) for friction in ("0.1", "0.5")}
    draws = rng.integers(SEEDS, size=(4000, SEEDS))
    dips = {friction: np.array([dip_index(normal[draw].mean(axis=0), x) for draw in draws])
            for friction, normal in bases.items()}
    widened = np.sqrt(SEEDS / (SEEDS - 1))
    assert attributes["dip_index"] == pytest.approx(dip_index(bases["0.5"].mean(axis=0), x), rel=1e-12)
    assert attributes["dip_index_error"] == pytest.approx(widened * dips["0.5"].std(), rel=0.054)
    assert number(swept.claims["dips"], "error") == pytest.approx(attributes["dip_index_error"], rel=1e-12)
    assert swept.claims["dips"]["test"] == "bootstrap"
    pairs = swept.claims["dips more"]
    assert pairs["test"] == "paired bootstrap" and pairs["n"] == str(SEEDS)
    assert number(pairs, "error") == pytest.approx(widened * (dips["0.5"] - dips["0.1"]).std(), rel=0.054)
    assert number(pairs, "low") < number(pairs, "value") < number(pairs, "high")


def test_the_largest_ring_states_its_bias(swept):
    """The largest ring of a resample is larger than that of the mean, on average."""
    row = swept.table["friction=0.5"]
    bias = number(row, "profile.max_over_centre:bias")
    assert np.isfinite(bias)
    assert number(swept.claims["ratio"], "bias") == bias
    assert swept.claims["steep"]["bias"] == "" and f"{ANGLE}:bias" not in row


def test_holm_adjusts_for_all_claims_with_data(swept):
    claims = [row for row in swept.claims.values() if row["p_holds"]]
    assert len(claims) == len(CLAIMS) - 1 and swept.claims["unknown"]["verdict"] == "no data"
    assert (swept.claims["unknown"]["n"], swept.claims["unknown"]["n_missing"]) == ("0", str(SEEDS))
    for kind in ("p_holds", "p_fails"):
        p_values = np.array([number(row, kind) for row in claims])
        order = np.argsort(p_values, kind="stable")
        steps = np.minimum(1.0, p_values[order] * np.arange(len(order), 0, -1))
        adjusted = np.empty(len(order))
        adjusted[order] = np.maximum.accumulate(steps)
        np.testing.assert_allclose([number(row, f"{kind}_holm") for row in claims], adjusted, rtol=1e-12)
    for row in claims:
        words = ("equivalent", "different") if row["kind"] == "equivalence" else ("agrees", "disagrees")
        assert row["verdict_holm"] == word(number(row, "p_holds_holm"), number(row, "p_fails_holm"), words)


def test_json_says_the_same(swept):
    written = json.loads((swept.folder / "claims.json").read_text())
    assert (written["interval"], written["level"], written["resamples"]) == (0.95, LEVEL, 9999)
    assert [list(claim) for claim in written["claims"]] == [list(next(iter(swept.claims.values())))] * len(CLAIMS)
    for claim in written["claims"]:
        row = swept.claims[claim["claim"]]
        for key, value in claim.items():
            assert row[key] == ("" if value is None else row[key] if isinstance(value, float) else str(value)), key
            if isinstance(value, float):
                assert float(row[key]) == value, key


def test_the_terminal_says_how_it_was_judged(lab, swept):
    lines = lab.result.stdout.splitlines()
    (at,) = [k for k, line in enumerate(lines) if f"{swept.claims['steeper']['verdict']:10}  steeper:" in line]
    assert f"by paired t, n = {SEEDS}; p " in lines[at + 1] and "Holm" in lines[at + 1]
    assert any("equal within 30" in line for line in lines)
    assert "no data     unknown: claimed above 1" in lines
    assert "95 % intervals; one-sided p at 2.5 %" in lab.result.stdout


def test_members_without_a_measure_are_counted(lab, swept):
    """Some heaps of so few grains have no angle: the table, the claims and the terminal count them."""
    without = {friction: np.isnan(swept.values(friction)) for friction in ("0.5", "0.6")}
    missing = int(without["0.6"].sum())
    assert 0 < missing < SEEDS - 2, "no heap lacks an angle: the test tests nothing"
    row = swept.table["friction=0.6"]
    assert (row[f"{ANGLE}:count"], row[f"{ANGLE}:missing"]) == (str(SEEDS - missing), str(missing))
    claim = swept.claims["steep too"]
    assert (claim["n"], claim["n_missing"]) == (str(SEEDS - missing), str(missing))
    pairs = int((~(without["0.5"] | without["0.6"])).sum())
    claim = swept.claims["alike"]
    assert (claim["test"], claim["n"], claim["n_missing"]) == ("paired t", str(pairs), str(2 * (SEEDS - pairs)))
    with h5py.File(swept.folder / "sweep.h5", "r") as file:
        assert file[f"measures/{ANGLE}/missing"][2] == missing
    assert f"angle [deg] at friction=0.6: {missing} of {SEEDS} finished members have none" in lab.result.stdout
    assert f"by t, n = {SEEDS - missing}, {missing} missing; p " in lab.result.stdout
