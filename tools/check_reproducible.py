#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that nothing that the state of grains depends on calls a function whose last bit depends on the processor or on
the version of a library: one line per violation, exit status 1 if there is any. repose/core/reproducible_math.hpp has
functions to call instead.

usage: check_reproducible.py [ROOT | --self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

# Folders of src/repose whose numbers reach the grains.
FOLDERS = ["core", "io", "neighbours", "laws", "boundaries", "methods", "scene", "simulation"]
SUFFIXES = {".hpp", ".cpp", ".h", ".cu", ".cuh"}

# sqrt, fma, floor, ldexp and their like are exact or correctly rounded everywhere.
ELEMENTARY = (
    "exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|"
    "atanh|erf|erfc|tgamma|lgamma"
)
RULES = [
    (re.compile(rf"\bstd::({ELEMENTARY})\b"), "depends on the C library and the processor"),
    (re.compile(r"\bstd::\w+_distribution\b"), "depends on the standard library"),
    (re.compile(r"#\s*include\s*<boost/math/"), "calls the C library"),
]


def problems_of(file):
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        code = line.split("//")[0]
        for rule, what in RULES:
            found = rule.search(code)
            if found:
                yield number, f"{found.group()} {what}: see repose/core/reproducible_math.hpp"


def check(root):
    """(number of files, problems as "file:line: what") of a source tree."""
    files = []
    for folder in FOLDERS:
        files += (root / "src" / "repose" / folder).rglob("*")
    files = sorted(file for file in files if file.suffix in SUFFIXES)
    return len(files), [f"{file.relative_to(root)}:{line}: {what}" for file in files for line, what in problems_of(file)]


# The self-test: files with and without violations; each violation must be found, and nothing else.
RIGHT = {
    "core/right.cpp": "// unlike std::pow\nreproducible::pow(x, y); std::sqrt(x); std::floor(x); std::exponent(x);\n",
    "analysis/free.cpp": "std::pow(x, y);\n",
}
WRONG = {
    "laws/power.hpp:2": "double f(double x) {\n  return std::pow(x, 1.5);\n}\n",
    "simulation/sources/turn.cpp:1": "x += std::cos(turn);\n",
    "core/draw.cpp:1": "std::normal_distribution<double> sizes;\n",
    "scene/sizes.cpp:1": "#include <boost/math/distributions/normal.hpp>\n",
    "methods/soft/use.cpp:1": "using std::exp;\n",
}


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for place, text in {**RIGHT, **WRONG}.items():
            path = root / "src" / "repose" / place.split(":")[0]
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        found = [problem.split(": ")[0].removeprefix("src/repose/") for problem in check(root)[1]]
        assert sorted(found) == sorted(WRONG), set(found) ^ set(WRONG)
    print(f"self-test: {len(WRONG)} planted violations found, {len(RIGHT)} right files passed")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    files, problems = check(root)
    if files == 0:
        problems = [f"no sources below {root}"]
    print("\n".join(problems) or f"{files} files call reproducible functions alone")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
