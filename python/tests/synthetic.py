# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run folders in the format of docs/reference/run-folder.md, of grains on a lattice, without a simulation."""

import json

import h5py
import numpy as np
from synthetic_analysis import write_analysis, write_group

ROW = np.sqrt(3.0) / 2.0  # [d] between the rows of a triangular lattice
REACH = 1.02  # [mean diameters] of the pairs listed as contacts


def pyramid(rows):
    """Centres (N, 2) [d] of a triangular heap on a base at height 0, one grain missing inside."""
    points = [((k - 0.5 * (rows - row - 1)), (row + 1) * ROW) for row in range(rows) for k in range(rows - row)]
    del points[rows + rows // 2]
    return np.array(points)


def base_row(half_width, shift=0.0):
    """Centres (B, 2) [d] of a base, one of them at x = shift + 1/2."""
    x = np.arange(-half_width, half_width) + 0.5 + shift
    return np.column_stack([x, np.zeros(len(x))])


def contacts_of(centre, radius, fixed, ids, period):
    """Datasets of /contacts for all pairs closer than REACH, with forces that grow downwards."""
    apart = centre[:, None] - centre[None]
    if period:
        apart[..., 0] -= period * np.round(apart[..., 0] / period)
    distance = np.hypot(apart[..., 0], apart[..., 1])
    mean = radius[:, None] + radius[None]
    first, second = np.nonzero(np.triu(distance < REACH * mean, 1) & ~(fixed[:, None] & fixed[None]))
    depth = centre[:, 1].max(initial=0.0) - 0.5 * (centre[first, 1] + centre[second, 1])
    normal = apart[first, second] / distance[first, second, None]
    force = (0.2 + depth) * np.abs(normal[:, 1])
    return {
        "grains": np.column_stack([ids[first], ids[second]]).astype(np.int64),
        "normal": normal,
        "overlap": (mean - distance)[first, second],
        "normal_force": force,
        "tangential_force": 0.1 * force,
        "history": np.zeros(len(first)),
        "sliding": (np.arange(len(first)) % 7 == 0).astype(np.uint8),
    }


def with_floor(contacts, centre, radius, ids):
    """The contacts, and one with wall 0 at height 0 for each grain that touches it."""
    low = np.flatnonzero(centre[:, 1] - radius < 0.02)
    more = {
        "grains": np.column_stack([ids[low], np.full(len(low), -1)]),
        "normal": np.tile([0.0, 1.0], (len(low), 1)),
        "overlap": radius[low] - centre[low, 1],
        "normal_force": np.full(len(low), 3.0),
        "tangential_force": np.zeros(len(low)),
        "history": np.zeros(len(low)),
        "sliding": np.zeros(len(low), dtype=np.uint8),
    }
    return {name: np.concatenate([contacts[name], more[name]]) for name in contacts}


def write_run(
    folder, moving, base=None, diameter=1.0, period=None, floor=False, surface=True, rows=40, track=True, **attributes
):
    """Writes a run folder with its analysis; `moving` and `base` are centres in diameters, as is `period`.

    From the fifth grain on every third id is missing. `attributes` replace those of run.h5.
    """
    base = np.empty((0, 2)) if base is None else base
    centre = np.concatenate([base, moving.reshape(-1, 2)])
    radius = np.full(len(centre), 0.5)
    fixed = np.arange(len(centre)) < len(base)
    ids = np.arange(len(centre)) + np.maximum(0, np.arange(len(centre)) - 4) // 2
    contacts = contacts_of(centre, radius, fixed, ids, period)
    if floor:
        contacts = with_floor(contacts, centre, radius, ids)
    for name in ("overlap", "history"):
        contacts[name] = contacts[name] * diameter
    grains = {
        "id": ids.astype(np.int64),
        "position": centre * diameter,
        "velocity": np.zeros_like(centre),
        "spin": np.zeros(len(centre)),
        "radius": radius * diameter,
        "mass": np.ones(len(centre)),
        "fixed": fixed.astype(np.uint8),
        "base": fixed.astype(np.uint8),
        "material": np.zeros(len(centre), dtype=np.uint16),
    }
    half = (period or 100.0) / 2.0 * diameter
    header = {
        "format": "repose-run", "format_version": 4, "title": "A synthetic <heap>", "method": "soft",
        "units": "reduced", "dimension": 2, "seed": 1, "time": 120.0, "steps": 120000, "time_step": 1e-3,
        "status": "finished", "message": "at rest", "repose_version": "0.1.0", "gravity": [0.0, -1.0],
        "grain_diameter": diameter, "grain_weight": 1.0, "periodic": int(period is not None),
        "x_min": -half, "x_max": half, **attributes,
    }  # fmt: skip
    (folder / "frames").mkdir(parents=True)
    with h5py.File(folder / "frames" / "000000.h5", "w") as file:
        file.attrs.update({"time": 60.0, "steps": 60000})
        write_group(file.create_group("grains"), grains)
        write_group(file.create_group("contacts"), contacts)
    with h5py.File(folder / "run.h5", "w") as file:
        file.attrs.update({name: np.bytes_(x.encode()) if isinstance(x, str) else x for name, x in header.items()})
        write_group(file.create_group("grains"), grains)
        write_group(file.create_group("contacts"), contacts)
        write_series(file.create_group("series"), rows, len(moving))
        file["frames/000000"] = h5py.ExternalLink("frames/000000.h5", "/")
        if floor:
            walls = {"point": np.zeros((1, 2)), "normal": np.array([[0.0, 1.0]]), "half_length": np.array([np.inf])}
            walls |= {"name": np.array([b"floor"]), "direction": np.zeros((1, 2)), "opens_at": np.array([np.inf])}
            walls |= {"rotates": np.zeros(1, dtype=np.uint8), "centre": np.zeros((1, 2))}
            write_group(file.create_group("walls"), walls)
            write_wall_series(file["series"], rows)
            write_energy(file.create_group("energy"), rows)
        if len(base):
            write_base(file.create_group("base"), centre[fixed, 0] * diameter, ids[fixed], len(moving))
    write_analysis(folder, grains, contacts, diameter, surface, track)
    dip = {"index": 1.04, "centre": 0.0, "half_width": 9.0 * diameter} if len(base) and len(moving) else None
    forces = {"mean": 2.5, "strong_fraction": 0.4, "sliding_fraction": 0.05}
    (folder / "summary.json").write_text(json.dumps({"base_dip": dip, "forces": forces}))
    return folder


def write_series(group, rows, grains):
    time = np.arange(rows, dtype=float)
    columns = {
        "time": time,
        "grains": np.minimum(grains, 10 * np.arange(rows)),
        "contacts": np.arange(rows),
        "kinetic_energy_per_grain": np.exp(-time) if grains else np.zeros(rows),
        "force_residual": np.exp(-0.5 * time) if grains else np.zeros(rows),
        "max_overlap": np.full(rows, 0.01),
    }
    write_group(group, columns)


def write_wall_series(group, rows):
    """A fixed wall that carries 3 grain weights."""
    push = {"wall_force_x": np.zeros((rows, 1)), "wall_force_y": np.full((rows, 1), -3.0)}
    write_group(group, {**push, "wall_displacement": np.zeros((rows, 1))})


def write_energy(group, rows):
    names = "kinetic gravitational elastic sources lost walls_work loads_work damping friction walls drag error".split()
    columns = {name: np.linspace(0.0, k, rows) for k, name in enumerate(names)}
    write_group(group, {"time": np.arange(rows, dtype=float), **columns})


def write_base(group, x, ids, moving):
    load = np.maximum(0.0, 10.0 - np.abs(x / (x[1] - x[0]))) * (moving > 0)
    columns = {"id": ids.astype(np.int64), "x": x, "normal": load, "shear": 0.2 * load * np.sign(x)}
    write_group(group, columns, window_start=110.0, window_end=120.0)
