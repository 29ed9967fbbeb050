#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that no modules of the Python package import each other in a circle: one line per circle, exit status 1 if
there is any.

Every import counts, wherever it stands: at the top of a module, in a function, under `if` or `try`. Python runs a
package before its modules; this does not count as an import, so a package may import its own modules.

usage: check_python_imports.py [ROOT | --self-test]
"""

import ast
import sys
import tempfile
from pathlib import Path

PACKAGE = "repose"


def name_of(file, source):
    """Dotted name of the module in a file below `source`."""
    parts = file.relative_to(source).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def targets_of(node, package):
    """Dotted names that an import of a module in `package` may mean, the longest first for each imported name."""
    if isinstance(node, ast.Import):
        return [[alias.name] for alias in node.names]
    if isinstance(node, ast.ImportFrom):
        above = package.split(".")[: len(package.split(".")) - node.level + 1] if node.level else []
        base = ".".join([*above, *([node.module] if node.module else [])])
        return [[f"{base}.{alias.name}", base] for alias in node.names]
    if isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
        function = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", None)
        if function in ("import_module", "__import__"):
            return [[str(node.args[0].value)]]
    return []


def imports_of(file, module, modules):
    """Line of the first import of each of the package's modules."""
    package = module if file.name == "__init__.py" else module.rpartition(".")[0]
    lines = {}
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"), str(file))):
        for names in targets_of(node, package):
            target = next((name for name in names if name in modules), None)
            if target:
                lines[target] = min(node.lineno, lines.get(target, node.lineno))
    return lines


def circle_from(graph, start):
    """The shortest chain of imports from a module back to itself; None without."""
    came_from, ahead = {}, [start]
    for module in ahead:
        for target in sorted(graph[module]):
            if target == start:
                chain = [module]
                while chain[-1] != start:
                    chain.append(came_from[chain[-1]])
                return [*reversed(chain), start]
            if target not in came_from:
                came_from[target] = module
                ahead.append(target)
    return None


def check(root):
    """(number of modules, problems as "file:line: what") of a source tree."""
    source = root / "python"
    files = {name_of(file, source): file for file in sorted((source / PACKAGE).rglob("*.py"))}
    graph = {module: imports_of(file, module, files) for module, file in files.items()}
    problems, reported = [], set()
    for module in sorted(graph):
        circle = circle_from(graph, module)
        if circle and frozenset(circle) not in reported:
            reported.add(frozenset(circle))
            place = f"{files[module].relative_to(root)}:{graph[module][circle[1]]}"
            problems.append(f"{place}: import circle: {' -> '.join(circle)}")
    return len(files), problems


# The self-test: packages with and without circles; each circle must be found once, and nothing else.
RIGHT = {
    "__init__": "from repose.reader import read\n",
    "reader": "import json\nfrom repose import errors\n",
    "errors": "import repose_compiled\n",
    "plot": "import repose\nfrom repose.pictures import PICTURES\n",
    "pictures/__init__": "from repose.pictures import heap\nPICTURES = {}\n",
    "pictures/heap": "from repose.pictures import colours\n",
    "pictures/colours": "def ink():\n    from repose import reader\n",
}
WRONG = {
    "two modules": {"a": "import repose.b\n", "b": "from repose import a\n"},
    "three modules": {"a": "import repose.b\n", "b": "import repose.c\n", "c": "import repose.a\n"},
    "in a function": {"a": "import repose.b\n", "b": "def f():\n    if f:\n        from repose.a import x\n"},
    "a name of the package": {"a": "from repose import read\n", "reader": "import repose.a\n"},
    "a module and its package": {"pictures/heap": "from repose.pictures import PICTURES\n"},
    "relative": {"pictures/a": "from .b import x\n", "pictures/b": "from ..pictures import a\n"},
    "by name": {"a": "import repose.b\n", "b": "import importlib\nimportlib.import_module('repose.a')\n"},
    "itself": {"a": "import repose.a\n"},
}


def plant(root, tree):
    for path, text in tree.items():
        file = root / "python" / PACKAGE / f"{path}.py"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def self_test():
    for what, tree in {"no circle": {}, **WRONG}.items():
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            plant(root, RIGHT)
            plant(root, tree)
            problems = check(root)[1]
            assert len(problems) == bool(tree), (what, problems)
            assert all(f"repose.{path.replace('/', '.')}" in problems[0] for path in tree), (what, problems)
    print(f"self-test: {len(WRONG)} planted circles found, {len(RIGHT)} right modules passed")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    modules, problems = check(root)
    if modules == 0:
        problems = [f"no modules below {root}/python/{PACKAGE}"]
    print("\n".join(problems) or f"{modules} modules: no import circle")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
