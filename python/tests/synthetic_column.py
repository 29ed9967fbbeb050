# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Run and sweep folders of columns between two upright walls, with numbers that a picture can be checked by."""

import json

import h5py
import numpy as np
from synthetic import write_run
from synthetic_analysis import write_group
from synthetic_sweep import write_sweep

WIDTH, HEIGHT, MASS, GRAVITY = 6.0, 12.0, 60.0, 2.0
STRESS_RATIO, FRICTION = 0.75, -0.2
FLOOR = 1.5  # displacement of the floor at the end
ROWS = 40
SCENE = f"gravity = {GRAVITY}\n[output]\nwindow = 15.0\n"


def write_column_run(folder, friction=FRICTION):
    """A block of grains between walls at -3 and 3, whose floor sets out in the middle of the run. The floor carries 100."""
    x, y = np.meshgrid(np.arange(-2.5, 3.0), np.arange(0.5, 12.0))
    moving = np.column_stack([x.ravel(), y.ravel() + FLOOR])
    write_run(folder, moving, floor=True, rows=ROWS, surface=False, gravity=[0.0, -GRAVITY], time=ROWS - 1.0)
    with h5py.File(folder / "run.h5", "a") as file:
        file["scene"] = np.array([SCENE], dtype=h5py.string_dtype())
        del file["walls"]
        write_group(file.create_group("walls"), walls())
        for name in list(file["series"]):
            if name.startswith("wall_"):
                del file[f"series/{name}"]
        write_group(file["series"], wall_series())
    with h5py.File(folder / "analysis.h5", "a") as file:
        file.attrs["time"] = ROWS - 1.0
        write_group(file.create_group("column"), slices(), **measured(friction))
        write_group(file.create_group("column_motion"), motion())
    (folder / "summary.json").write_text(json.dumps({"column": {"top_follows": 0.5}}))
    return folder


def measured(friction):
    return {"width": WIDTH, "height": HEIGHT, "mass": MASS, "stress_ratio": STRESS_RATIO, "friction": friction}


def walls():
    """Left, right, floor, and a shelf above it that is no floor."""
    return {
        "name": np.array([b"left", b"right", b"shelf", b"floor"]),
        "point": np.array([[-3.0, 0.0], [3.0, 0.0], [20.0, 5.0], [0.0, 0.0]]),
        "normal": np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, 1.0]]),
        "half_length": np.array([np.inf, np.inf, 0.5, np.inf]),
        "direction": np.array([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 1.0]]),
        "opens_at": np.full(4, np.inf),
        "rotates": np.zeros(4, dtype=np.uint8),
        "centre": np.zeros((4, 2)),
    }


def wall_series():
    displacement, force = np.zeros((ROWS, 4)), np.zeros((ROWS, 4))
    displacement[ROWS // 2 :, 3] = np.linspace(0.0, FLOOR, ROWS - ROWS // 2)
    force[:, 3] = -100.0 - np.arange(ROWS)
    return {"wall_force_x": np.zeros((ROWS, 4)), "wall_force_y": force, "wall_displacement": displacement}


def slices():
    """Six slices of 2; stresses 1 to 6 from the top, of no law."""
    bottom, stress = 2.0 * np.arange(6), np.arange(6.0, 0.0, -1.0)
    depth = HEIGHT - bottom - 1.0
    columns = {"depth": depth, "bottom": bottom, "top": bottom + 2.0, "stress": stress, "load": 6.0 * stress}
    return {**columns, "pressure": 2.0 * stress, "shear": -0.5 * stress}


def motion():
    time = np.arange(ROWS // 2, ROWS, dtype=float)
    floor = np.linspace(0.0, FLOOR, len(time))
    return {"time": time, "floor": floor, "top": 0.8 * floor, "shortening": 0.2 * floor, "front": np.minimum(12.0, 24.0 * floor)}


def integrated_stress(depth, weight, friction, stress_ratio=STRESS_RATIO, steps=4000):
    """Vertical stress at a depth: the balance of a slice, stepped down from the surface (Heun)."""
    step, stress = depth / steps, 0.0

    def slope(value):
        return weight / (WIDTH * HEIGHT) - 2.0 * friction * stress_ratio * value / WIDTH

    for _ in range(steps):
        first = slope(stress)
        stress += 0.5 * step * (first + slope(stress + step * first))
    return stress


def write_column_sweep(folder, points):
    """Columns at each of the points; friction is FRICTION, -FRICTION, FRICTION, ... The last has no column."""
    names = [f"friction={k / 10}" for k in range(1, points + 1)]
    write_sweep(folder, names, {"contact.friction": [k / 10 for k in range(1, points + 1)]}, profiles=False)
    for name in names:
        (folder / "members" / name / "seed-1" / "scene.toml").write_text(SCENE)
    means = {f"column.{name}": np.full(points, value) for name, value in measured(0.0).items() if name not in ("mass", "stress_ratio")}
    means["column.stress_ratio.mean"] = np.full(points, STRESS_RATIO)
    means["column.friction"] = FRICTION * (-1.0) ** np.arange(points)
    with h5py.File(folder / "sweep.h5", "a") as file:
        set_means(file, means)
        for k in range(points - 1):
            columns = {name: values for name, values in slices().items() if name in ("depth", "stress", "pressure", "shear", "load")}
            columns |= {f"{name}_error": 0.1 * values for name, values in columns.items()}
            write_group(file.create_group(f"columns/{k:04}"), columns, members=4, mass=MASS)
    return folder


def set_means(file, means, error=0.01):
    """Measures of a sweep, by point."""
    for name, values in means.items():
        values = np.asarray(values, dtype=float)
        columns = {"mean": values, "error": np.full(len(values), error), "deviation": np.full(len(values), 2.0 * error)}
        write_group(file.create_group(f"measures/{name}"), {**columns, "count": np.full(len(values), 4)})


def write_heights(folder, scale=1.0):
    """heights.csv and heights.json of a fit pushed up, one where the walls carry, and one that has a problem."""
    lines = ["fit,point,height,mass,mass_error,column_mass,fitted_one,fitted_two"]
    for fit in ("pushed up", "down", "few"):
        factor = scale if fit == "pushed up" else 1.0
        lines += [f"{fit},p{h},{h},{10.0 * factor * h},{'' if h == 8 else h},{4.0 * h},," for h in (2, 4, 8)]
    (folder / "heights.csv").write_text("\n".join(lines) + "\n")
    lengths = {"lambda": 5.0, "lambda_1": 6.0, "lambda_2": 4.0, "ratio": 1.5}
    entries = {name: {"mean": value, "error": 0.12, "low": value, "high": value} for name, value in lengths.items()}
    common = {"problem": "", "mass_per_height": 4.0, "chance_one": 0.25, "chance_two": None, **entries}
    fits = [{"fit": "pushed up", "direction": "pushed-up", **common}, {"fit": "down", "direction": "rest", **common}]
    unknown = {name: {"mean": None, "error": None} for name in lengths}
    fits.append({**common, **unknown, "fit": "few", "direction": "rest", "problem": "too few", "mass_per_height": None})
    (folder / "heights.json").write_text(json.dumps(fits))
