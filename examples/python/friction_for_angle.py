# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The friction at which small heaps of discs have an angle of repose of 30 degrees: docs/tutorial/python.md."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np

import repose

WANTED = 30.0  # degrees
FRICTIONS = [0.1, 0.2, 0.3, 0.4]
SEEDS = range(1, 9)


def heap(friction: float, seed: int) -> repose.Scene:
    """200 discs of linear springs that resist rolling, poured gently onto a row of fixed discs."""
    scene = repose.Scene(
        {
            "seed": seed,
            "grains": {"polydispersity": 0.3},
            "base": {"kind": "row", "half_width": 25.0},
            "source": {"kind": "pour", "count": 200, "rate": 2.0, "height": 3.0, "height_above": "apex", "half_width": 1.0},
            "stop": {"at_rest": 1e-4, "time": 400.0},
        }
    )
    scene.contact.friction = friction
    scene["contact.normal"] = {"law": "hooke", "stiffness": 1e4, "damping": 0.5}
    scene["contact.tangential"] = {"law": "linear", "stiffness": 5e3, "damping": 0.2}
    scene["contact.rolling"] = {"law": "spring", "friction": 0.2}
    return scene


def angle(friction: float, seed: int) -> float:
    """Angle of repose [degrees] of one heap."""
    simulation = repose.Simulation(heap(friction, seed))
    simulation.run()
    return simulation.measures()["angle_of_repose_deg.mean"]


def crossing(means: list[float], errors: list[float]) -> tuple[float, float]:
    """The friction between two neighbours whose angles lie on both sides of the wanted one, and its standard error; NaN
    where there are none."""
    for k in range(len(means) - 1):
        slope = (means[k + 1] - means[k]) / (FRICTIONS[k + 1] - FRICTIONS[k])
        if (means[k] - WANTED) * (means[k + 1] - WANTED) <= 0.0 and slope != 0.0:
            part = (WANTED - means[k]) / (means[k + 1] - means[k])
            error = np.hypot((1.0 - part) * errors[k], part * errors[k + 1])
            return FRICTIONS[k] + (WANTED - means[k]) / slope, error / abs(slope)
    return np.nan, np.nan


def main() -> None:
    """Prints the angles with their standard errors, and the friction that has the wanted one."""
    means, errors = [], []
    with ThreadPoolExecutor() as pool:  # simulations run side by side: they leave Python free
        for friction in FRICTIONS:
            angles = np.array(list(pool.map(lambda seed, mu=friction: angle(mu, seed), SEEDS)))
            means.append(float(angles.mean()))
            errors.append(float(angles.std(ddof=1) / np.sqrt(len(angles))))
            print(f"friction {friction:.1f}: {means[-1]:.1f} +- {errors[-1]:.1f} degrees")
    friction, error = crossing(means, errors)
    print(f"{WANTED:g} degrees at a friction of {friction:.2f} +- {error:.2f}")


if __name__ == "__main__":
    main()
