# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""analysis.h5 in the format of docs/reference/analysis.md, with numbers that a picture can be checked by."""

import h5py
import numpy as np

BIN = 0.1
HEXAGON = np.array([[np.cos(a), np.sin(a)] for a in np.pi / 6.0 + np.pi / 3.0 * np.arange(6)]) / np.sqrt(3.0)


def write_group(group, columns, **attributes):
    for name, values in columns.items():
        group[name] = values
    group.attrs.update(attributes)


def write_analysis(folder, grains, contacts, diameter, surface=True, track=True, time=120.0):
    """Writes analysis.h5 for the datasets of /grains and /contacts; groups that need a heap are absent without one."""
    moving, centre = grains["fixed"] == 0, grains["position"]
    with h5py.File(folder / "analysis.h5", "w") as file:
        text = {"format": np.bytes_(b"repose-analysis"), "repose_version": np.bytes_(b"0.1.0")}
        file.attrs.update({**text, "format_version": 1, "time": time})
        apex = centre[:, 1].max() / diameter + 0.5 if surface else None
        write_surface(file.create_group("surface"), apex, diameter)
        if not moving.all():
            write_base(file.create_group("base"), centre[~moving, 0], moving.any(), diameter)
        if len(contacts["grains"]):
            write_voronoi(file.create_group("voronoi"), grains["id"][moving], centre[moving], diameter)
            write_forces(file.create_group("forces"))
            write_chains(file.create_group("chains"), contacts)
            write_force_lines(file.create_group("force_lines"), grains, contacts)
            write_stability(file.create_group("stability"), grains["id"][moving], centre[moving])
            write_slips(file)
            write_grain_stress(file.create_group("grain_stress"), grains, diameter)
            write_fields(file.create_group("fields"), centre[moving], diameter)
        if track and moving.any():
            write_motion(file, diameter)


def write_surface(group, apex, diameter):
    """A profile of slope sqrt(3) with a line on the left flank only; `apex` [d] None: no profile."""
    x = np.arange(-8, 9) * diameter if apex else np.empty(0)
    height = (apex or np.nan) * diameter - np.sqrt(3.0) * np.abs(x)
    write_group(
        group,
        {"x": x, "height": height, "used": ((x != 0.0) & (height > 0.0)).astype(np.uint8)},
        bin_width=diameter, base_y=0.0, apex_x=0.0, apex_height=(apex or np.nan) * diameter,
        left_slope=np.sqrt(3.0) if apex else np.nan, left_intercept=(apex or np.nan) * diameter,
        right_slope=np.nan, right_intercept=np.nan,
    )  # fmt: skip


def write_base(group, x, loaded, diameter):
    """Bins of 3 d with an error of a tenth; the first bin has one grain and no error."""
    width = 3.0 * diameter
    centre = width * np.arange(np.ceil(x.min() / width), np.floor(x.max() / width) + 1)
    normal = np.maximum(0.0, 10.0 - np.abs(centre / diameter)) * loaded
    error = np.where(np.arange(len(centre)) == 0, np.nan, 0.1 * normal)
    columns = {"x": centre, "count": np.full(len(centre), 3), "normal": normal, "normal_error": error}
    shear = {"shear": 0.2 * normal * np.sign(centre), "shear_error": 0.2 * error}
    write_group(group, {**columns, **shear}, bin_width=width)


def write_voronoi(group, ids, centre, diameter):
    """Hexagons; the lowest row is closed, with solid fractions that ascend from 0.80 to 0.90."""
    vertices = centre[:, None] + diameter * HEXAGON
    closed = centre[:, 1] < centre[:, 1].min() + 0.1 * diameter
    solid_fraction = np.full(len(ids), 0.5)
    solid_fraction[closed] = np.linspace(0.8, 0.9, closed.sum())
    columns = {
        "id": ids,
        "area": np.full(len(ids), np.sqrt(3.0) / 2.0 * diameter**2),
        "solid_fraction": solid_fraction,
        "closed": closed.astype(np.uint8),
        "offset": 6 * np.arange(len(ids) + 1),
        "vertices": vertices.reshape(-1, 2),
    }
    write_group(group, columns)


def write_grain_stress(group, grains, diameter):
    """A uniform pressure of 2 over the discs."""
    count = len(grains["id"])
    columns = {"id": grains["id"], "area": np.full(count, 0.25 * np.pi * diameter**2), "in_cell": np.zeros(count, np.uint8)}
    stress = {f"stress_{name}": np.full(count, 2.0 if name[0] == name[1] else 0.0) for name in ("xx", "xy", "yx", "yy")}
    write_group(group, {**columns, **stress})


def write_forces(group):
    """P(f) = exp(-f) with an empty bin; directions in twelve bins, the strong ones steep."""
    f = BIN * (np.arange(50) + 0.5)
    density = np.exp(-f)
    density[40] = 0.0
    direction = 15.0 * np.arange(12)
    strong = 1.0 - np.cos(np.radians(2.0 * direction))
    columns = {
        "f": f,
        "density": density,
        "error": 0.1 * density,
        "direction_deg": direction,
        "direction_all": np.full(12, 1.0 / 180.0),
        "direction_strong": strong / (15.0 * strong.sum()),
    }
    write_group(group, columns, mean=2.5, bin_width=BIN)


def write_chains(group, contacts):
    """Every second contact is in one of eight chains, of which the first is the largest."""
    count = len(contacts["grains"])
    chain = np.full(count, -1)
    strong = np.arange(0, count, 2)
    chain[strong] = np.minimum(np.arange(len(strong)) % 16, 15) // 2 * (np.arange(len(strong)) % 3 > 0)
    sizes = np.bincount(chain[strong])
    order = np.argsort(-sizes, kind="stable")
    chain[strong] = np.argsort(order)[chain[strong]]
    sizes = sizes[order]
    extent = np.ones((len(sizes), 2))
    direction = np.full(len(sizes), 60.0)
    columns = {"contacts": sizes, "grains": sizes + 1, "direction_deg": direction, "extent": extent, "chain": chain}
    write_group(group, columns)


