# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers for tests of the program from outside: they run scenes and read exit codes, messages and files."""

import json
import os
import re
import subprocess
from contextlib import contextmanager
from pathlib import Path

import h5py
import numpy as np
import pytest
import xxhash

PROGRAM = os.environ.get("REPOSE_PROGRAM", "")
LIMIT = 600  # seconds: over ten times what any program of the tests takes on a quiet machine

# 40 grains poured from a height of 10 onto a narrow row. They rest after about a tenth of a second of computing.
HEAP = """[base]
kind = "row"
half_width = 8
[source]
kind = "pour"
count = 40
rate = 1.0
height = 10
half_width = 2
[stop]
at_rest = 1e-6
time = 500
"""


def repose(*args, cwd=None, timeout=LIMIT, before=""):
    """Runs the program. `before` is shell text that precedes it, such as a limit on the size of files."""
    command = [PROGRAM, *map(str, args)]
    if before:
        command = ["bash", "-c", before + '; exec "$@"', "bash", *command]
    return subprocess.run(command, cwd=cwd, timeout=timeout, capture_output=True, text=True, errors="replace")


def everything_in(folder):
    return sorted(str(p.relative_to(folder)) for p in Path(folder).rglob("*"))


def datasets(path):
    """Every dataset below the root of an HDF5 file, also behind external links."""
    found = {}

    def collect(group, prefix):
        for name in group:
            item = group[name]  # a link that does not resolve raises KeyError
            if isinstance(item, h5py.Group):
                collect(item, f"{prefix}/{name}")
            else:
                found[f"{prefix}/{name}"] = item[()]

    with h5py.File(path, "r") as file:
        collect(file, "")
    return found


@contextmanager
def changed(path):
    """Opens an HDF5 file of Repose for a change by hand, and seals it again afterwards."""
    with h5py.File(path, "r+") as file:
        yield file
    content = path.read_bytes()
    seal = f"repose sealed file\nlength {len(content)}\nxxh3-128 {xxhash.xxh3_128_hexdigest(content[512:])}\n"
    path.write_bytes(seal.encode().ljust(512, b"\0") + content[512:])


def assert_same_bits(first, second):
    a, b = datasets(first), datasets(second)
    assert sorted(a) == sorted(b)
    for name, value in a.items():
        assert value.dtype == b[name].dtype and value.shape == b[name].shape, name
        assert value.tobytes() == b[name].tobytes(), f"{name} differs"


def text_attribute(path, name):
    with h5py.File(path, "r") as file:
        value = file.attrs[name]
    return value.decode() if isinstance(value, bytes) else str(value)


def summary(folder):
    return json.loads((Path(folder) / "summary.json").read_text())


def number_in(text, pattern):
    found = re.search(pattern + r"\s*([-+0-9.e]+)", text)
    assert found, f"no {pattern!r} in {text!r}"
    return float(found.group(1).rstrip("."))


def assert_plain(said):
    """No text of C++ and no traceback of Python."""
    for sign in ("terminate", "std::", "what()", "_M_", "Traceback", "basic_string"):
        assert sign not in said, said


class Laboratory:
    """A folder for one test."""

    def __init__(self, path):
        self.path = path

    def scene(self, text, name="scene.toml"):
        (self.path / name).write_text(text)
        return name

    def __call__(self, *args, **options):
        return repose(*args, cwd=self.path, **options)

    def shell(self, line, timeout=LIMIT, **environment):
        """Runs a line of bash in which $REPOSE is the program."""
        return subprocess.run(["bash", "-c", line], cwd=self.path, env={**os.environ, "REPOSE": PROGRAM, **environment},
                              capture_output=True, text=True, errors="replace", timeout=timeout)

    def run(self, text, *options, out="out", expect=0, **more):
        """Runs a scene into the folder `out` and checks the exit code."""
        result = self("run", self.scene(text), "--out", out, "--quiet", *options, **more)
        assert result.returncode == expect, result.stderr + result.stdout
        return self.path / out

    def refused(self, *args, parts=(), **options):
        """Checks that the program exits with 2, prints every part on standard error, and does not change the folder."""
        before = everything_in(self.path)
        result = self(*args, **options)
        assert result.returncode == 2, f"exit {result.returncode}: {result.stderr}{result.stdout}"
        for part in parts:
            assert part in result.stderr, f"{part!r} is not in {result.stderr!r}"
        assert everything_in(self.path) == before
        assert "terminate" not in result.stderr
        return result.stderr


class Grains:
    """The grains of a run, by ascending id."""

    def __init__(self, path):
        with h5py.File(path, "r") as file:
            self.time = float(file.attrs["time"])
            for name, item in file["grains"].items():
                setattr(self, name, item[()])

    def moving(self, name):
        return getattr(self, name)[self.fixed == 0]


@pytest.fixture
def lab(tmp_path):
    return Laboratory(tmp_path)


@pytest.fixture(scope="session")
def heap(tmp_path_factory):
    """A poured heap at rest, with frames. Tests only read it."""
    lab = Laboratory(tmp_path_factory.mktemp("heap"))
    return lab.run(HEAP + "[output]\nframes = 10\n", "--threads", "1")


@pytest.fixture(scope="session", autouse=True)
def program():
    assert PROGRAM, "set REPOSE_PROGRAM to the path of the program"
    assert Path(PROGRAM).is_file(), f"no program at {PROGRAM}"
    return PROGRAM


def forces_on_grains(path):
    """Net contact force on every grain by id, recomputed from the contacts written."""
    with h5py.File(path, "r") as file:
        pairs = file["contacts/grains"][()]
        normal = file["contacts/normal"][()]
        along = file["contacts/normal_force"][()]
        across = file["contacts/tangential_force"][()]
        ids = file["grains/id"][()]
    tangent = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    force = normal * along[:, None] + tangent * across[:, None]
    net = {int(k): np.zeros(2) for k in ids}
    for (first, second), f in zip(pairs, force):
        net[int(first)] += f
        if second >= 0:
            net[int(second)] -= f
    return net
