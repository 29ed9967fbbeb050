# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Species of the grains of a run: by material, and by size where species of one material differ in it."""

from dataclasses import dataclass

import numpy as np

TOLERANCE = 1e-9  # of a diameter


@dataclass(frozen=True)
class Kind:
    """Grains that one colour stands for."""

    name: str
    material: int
    low: float  # [L] smallest diameter
    high: float  # [L] largest


def kinds_of(run):
    """The kinds of grain that a scene describes, and the materials of other grains; "" names the only one."""
    scene = run.scene
    names = [material["name"] for material in scene.get("material", [])] or [""]
    found = set(run.state.grains.material[~run.state.grains.held])
    kinds = []
    for number, name in enumerate(names):
        own = [_kind(each, number, scene) for each in scene.get("species", []) if each.get("material", names[0]) == name]
        kinds += _told_apart(sorted(own, key=lambda kind: kind.low))
        if not own and number in found:
            kinds.append(Kind(name, number, 0.0, np.inf))
    return kinds or [Kind("", 0, 0.0, np.inf)]


def members_of(kinds, grains):
    """Number of the kind of each grain (N): of its material the first that is not too small for it, else the last."""
    number = np.zeros(len(grains), dtype=int)
    for k in reversed(range(len(kinds))):
        last = k == max(j for j, kind in enumerate(kinds) if kind.material == kinds[k].material)
        fits = 2.0 * grains.radius <= kinds[k].high * (1.0 + TOLERANCE)
        number[(grains.material == kinds[k].material) & (last | fits)] = k
    return number


def _kind(species, material, scene):
    sizes = species.get("sizes", {})
    usual = sizes.get("diameter", scene.get("grains", {}).get("diameter", 1.0))
    some = sizes.get("diameters", [usual])
    return Kind(species["name"], material, sizes.get("low", min(some)), sizes.get("high", max(some)))


def _told_apart(kinds):
    """The kinds, in ascending order of size; those whose sizes overlap become one."""
    apart = []
    for kind in kinds:
        if apart and kind.low < apart[-1].high * (1.0 + TOLERANCE):
            last = apart.pop()
            kind = Kind(f"{last.name}, {kind.name}", kind.material, last.low, max(last.high, kind.high))
        apart.append(kind)
    return apart
