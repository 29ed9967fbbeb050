# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Builds the program and the compiled module by CMake and puts them beside the Python package, for pip.

REPOSE_BUILD names a folder in which both are built already; else build/release is built. CMake needs the libraries that
`./dev setup` installs."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, find_packages, setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).resolve().parent


def built():
    """The folder with the program and python/repose_compiled*.so."""
    if folder := os.environ.get("REPOSE_BUILD"):
        return Path(folder)
    subprocess.run(["cmake", "--preset", "release", f"-DPYTHON_EXECUTABLE={sys.executable}"], cwd=ROOT, check=True)
    targets = ["--target", "repose", "repose_compiled"]
    subprocess.run(["cmake", "--build", "--preset", "release", *targets], cwd=ROOT, check=True)
    return ROOT / "build/release"


class BuildWithProgram(build_py):
    """The package with the compiled module beside it and the program in its folder bin."""

    def run(self):
        super().run()
        folder, place = built(), Path(self.build_lib)
        modules = sorted((folder / "python").glob("repose_compiled*.so"))
        if not modules:
            sys.exit(f"{folder}/python: no repose_compiled*.so: the build needs pybind11 and -DREPOSE_PYTHON=ON")
        (place / "repose/bin").mkdir(exist_ok=True)
        for source, target in ((modules[0], place), (folder / "repose", place / "repose/bin")):
            shutil.copy(source, target)


class PlatformDistribution(Distribution):
    """A wheel for this platform and this Python alone."""

    def has_ext_modules(self):
        return True


setup(
    version=re.search(r"project\(repose VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1],
    package_dir={"": "python"},
    packages=find_packages("python", include=["repose", "repose.*"]),
    package_data={"repose": ["py.typed"]},
    cmdclass={"build_py": BuildWithProgram},
    distclass=PlatformDistribution,
)
