# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a run: each is a function of a RunFolder and a State that returns a figure or raises NotDrawn."""

from repose.pictures.run import (
    avalanches,
    base,
    budget,
    chains,
    correlations,
    density,
    directions,
    energy,
    flow,
    force_distribution,
    forces,
    heap,
    packing,
    stress,
    surface,
    theory,
    voronoi,
    walls,
)

RUN_PICTURES = {
    "heap": heap.draw,
    "density": density.draw,
    "forces": forces.draw,
    "chains": chains.draw,
    "force_distribution": force_distribution.draw,
    "voronoi": voronoi.draw,
    "stress": stress.draw,
    "velocity": flow.draw_velocity,
    "temperature": flow.draw_temperature,
    "base": base.draw,
    "avalanches": avalanches.draw,
    "energy": energy.draw,
    "budget": budget.draw,
    "walls": walls.draw,
    "packing": packing.draw,
    "directions": directions.draw,
    "correlations": correlations.draw,
    "surface": surface.draw,
    "theory": theory.draw,
}
