# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sweep folders in the format of docs/reference/sweep.md."""

import h5py
import numpy as np
from synthetic_analysis import write_group

KEYS = ("angle_of_repose_deg.mean", "base_dip.index", "coordination", "max_overlap", "core.solid_fraction")
OFFSET = {"angle_of_repose_deg.mean": 20.0, "base_dip.index": 0.9, "coordination": 4.0}

# Arguments of write_sweep.
FRICTION = {"contact.friction": [0.2, 0.5, 0.4]}
ONE = dict(names=["friction=0.2", "friction=0.5", "friction=0.4"], parameters=FRICTION)
TWO = dict(
    names=[f"friction={f}_spacing={s}" for f in (0.2, 0.3, 0.5) for s in (1.0, 1.1)],
    parameters={"contact.friction": [0.2, 0.2, 0.3, 0.3, 0.5, 0.5], "base.spacing": [1.0, 1.1] * 3},
)
SCENES = dict(
    names=[f"{name}_spacing={s}" for name in ("soft", "n144-long") for s in (1.0, 1.1, 1.2)],
    parameters={"base.spacing": [1.0, 1.1, 1.2] * 2},
)  # the scenes of the points differ by more than the parameters
NAMED = dict(names=["continuous", "a_rather_long_name_of_a_point", "hooke"], parameters={"law": ["a", "b", None]})
SCENE = """gravity = 1.0  # [L/T^2] gravity, along -y

[contact]
friction = 0.5  # Coulomb coefficient mu

[contact.normal]
law = "hooke"  # normal force: continuous, hooke
stiffness = 10000.0  # [M/T^2] spring constant k

[method]
critical_angle = 50.0  # [deg] a disc sticks where its contact is less than this off upright: 0 steepest descent

[base]
spacing = 1.0  # [diameters] between neighbours; 1: they touch
"""  # as the program comments the scene of a member
METHODS = dict(
    names=[f"{name}_critical_angle={angle}" for name in ("deposition", "contact-dynamics") for angle in (0, 50, 90)],
    parameters={"method.critical_angle": [0, 50, 90] * 2, "method.tolerance": [None] * 3 + [1e-3] * 3},
)


def write_sweep(folder, names, parameters=None, members=4, keys=KEYS, profiles=True, units="reduced"):
    """Writes a sweep folder. `parameters`: values of the points by key, None where not set. The measure of point p and
    seed s is OFFSET + p / 10 + (s - mean seed) / 100. The last point has one member, so no error."""
    parameters = parameters or {}
    for name in names[: members and len(names)]:
        place = folder / "members" / name / "seed-1"
        place.mkdir(parents=True)
        (place / "scene.toml").write_text(SCENE)
    folder.mkdir(parents=True, exist_ok=True)
    with h5py.File(folder / "sweep.h5", "w") as file:
        text = {"format": "repose-sweep", "repose_version": "0.1.0", "title": "A synthetic <sweep>", "units": units}
        file.attrs.update({name: np.bytes_(value.encode()) for name, value in text.items()})
        file.attrs["format_version"] = 1
        count = np.full(len(names), members)
        count[-1] = min(1, members)
        finished = {"name": texts(names), "members": count, "failed": np.zeros(len(names), dtype=int)}
        write_group(file.create_group("points"), finished)
        write_group(file.create_group("parameters"), {key: numbers(values) for key, values in parameters.items()})
        written = {key: texts(["" if v is None else str(v) for v in values]) for key, values in parameters.items()}
        write_group(file.create_group("parameter_text"), written)
        point = np.repeat(np.arange(len(names)), count)
        seed = np.concatenate([np.arange(n) + 1 for n in count]) if len(point) else np.empty(0, dtype=int)
        status = texts(["finished"] * len(point))
        write_group(file.create_group("members"), {"point": point, "seed": seed, "status": status})
        file.create_group("measures")
        file.create_group("values")
        for key in keys:
            values = OFFSET.get(key, 0.0) + 0.1 * point + 0.01 * (seed - 0.5 * (count[point] + 1))
            file["values"][key] = values
            write_group(file["measures"].create_group(key), statistics(values, point, len(names)))
        file.create_group("profiles")
        for k in range(len(names) if profiles else 0):
            write_profile(file["profiles"].create_group(f"{k:04}"), k, count[k])
    return folder


def texts(values):
    """Text of fixed length, as the program writes it."""
    length = max([1, *(len(value.encode()) for value in values)])
    return np.array([value.encode() for value in values], dtype=h5py.string_dtype("utf-8", length))


def numbers(values):
    return np.array([value if isinstance(value, (int, float)) else np.nan for value in values], dtype=float)


def statistics(values, point, points):
    columns = {name: np.full(points, np.nan) for name in ("mean", "error", "deviation")}
    columns["count"] = np.bincount(point, minlength=points)
    for k in range(points):
        mine = values[point == k]
        if len(mine):
            columns["mean"][k] = mine.mean()
        if len(mine) > 1:
            columns["deviation"][k] = mine.std(ddof=1)
            columns["error"][k] = columns["deviation"][k] / np.sqrt(len(mine))
    return columns


def write_profile(group, point, members):
    """A cone of 10 + point grain weights and half width 20, with a dip index of 1.1 + point / 10."""
    x = np.arange(-30.0, 31.0)
    write_group(group, profile(x, 10.0 + point))
    group.attrs.update({"members": members, "centre": 0.0, "half_width": 20.0})
    group.attrs.update({"dip_index": 1.1 + 0.1 * point, "dip_index_error": 0.02 if members > 1 else np.nan})
    group.attrs.update({"max_over_centre": 1.2, "max_over_centre_error": 0.03})
    if point != 1:  # as an older program wrote it
        ends = (1.05, 1.15) if members > 1 else (np.nan, np.nan)
        group.attrs.update({"dip_index_low": ends[0], "dip_index_high": ends[1]})
    write_group(group.create_group("binned"), profile(5.0 * np.arange(-6, 7), 10.0 + point), bin_width=5.0)


def profile(x, height):
    normal = height * np.maximum(0.0, 1.0 - np.abs(x) / 20.0)
    shear = 0.2 * normal * np.sign(x)
    return {"x": x, "normal": normal, "normal_error": 0.1 * normal, "shear": shear, "shear_error": 0.02 * normal}
