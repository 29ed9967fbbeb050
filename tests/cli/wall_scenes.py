# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes with walls that several tests share. Units: diameter, mass, gravity."""

HOOKE = "[contact]\nfriction = 0.0\nnormal = { law = 'hooke', stiffness = 1e4, restitution = 0.5 }\n"
IMPACT = "gravity = 0.0\n[method]\ntime_step = 2e-5\n" + HOOKE


def wall(name, start, end, *lines):
    return "\n".join([f"[[wall]]\nname = '{name}'\nfrom = {list(start)}\nto = {list(end)}", *lines, ""])


def grain(x, y, vx=0.0, vy=0.0):
    return f"[[grain]]\nposition = [{x}, {y}]\nvelocity = [{vx}, {vy}]\n"


# A container of pieces of wall, tight around 5 x 4 discs at rest: all cells but those of the top are closed unit squares.
SQUARE = "gravity = 1.0\n[contact]\nnormal = { law = 'hooke', stiffness = 1e7, damping = 0.5 }\n[stop]\ntime = 0.02\n" + "".join(
    f"[[grain]]\nposition = [{x + 0.5}, {y + 0.5}]\n" for y in range(4) for x in range(5))
TRAY = wall("left", (0, 9), (0, 0)) + wall("floor a", (0, 0), (2, 0)) + wall("floor b", (2, 0), (9, 0)) + wall("right", (5, 0), (5, 9))

# Grains poured from height 20 onto a rough plane.
POUR = """[method]
time_step = 0.001
[contact]
normal = { law = "hooke", stiffness = 1e4, damping = 0.5 }
[base]
kind = "plane"
[source]
kind = "pour"
count = 30
rate = 2.0
height = 20.0
[stop]
time = 16.0
[output]
series = 0.1
"""
