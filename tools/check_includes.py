#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the includes under src/repose point downward: one line per violation, exit status 1 if there is any.

usage: check_includes.py [ROOT | --self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

# What each layer may include beside itself. Each method, methods/X, is a layer of its own, which may also include the
# headers that lie directly in methods/.
BELOW = {
    "core": set(),
    "neighbours": {"core"},
    "laws": {"core"},
    "boundaries": {"core", "laws"},
    "tables": {"core"},
    "theory": {"core", "tables"},
    "io": {"core", "neighbours", "tables"},
    "methods": {"core", "neighbours", "laws", "boundaries"},
    "analysis": {"core", "neighbours"},
    "scene": {"core", "neighbours", "boundaries", "laws", "tables", "io"},
}
KERNELS = {"core", "neighbours", "laws", "boundaries", "tables", "theory", "io"}
BELOW["record"] = KERNELS | {"methods", "analysis", "scene"}
# A simulation and what the analysis makes of its record never see each other.
BELOW["simulation"] = BELOW["results"] = BELOW["record"] | {"record"}
BELOW["contact_problem"] = BELOW["record"] | {"record", "simulation", "results"}
BELOW["determinacy"] = BELOW["contact_problem"] | {"contact_problem"}
BELOW["stability"] = BELOW["contact_problem"]
BELOW["slips"] = BELOW["contact_problem"]
BELOW["run_folder"] = BELOW["determinacy"] | {"determinacy", "stability", "slips"}
BELOW["sweep"] = BELOW["run_folder"] | {"run_folder"}
BELOW["comparison"] = BELOW["sweep"] | {"sweep"}
BELOW["study"] = BELOW["comparison"] | {"comparison"}
BELOW["api"] = BELOW["study"] | {"study"}
BELOW["view"] = BELOW["comparison"] | {"comparison"}
BELOW["cli"] = BELOW["api"] | {"api", "view"}

# Headers that a layer must not see, directly or through others: laws never see the grains, theory sees core's math
# alone.
HIDDEN = {
    "laws": ["core/grains.hpp"],
    "theory": ["core/grains.hpp", "core/contacts.hpp"],
}

INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')
SUFFIXES = {".hpp", ".cpp", ".h", ".cu", ".cuh"}


def layer(path):
    """The layer of a path below src/repose: its folder, with one layer per method; "" for a file in no folder."""
    parts = Path(path).parts
    if parts[0] == "methods" and len(parts) > 2:
        return "methods/" + parts[1]
    return parts[0] if len(parts) > 1 else ""


def may_include(upper, lower):
    if upper == lower:
        return True
    top = upper.split("/")[0]
    if top == "methods" and lower == "methods":
        return True
    return lower.split("/")[0] in BELOW[top]


def own_includes(file):
    """(line number, path below src/repose, or None where the include is written otherwise) of Repose's own headers."""
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        quote, target = found.groups()
        if target.startswith("repose/") and quote == '"':
            yield number, target.removeprefix("repose/")
        elif quote == '"' or target.startswith("repose/"):
            yield number, None


def sees(graph, start, hidden):
    """Whether `start` is `hidden` or includes it, through any number of headers."""
    seen, ahead = set(), [start]
    while ahead:
        path = ahead.pop()
        if path == hidden:
            return True
        if path not in seen:
            seen.add(path)
            ahead += [target for _, target in graph.get(path, []) if target]
    return False


def problems_of(path, graph):
    upper = layer(path)
    if upper.split("/")[0] not in BELOW:
        yield 1, f"{upper or 'src/repose itself'} is no layer; the layers are {', '.join(BELOW)}"
        return
    for number, target in graph[path]:
        if target is None:
            yield number, 'Repose\'s own headers are included as "repose/FOLDER/NAME.hpp", all others in <>'
        elif not may_include(upper, layer(target)):
            allowed = ", ".join(sorted(BELOW[upper.split("/")[0]])) or "nothing else"
            yield number, f"{upper} must not include {layer(target) or target} (it may include {allowed})"
        elif layer(target) != upper:
            for hidden in HIDDEN.get(upper, []):
                if sees(graph, target, hidden):
                    yield number, f"{upper} must not see {hidden} (here through {target})"


def check(root):
    """(number of files, problems as "file:line: what") of a source tree."""
    source = root / "src" / "repose"
    files = sorted(file for file in source.rglob("*") if file.suffix in SUFFIXES)
    graph = {file.relative_to(source).as_posix(): list(own_includes(file)) for file in files}
    problems = [f"src/repose/{path}:{line}: {what}" for path in graph for line, what in problems_of(path, graph)]
    return len(files), problems


# The self-test: a tree with right and wrong includes; each wrong one must be found, and nothing else.
RIGHT = {
    "core/vec.hpp": ["<cmath>"],
    "core/grains.hpp": ['"repose/core/vec.hpp"'],
    "core/view.hpp": ['"repose/core/grains.hpp"'],
    "neighbours/pair_list.hpp": ['"repose/core/grains.hpp"'],
    "laws/hooke.hpp": ['"repose/core/vec.hpp"', '"repose/laws/touch.hpp"'],
    "boundaries/plane.hpp": ['"repose/laws/hooke.hpp"'],
    "methods/method.hpp": ['"repose/core/grains.hpp"', '"repose/methods/report.hpp"'],
    "methods/soft/sweep.hpp": ['"repose/laws/hooke.hpp"'],
    "methods/soft/soft.hpp": ['"repose/methods/method.hpp"', '"repose/methods/soft/sweep.hpp"'],
    "theory/janssen.hpp": ['"repose/core/vec.hpp"'],
    "simulation/simulation.cpp": ['"repose/methods/soft/soft.hpp"', '"repose/theory/janssen.hpp"', "<fmt/format.h>"],
    "cli/main.cpp": ['"repose/simulation/simulation.hpp"'],
}
WRONG = {
    "core/up.hpp": ['"repose/laws/hooke.hpp"'],
    "neighbours/up.hpp": ['"repose/laws/hooke.hpp"'],
    "laws/direct.hpp": ['"repose/core/grains.hpp"'],
    "laws/indirect.hpp": ['"repose/core/view.hpp"'],
    "boundaries/up.hpp": ['"repose/neighbours/pair_list.hpp"'],
    "methods/down.hpp": ['"repose/methods/soft/soft.hpp"'],
    "methods/hybrid/sideways.hpp": ['"repose/methods/soft/soft.hpp"'],
    "methods/soft/up.hpp": ['"repose/scene/scene.hpp"'],
    "scene/up.hpp": ['"repose/methods/method.hpp"'],
    "analysis/up.cpp": ['"repose/methods/soft/soft.hpp"'],
    "io/up.cpp": ['"repose/scene/scene.hpp"'],
    "theory/direct.hpp": ['"repose/core/contacts.hpp"'],
    "theory/indirect.hpp": ['"repose/core/view.hpp"'],
    "record/up.cpp": ['"repose/simulation/simulation.hpp"'],
    "simulation/sideways.cpp": ['"repose/results/results.hpp"'],
    "results/sideways.cpp": ['"repose/simulation/simulation.hpp"'],
    "run_folder/up.cpp": ['"repose/sweep/sweep.hpp"'],
    "api/up.cpp": ['"repose/cli/main.hpp"'],
    "misc/unknown.hpp": ["<cmath>"],
    "stray.hpp": ["<cmath>"],
    "io/relative.cpp": ['"../core/vec.hpp"'],
    "io/angle.cpp": ["<repose/core/vec.hpp>"],
    "io/spaced.cpp": ['"repose/simulation/simulation.hpp"'],
}


def plant(root, tree, directive="#include "):
    for path, includes in tree.items():
        file = root / "src" / "repose" / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text("".join(f"{directive}{target}\n" for target in includes), encoding="utf-8")


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        plant(root, RIGHT)
        assert check(root) == (len(RIGHT), []), check(root)
        plant(root, WRONG)
        plant(root, {"io/spaced.cpp": WRONG["io/spaced.cpp"]}, directive="  #  include")
        found = [problem.split(": ")[0] for problem in check(root)[1]]
        expected = sorted(f"src/repose/{path}:1" for path in WRONG)
        assert sorted(found) == expected, set(found) ^ set(expected)
    print(f"self-test: {len(WRONG)} planted violations found, {len(RIGHT)} right files passed")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    files, problems = check(root)
    if files == 0:
        problems = [f"no sources below {root}/src/repose"]
    print("\n".join(problems) or f"{files} files: all includes point downward")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
