# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The published numbers of a heap computed a second time, from run.h5 by numpy alone, by the definitions of
docs/reference/summary.md and analysis.md. Nothing is shared with the analysis but these definitions."""

import math

import h5py
import numpy as np
import pytest
from conftest import datasets, summary

SCENE = """[base]
kind = "row"
half_width = 20
[source]
kind = "pour"
count = 150
rate = 1.0
height = 15
half_width = 3
[stop]
at_rest = 1e-5
time = 600
"""


@pytest.fixture(scope="module")
def reading(tmp_path_factory):
    from conftest import Laboratory

    out = Laboratory(tmp_path_factory.mktemp("reading")).run(SCENE)
    raw = {name.lstrip("/"): x for name, x in datasets(out / "run.h5").items() if not name.startswith("/analysis/")}
    with h5py.File(out / "run.h5") as file:
        raw["weight"] = float(file.attrs["grain_weight"])
    return raw, summary(out), datasets(out / "analysis.h5")


def counted(raw):
    """Rows of the contacts that count: above 0.2 grain weights."""
    return raw["contacts/normal_force"] > 0.2 * raw["weight"]


def test_contacts_and_fabric(reading):
    raw, found, _ = reading
    rows = counted(raw)
    pairs, normal = raw["contacts/grains"][rows], raw["contacts/normal"][rows]
    assert found["contacts"] == rows.sum()
    tensor = normal.T @ normal / len(normal)
    low, high = np.linalg.eigvalsh(tensor)
    assert found["anisotropy"] == pytest.approx(2.0 * (high - low), rel=1e-9)
    axis = np.linalg.eigh(tensor)[1][:, 1]
    angle = math.degrees(math.atan2(axis[1], axis[0]))
    assert (found["fabric_direction_deg"] - angle + 90.0) % 180.0 - 90.0 == pytest.approx(0.0, abs=1e-6)
    # All grains of this heap touch something.
    ids = raw["grains/id"][raw["grains/fixed"] == 0]
    partners = np.array([(pairs == k).sum() for k in ids])
    assert found["coordination"] == pytest.approx(partners.mean(), rel=1e-12)
    fractions = [(np.minimum(partners, 6) == k).mean() for k in range(7)]
    assert found["connectivity"] == pytest.approx(fractions, abs=1e-12)


def test_force_statistics(reading):
    raw, found, analysis = reading
    force = raw["contacts/normal_force"][counted(raw)]
    mean = force.mean()
    assert found["forces"]["mean"] == pytest.approx(mean / raw["weight"], rel=1e-12)
    assert found["forces"]["strong_fraction"] == pytest.approx((force > mean).mean(), rel=1e-12)
    centres, density = analysis["/forces/f"], analysis["/forces/density"]
    width = np.diff(centres).mean()
    edges = np.append(centres - 0.5 * width, centres[-1] + 0.5 * width)
    assert edges[0] == pytest.approx(0.2 * raw["weight"] / mean, rel=1e-9)
    again = np.histogram(force / mean, edges)[0] / (len(force) * width)
    # A force within rounding of an edge may fall on either side.
    one = 1.0 / (len(force) * width)
    assert np.abs(again - density).max() < 1.01 * one and np.abs(again - density).sum() < 3.0 * one


def test_base_forces(reading):
    raw, found, _ = reading
    x, normal = raw["base/x"], raw["base/normal"]
    weight = raw["grains/mass"][raw["grains/fixed"] == 0].sum() / (raw["weight"])
    assert normal.sum() == pytest.approx(weight, rel=1e-6)  # gravity is 1
    padded = [normal[max(0, k - 2):k + 3].mean() for k in range(len(normal))]
    loaded = x[np.array(padded) > 0.1 * max(padded)]
    centre, half = 0.5 * (loaded[0] + loaded[-1]), 0.5 * (loaded[-1] - loaded[0])
    assert found["base_dip"]["centre"] == pytest.approx(centre) and found["base_dip"]["half_width"] == pytest.approx(half)
    far = np.abs(x - centre) / half
    index = normal[(far >= 0.15) & (far <= 0.45)].mean() / normal[far < 0.15].mean()
    assert found["base_dip"]["index"] == pytest.approx(index, rel=1e-9)


def test_surface_and_angle(reading):
    raw, found, analysis = reading
    free = raw["grains/fixed"] == 0
    place, radius = raw["grains/position"][free], raw["grains/radius"][free]
    base = raw["grains/position"][~free][:, 1].mean()
    tops = place[:, 1] + radius - base
    assert found["heap_height"] == pytest.approx(tops.max(), rel=1e-12)
    bins = np.floor(place[:, 0] / 2.0)
    heights = {2.0 * k + 1.0: tops[bins == k].max() for k in np.unique(bins)}
    for x, height in zip(analysis["/surface/x"], analysis["/surface/height"]):
        assert heights[x] == pytest.approx(height, rel=1e-12)
    apex = max(heights, key=heights.get)
    for side, sign in (("left", -1.0), ("right", 1.0)):
        used = [x for x, flag in zip(analysis["/surface/x"], analysis["/surface/used"]) if flag and sign * (x - apex) >= 0]
        slope = np.polyfit(used, [heights[x] for x in used], 1)[0]
        assert found["angle_of_repose_deg"][side] == pytest.approx(math.degrees(math.atan(-sign * slope)), abs=1e-6)
    mean = place - place.mean(axis=0)
    moments = math.degrees(math.atan((place[:, 1] - base).mean() / np.abs(mean[:, 0]).mean()))
    assert found["angle_of_repose_deg"]["moments"] == pytest.approx(moments, abs=1e-9)


# The integral of the coarse-grained stress is the sum of force times branch over all contacts.
def test_integral_of_the_stress(reading):
    raw, _, analysis = reading
    ids = {k: n for n, k in enumerate(raw["grains/id"])}
    place, fixed = raw["grains/position"], raw["grains/fixed"]
    total = np.zeros((2, 2))
    for (a, b), normal, push, shear, lever in zip(raw["contacts/grains"], raw["contacts/normal"], raw["contacts/normal_force"],
                                                  raw["contacts/tangential_force"], raw["contacts/lever"]):
        force = push * normal + shear * np.array([-normal[1], normal[0]])
        branch = place[ids[a]] - place[ids[b]]
        free = [not fixed[ids[k]] for k in (a, b)]
        # A fixed grain bears no stress: the branch of its contact is the part of the other grain.
        part = branch if all(free) else (normal * lever if free[0] else normal * (np.linalg.norm(branch) - lever))
        total += np.outer(force, part)
    area = (analysis["/fields/x"][1] - analysis["/fields/x"][0]) ** 2
    for i, j, name in ((0, 0, "xx"), (0, 1, "xy"), (1, 0, "yx"), (1, 1, "yy")):
        assert analysis[f"/fields/stress_{name}"].sum() * area == pytest.approx(total[i, j], rel=1e-3, abs=1e-3 * total[1, 1])
