# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""The settled beds (beds/README.md): one file for all programs, made once and kept."""

import gzip
import os
import shutil
from dataclasses import dataclass

from .process import run

BEDS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "beds")


@dataclass(frozen=True)
class Bed:
    """A bed file, copies of which stand side by side along x."""

    dimension: int
    path: str
    copies: int
    moving: int  # grains of all copies together


def bed(options, size, dimension=2, law="hooke"):
    """The bed of this many moving grains: beyond 10 000, copies of the one of 10 000."""
    one = min(size, 10_000)
    assert size % one == 0
    if (dimension, law, one) == (2, "hooke", 10_000):
        path = _unpacked(options)
    else:
        path = _settled(options, dimension, law, one)
    return Bed(dimension, path, size // one, size)


def _unpacked(options):
    path = os.path.join(options.folder, "bed10k.data")
    if not os.path.exists(path):
        with gzip.open(os.path.join(BEDS, "bed10k.data.gz")) as packed, open(path + ".new", "wb") as file:
            shutil.copyfileobj(packed, file)
        os.replace(path + ".new", path)
    return path


def _settled(options, dimension, law, count):
    path = os.path.join(options.folder, f"bed-{dimension}d-{law}-{count}.data")
    if not os.path.exists(path):
        options.say(f"settling a bed: {dimension}D, {law}, {count} grains")
        # Discs stand 50 deep; spheres, in a channel of about equal sides.
        length = count // 50 if dimension == 2 else round(count ** (1 / 3))
        run([options.program("repose_make_bed"), dimension, law, length, length, count, path + ".new"])
        os.replace(path + ".new", path)
    return path
