# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""A bed of spheres of beds/README.md in YADE: linear springs, tangential history, Coulomb friction.

Stiffnesses are those of the bed for grains of diameter 1. YADE has no dashpot in this law; its own damping takes the
place. The skin hardly matters: 0.02 to 0.1 of the smallest radius are equally fast. Called as `yade -n -x -j1 yade_bed.py
BED SECONDS OUT` by the driver of ./dev bench.
"""

import json
import math
import sys
import time

path, seconds, out = sys.argv[1], float(sys.argv[2]), sys.argv[3]

# k = E r for two grains of radius r; k_t = nu k.
material = O.materials.append(FrictMat(young=1e5, poisson=2 / 7, density=6 / math.pi, frictionAngle=math.atan(0.5)))
section, width = "", 0.0
velocities = {}
with open(path, encoding="utf-8") as file:
    for line in file:
        words = line.split()
        if not words:
            continue
        if words[0] in ("Atoms", "Velocities"):
            section = words[0]
        elif not section and words[-2:] == ["xlo", "xhi"]:
            width = float(words[1]) - float(words[0])
        elif section == "Atoms":
            place = [float(word) for word in words[4:7]]
            grain = sphere(place, 0.5 * float(words[2]), material=material, fixed=words[1] == "2")
            velocities[words[0]] = O.bodies.append(grain)
        elif section == "Velocities":
            O.bodies[velocities[words[0]]].state.vel = Vector3(*(float(word) for word in words[1:4]))

# Periodic in x; so high and wide that nothing touches across the other sides.
O.periodic = True
O.cell.setBox(Vector3(width, 300, 300))
O.dt = 2e-4
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=-0.05, allowBiggerThanPeriod=True),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                    [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(gravity=(0, 0, -1), damping=0.1),
]
O.run(20, True)
steps, start = 0, time.process_time()
while time.process_time() - start < seconds:
    O.run(5, True)
    steps += 5
with open(out, "w", encoding="utf-8") as file:
    json.dump({"steps": steps, "cpu_seconds": time.process_time() - start, "contacts": O.interactions.countReal()}, file)
