# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run folders of spheres in the format of docs/reference/run-folder.md, of spheres on a lattice, without a simulation."""

import json

import h5py
import numpy as np
from synthetic import REACH, write_energy, write_series
from synthetic_analysis import write_group, write_motion, write_slips

LAYER = np.sqrt(0.5)  # [d] between square layers of a face-centred cubic lattice
SLOPE = 0.6  # of the synthetic cone
AXIS = np.array([0.25, -0.1])  # [d] of the heap
SECTORS = np.array([0.4, -0.4] * 4)  # [d] of the surface in sectors above its mean


def square_layer(half_width, height, shift=0.0):
    """Centres (N, 3) [d] of a square layer of touching spheres."""
    at = np.arange(-half_width, half_width + 1) + shift
    x, y = np.meshgrid(at, at, indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), np.full(x.size, height)])


def cone(height):
    """Centres (N, 3) [d] of a face-centred cubic cone on a square base at height 0; no sphere lies on its axis alone."""
    layers = []
    for k in range(1, int(height / LAYER) + 1):
        layer = square_layer(int(height / SLOPE) + 1, k * LAYER, 0.5 * (k % 2))
        layers.append(layer[np.hypot(*layer[:, :2].T) < (height - k * LAYER) / SLOPE])
    return np.concatenate(layers)


def contacts_of(centre, radius, fixed, ids, period):
    """Datasets of /contacts for all pairs closer than REACH; the force grows downwards, with a tenth of it along x as shear."""
    first, second, apart = [], [], []
    order = np.argsort(centre[:, 2], kind="stable")
    levels = centre[order, 2]
    for i in range(len(centre)):
        lower, upper = np.searchsorted(levels, centre[i, 2] + np.array([-1.1, 1.1]) * 2.0 * radius.max())
        others = order[lower:upper]
        others = others[(others > i) & ~(fixed[i] & fixed[others])]
        line = centre[i] - centre[others]
        if period:
            line[:, :2] -= period * np.round(line[:, :2] / period)
        near = np.linalg.norm(line, axis=1) < REACH * (radius[i] + radius[others])
        first += [i] * near.sum()
        second += others[near].tolist()
        apart += line[near].tolist()
    first, second = np.array(first, dtype=int), np.array(second, dtype=int)
    apart = np.array(apart).reshape(-1, 3)
    distance = np.linalg.norm(apart, axis=1)
    normal = apart / distance[:, None]
    depth = centre[:, 2].max(initial=0.0) - 0.5 * (centre[first, 2] + centre[second, 2])
    force = (0.2 + depth) * np.abs(normal[:, 2])
    return {
        "grains": np.column_stack([ids[first], ids[second]]).astype(np.int64),
        "normal": normal,
        "point": centre[first] - normal * radius[first, None],
        "overlap": radius[first] + radius[second] - distance,
        "normal_force": force,
        "tangential_force": 0.1 * force[:, None] * np.array([1.0, 0.0, 0.0]),
        "history": np.zeros((len(first), 3)),
        "sliding": (np.arange(len(first)) % 7 == 0).astype(np.uint8),
    }


def walls_of(*rows):
    """Datasets of /walls; each row has at least a name, a point [d] and a normal."""
    usual = {"half_length": np.inf, "opens_at": np.inf, "rotates": 0, "open": 0, "direction": np.zeros(3)}
    usual |= {"centre": np.zeros(3), "shape": "disc", "side": np.zeros(3), "corners": np.zeros((3, 2)), "axis": np.zeros(3)}
    whole = [usual | row | {"position": row["point"]} for row in rows]
    walls = {name: np.array([np.asarray(row[name]) for row in whole]) for name in whole[0] if name not in ("name", "shape")}
    walls["rotates"] = walls["rotates"].astype(np.uint8)
    return walls | {name: np.array([row[name].encode() for row in whole]) for name in ("name", "shape")}


