# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The standard pictures: each is a function of a RunFolder and a State that returns a figure or raises NotDrawn."""

from repose.pictures import base, density, energy, forces, heap

PICTURES = {
    "heap": heap.draw,
    "density": density.draw,
    "forces": forces.draw,
    "base": base.draw,
    "energy": energy.draw,
}
