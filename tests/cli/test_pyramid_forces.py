# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The forces in a pyramid of equal spheres at rest without friction, from the program, against a linear solve.

The pyramid has square layers, as a face-centred cubic crystal cut along its cube faces, on fixed spheres. Each sphere
stands on four others and touches four of its layer, so that balance alone does not fix the forces: the springs do.
"""

import h5py
import numpy as np
import pytest
from conftest import Laboratory

LAYERS = 5
STIFFNESS = 1e5  # in grain weights per diameter: overlaps of 1e-5 to 1e-4 diameters


def places():
    """Centres (n, 3) of the pyramid, and of its base, in the reference state where touching spheres do not overlap."""
    layers = []
    for k in range(LAYERS + 1):
        at = np.arange(LAYERS + 1 - k) - 0.5 * (LAYERS - k)  # in the hollows of the layer below
        layers.append([(x, y, k * np.sqrt(0.5)) for x in at for y in at])
    return np.array(sum(layers[1:], [])), np.array(layers[0])


def scene():
    moving, base = places()
    grains = [f"[[grain]]\nposition = [{x}, {y}, {z}]\n" for x, y, z in moving]
    grains += [f"[[grain]]\nposition = [{x}, {y}, {z}]\nfixed = true\n" for x, y, z in base]
    return f"""dimension = 3
{"".join(grains)}
[contact]
friction = 0.0
normal = {{ law = "hooke", stiffness = {STIFFNESS}, restitution = 0.2 }}
[stop]
at_rest = 1e-9
time = 200.0
"""


def solved():
    """Contact forces of the moving spheres, {(first, second): force}, from linear elasticity about the reference state:
    springs between all that touch there; those in tension open, one at a time, and close again if they overlap."""
    moving, base = places()
    points = np.vstack([moving, base])
    n = len(moving)
    pairs = [(i, j) for i in range(n) for j in range(i + 1, len(points)) if np.linalg.norm(points[i] - points[j]) < 1.0 + 1e-9]
    normals = np.array([points[i] - points[j] for i, j in pairs])
    rows = np.zeros((len(pairs), 3 * n))  # overlaps are -rows u
    for row, (i, j), normal in zip(rows, pairs, normals, strict=True):
        row[3 * i : 3 * i + 3] = normal
        if j < n:
            row[3 * j : 3 * j + 3] = -normal
    weight = np.tile([0.0, 0.0, -1.0], n)
    closed = np.ones(len(pairs), bool)
    for _ in range(1000):
        stiffness = STIFFNESS * rows[closed].T @ rows[closed]
        overlap = -rows @ np.linalg.solve(stiffness, weight)
        wrong = np.where(closed, -overlap, overlap)
        if wrong.max() <= 0.0:
            return {pair: STIFFNESS * overlap[k] for k, pair in enumerate(pairs) if closed[k]}
        closed[np.argmax(wrong)] ^= True
    raise AssertionError("the set of closed contacts does not settle")


@pytest.fixture(scope="module")
def settled(tmp_path_factory):
    lab = Laboratory(tmp_path_factory.mktemp("pyramid"))
    return lab.run(scene())


def test_forces_are_those_of_the_linear_solve(settled):
    with h5py.File(settled / "run.h5") as run:
        ids, forces = run["contacts/grains"][:], run["contacts/normal_force"][:]
    found = {tuple(sorted(pair)): force for pair, force in zip(ids.tolist(), forces, strict=True)}
    expected = solved()
    assert found.keys() == expected.keys()
    largest = max(expected.values())
    assert len(expected) == 220  # those to the four below; the contacts within layers are open
    assert 1.0 < largest < 2.0
    # Overlaps of up to 1e-4 turn the normals by as much, and add up over the layers.
    for pair, force in expected.items():
        assert abs(found[pair] - force) < 5e-4 * largest