def write_force_lines(group, grains, contacts):
    """By the forces of the contacts that have any; of grains that have such contacts."""
    force = contacts["normal_force"]
    rows = {}
    for row in np.flatnonzero(force > 0.0):
        for k in contacts["grains"][row]:
            rows.setdefault(int(k), []).append(row)
    ids = [int(k) for k, fixed in zip(grains["id"], grains["fixed"]) if not fixed and int(k) in rows]
    strongest = np.array([max(rows[k], key=lambda row: force[row]) for k in ids])
    weakest = np.array([min(rows[k], key=lambda row: force[row]) for k in ids])
    columns = {"id": ids, "strongest": strongest, "weakest": weakest}
    forces = {"strongest_force": force[strongest], "weakest_force": force[weakest]}
    write_group(group, {**columns, **forces}, horizontal_within=15.0)


def write_stability(group, ids, centre):
    """An unstable mode that moves grains to the left, the more the higher they are."""
    sway = centre[:, 1] / centre[:, 1].max()
    write_group(group, {"id": ids, "displacement": np.column_stack([-sway, np.zeros(len(sway))])}, smallest=-2.5)


def write_slips(file):
    """Three slips of a saw, the drops 4, 2 and 1, with a law that begins at the least of them."""
    time = np.arange(12.0)
    force = np.array([5.0, 6, 2, 3, 4, 2, 3, 4, 3, 4, 5, 6])
    write_group(file.create_group("drive"), {"time": time, "force": force, "displacement": 0.1 * time})
    begin, end = np.array([1.0, 4.0, 7.0]), np.array([2.0, 5.0, 8.0])
    drop = np.array([4.0, 2.0, 1.0])
    waiting = np.array([np.nan, 2.0, 2.0])
    columns = {"begin": begin, "end": end, "force": [6.0, 4.0, 4.0], "drop": drop, "slide": drop, "waiting": waiting}
    group = file.create_group("slips")
    write_group(group, {**columns, "creep": waiting}, mean_force=4.0, x_min=1.0, exponent=2.0)
    group.attrs.update({"wall": np.bytes_(b"piston"), "verdict": np.bytes_(b"undecided: 3 events")})


def write_fields(group, centre, diameter):
    """A stress that grows downwards within a triangle, its major axis 60 degrees from the horizontal."""
    cell = 0.75 * diameter
    (left, low), (right, high) = centre.min(axis=0) - 3.0 * diameter, centre.max(axis=0) + 3.0 * diameter
    x, y = np.arange(left, right, cell), np.arange(low, high, cell)
    top = centre[:, 1].max()
    half = 0.5 * (right - left) - 3.0 * diameter + 0.5 * diameter
    depth = top - y[:, None] - np.abs(x[None] - 0.5 * (left + right)) * (top - low) / max(half, diameter)
    solid_fraction = np.where((depth > 0.0) & (y[:, None] > low + diameter), 0.85, 0.0)
    pressure = np.where(solid_fraction > 0.0, depth / diameter, 0.0)
    deviator, angle = 0.3 * pressure, np.radians(60.0)
    columns = {
        "x": x,
        "y": y,
        "room": np.ones_like(solid_fraction),
        "density": solid_fraction,
        "solid_fraction": solid_fraction,
        "stress_xx": pressure + deviator * np.cos(2.0 * angle),
        "stress_xy": deviator * np.sin(2.0 * angle),
        "stress_yx": deviator * np.sin(2.0 * angle),
        "stress_yy": pressure - deviator * np.cos(2.0 * angle),
        "support_x": np.zeros_like(pressure),
        "support_y": np.zeros_like(pressure),
        "velocity_x": depth / diameter,
        "velocity_y": np.zeros_like(pressure),
        "temperature": np.where(solid_fraction > 0.0, 0.25, np.nan),
        "contacts": 2.0 * solid_fraction,
        "fabric_xx": np.full_like(pressure, 0.25),
        "fabric_xy": np.zeros_like(pressure),
        "fabric_yy": np.full_like(pressure, 0.75),
        "coordination": np.full_like(pressure, 4.0),
    }
    write_group(group, columns, width=1.5 * diameter, cell=cell)


def write_motion(file, diameter):
    """Sixty intervals; avalanches of 12 and 30 grains."""
    end = 2.0 * np.arange(1, 61)
    moved = np.zeros(60, dtype=int)
    moved[10:12], moved[40:45] = 11, 18
    columns = {
        "start": end - 2.0,
        "end": end,
        "grains": np.arange(60),
        "moved": moved,
        "moved_left": moved // 2,
        "depth": np.where(moved > 0, 2.0 * diameter, np.nan),
        "kinetic_energy": 1.0 * moved,
        "angle_left": np.where(end > 20.0, 30.0, np.nan),
        "angle_right": np.where(end > 20.0, 25.0, np.nan),
    }
    write_group(file.create_group("motion"), columns)
    times = {
        "start": np.array([20.0, 80.0]),
        "end": np.array([24.0, 90.0]),
        "duration": np.array([4.0, 10.0]),
        "waiting": np.array([np.nan, 56.0]),
    }
    sizes = {"size": np.array([12, 30]), "depth": np.full(2, 2.0 * diameter), "left": np.full(2, 0.5)}
    write_group(file.create_group("avalanches"), {**times, **sizes}, interval=2.0, least=10)
    write_group(file.create_group("bursts"), {**times, "peak": np.array([8.0, 9.0])}, threshold=5.0)
