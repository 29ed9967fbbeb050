# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of a run of spheres: each is a function of a RunFolder and a State that returns a figure or raises NotDrawn."""

from repose.pictures.run import avalanches, budget, column_motion, energy, force_distribution, slips, walls
from repose.pictures.spheres import (
    base_map,
    base_rings,
    column,
    cone,
    directions,
    fields,
    forces,
    pair_correlation,
    projection,
    section,
    voronoi,
)

SPHERE_PICTURES = {
    "projection": projection.draw,
    "slice": section.draw,
    "forces": forces.draw,
    "force_distribution": force_distribution.draw,
    "directions": directions.draw,
    "voronoi": voronoi.draw,
    "fields": fields.draw,
    "base_map": base_map.draw,
    "base_rings": base_rings.draw,
    "cone": cone.draw,
    "avalanches": avalanches.draw,
    "energy": energy.draw,
    "budget": budget.draw,
    "slips": slips.draw,
    "walls": walls.draw,
    "column": column.draw,
    "column_motion": column_motion.draw,
    "correlations": pair_correlation.draw,
}