def write_spheres(
    folder, moving, base=None, diameter=1.0, period=None, walls=None, analysis=True, rows=40, forces=True, **attributes
):
    """Writes a run folder of spheres with its analysis; `moving` and `base` are centres in diameters, as is `period` of both
    level axes. From the fifth sphere on every third id is missing. `attributes` replace those of run.h5."""
    base = np.empty((0, 3)) if base is None else base
    centre = np.concatenate([base, moving.reshape(-1, 3)])
    radius = np.full(len(centre), 0.5)
    fixed = np.arange(len(centre)) < len(base)
    ids = np.arange(len(centre)) + np.maximum(0, np.arange(len(centre)) - 4) // 2
    contacts = contacts_of(centre, radius, fixed, ids, period)
    for name in ("overlap", "history", "point"):
        contacts[name] = contacts[name] * diameter
    if not forces:
        contacts = {name: contacts[name] for name in ("grains", "normal", "point", "overlap")}
    grains = {
        "id": ids.astype(np.int64), "position": centre * diameter, "velocity": np.zeros_like(centre), "spin": np.zeros_like(centre),
        "radius": radius * diameter, "mass": np.ones(len(centre)), "fixed": fixed.astype(np.uint8), "base": fixed.astype(np.uint8),
        "material": np.zeros(len(centre), dtype=np.uint16),
    }  # fmt: skip
    half = (period or 100.0) / 2.0 * diameter
    header = {
        "format": "repose-run", "format_version": 4, "title": "A synthetic cone", "method": "soft",
        "units": "reduced", "dimension": 3, "seed": 1, "time": 120.0, "steps": 120000, "time_step": 1e-3,
        "status": "finished", "message": "at rest", "repose_version": "0.1.0", "gravity": [0.0, 0.0, -1.0],
        "grain_diameter": diameter, "grain_weight": 1.0, "periodic": int(period is not None), "x_min": -half, "x_max": half,
        "periodic_y": int(period is not None), "y_min": -half, "y_max": half, **attributes,
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
        if walls is not None:
            write_group(file.create_group("walls"), walls)
            push = {f"wall_force_{axis}": np.tile(-3.0 * (axis == "z"), (rows, len(walls["name"]))) for axis in "xyz"}
            write_group(file["series"], {**push, "wall_displacement": np.zeros((rows, len(walls["name"])))})
            write_energy(file.create_group("energy"), rows)
        if len(base):
            load = base_load(centre[fixed], len(moving))
            columns = {"id": ids[fixed].astype(np.int64), "x": centre[fixed, 0] * diameter, "y": centre[fixed, 1] * diameter}
            write_group(file.create_group("base"), {**columns, **load}, window_start=110.0, window_end=120.0)
    if analysis:
        write_analysis(folder, ids[~fixed], centre[~fixed], diameter, header["grain_weight"])
    dip = {"index": 1.04, "index_error": 0.02} if len(base) and len(moving) else None
    (folder / "summary.json").write_text(json.dumps({"base_dip": dip, "forces": {"mean": 2.5, "strong_fraction": 0.4}}))
    return folder


def base_load(centre, moving):
    """Forces on base spheres: a cone of 10 grain weights with a dip, and shear outwards."""
    r = np.hypot(*centre[:, :2].T)
    normal = np.maximum(0.0, 10.0 - r) * (1.0 - 0.3 * np.exp(-((r / 3.0) ** 2))) * (moving > 0)
    outwards = centre[:, :2] / np.maximum(r, 1e-9)[:, None]
    return {"normal": normal, "shear": 0.2 * normal * outwards[:, 0], "shear_y": 0.2 * normal * outwards[:, 1]}


def write_analysis(folder, ids, centre, diameter, weight, time=120.0):
    """Writes analysis.h5 for moving spheres: a cone of height 6 d and slope SLOPE, whatever they are."""
    with h5py.File(folder / "analysis.h5", "w") as file:
        text = {"format": np.bytes_(b"repose-analysis"), "repose_version": np.bytes_(b"0.1.0")}
        file.attrs.update({**text, "format_version": 1, "time": time})
        height, foot = 6.0 * diameter, 6.0 * diameter / SLOPE
        r = diameter * (np.arange(int(foot / diameter)) + 0.5)
        columns = {"r": r, "height": height - SLOPE * r}
        columns["sector_height"] = columns["height"][:, None] + SECTORS * diameter
        line = dict(slope=-SLOPE, intercept=height, angle_deg=np.degrees(np.arctan(SLOPE)))
        used = ((r > diameter) & (r < 0.9 * foot)).astype(np.uint8)
        apex = dict(axis_x=AXIS[0] * diameter, axis_y=AXIS[1] * diameter, apex_height=height)
        write_group(file.create_group("cone_surface"), {**columns, "used": used}, **line, **apex)
        angle = 31.0 + np.array([0.5, -0.5, 1.0, -1.0, 0.3, -0.3, 0.8, np.nan])
        write_group(file.create_group("cone_sectors"), {"azimuth_deg": 22.5 + 45.0 * np.arange(8), "angle_deg": angle})
        write_rings(file.create_group("base_rings"), r, diameter, foot)
        write_cells(file.create_group("base_cells"), diameter, foot)
        write_fields(file.create_group("axial_fields"), r, diameter, height)
        f = 0.1 * (np.arange(50) + 0.5)
        cosine = (np.arange(20) + 0.5) / 20.0
        forces = {"f": f, "density": np.exp(-f), "error": 0.1 * np.exp(-f), "direction_cosine": cosine}
        forces |= {"direction_all": np.ones(20), "direction_strong": 2.0 * cosine}
        write_group(file.create_group("forces"), forces, mean=2.5 * weight, bin_width=0.1)
        at = 0.05 * diameter * (np.arange(80) + 0.5)
        pairs = 1.0 + np.sin(6.0 * at / diameter) * np.exp(-at / diameter)
        write_group(file.create_group("pair_correlation"), {"r": at, "g": pairs, "error": 0.05 * pairs})
        write_group(file.create_group("structure_factor"), {"q": 4.0 * at, "s": pairs, "error": 0.05 * pairs})
        if len(ids):
            solid_fraction = np.linspace(0.5, 0.7, len(ids))
            cells = {"id": ids, "volume": np.full(len(ids), diameter**3), "solid_fraction": solid_fraction}
            write_group(file.create_group("voronoi"), {**cells, "closed": (np.arange(len(ids)) % 3 > 0).astype(np.uint8)})
        write_slips(file)
        if len(centre):
            write_motion(file, diameter)


def write_rings(group, r, diameter, foot):
    """Pressure (1 - r/foot) with a dip of 25 % at the axis; the last load is the sum of all."""
    pressure = 4.0 * (1.0 - r / foot) * (1.0 - 0.5 * np.exp(-((r / (2.0 * diameter)) ** 2)))
    half = 0.5 * diameter
    area = np.pi * ((r + half) ** 2 - (r - half) ** 2)
    columns = {"r": r, "inner": r - half, "outer": r + half, "count": np.arange(1, len(r) + 1), "pressure": pressure}
    columns |= {"pressure_error": 0.1 * pressure, "shear": 0.2 * pressure, "shear_error": 0.02 * pressure}
    columns["pressure_error"][0] = np.nan
    write_group(group, {**columns, "load": np.cumsum(pressure * area)}, width=diameter)


def write_cells(group, diameter, foot):
    """A cone of pressure on cells of 2 diameters, one of which lies at the origin, and shear outwards; a sphere far away."""
    at = 2.0 * diameter * np.arange(-6, 7)
    x, y = (values.ravel() for values in np.meshgrid(at, at, indexing="ij"))
    r = np.hypot(x, y)
    inside = r < foot
    x, y, r = (np.append(values[inside], far * diameter) for values, far in ((x, 60.0), (y, 0.0), (r, 60.0)))
    pressure = np.maximum(0.01, 4.0 * (1.0 - r / foot))
    outwards = 0.2 * pressure / np.maximum(r, diameter)
    columns = {"x": x, "y": y, "count": np.full(len(x), 3), "pressure": pressure, "shear_x": outwards * x, "shear_y": outwards * y}
    write_group(group, columns, side_x=2.0 * diameter, side_y=2.0 * diameter, load=4.0 * diameter**2 * pressure.sum())


def write_fields(group, r, diameter, height):
    """A stress that grows with the depth below the surface of the cone; nothing above it."""
    z = diameter * (np.arange(int(height / diameter)) + 0.5)
    depth = height - SLOPE * r[None] - z[:, None]
    inside = depth > 0.0
    depth = np.where(inside, depth / diameter, 0.0)
    columns = {"solid_fraction": 0.6 * inside, "density": 1.1 * inside, "stress_zz": 0.9 * depth, "stress_rr": 0.5 * depth}
    columns |= {"stress_tt": 0.4 * depth, "stress_rz": 0.2 * depth * r[None] / height}
    write_group(group, {"r": r, "z": z, **columns}, ring=diameter, layer=diameter)
