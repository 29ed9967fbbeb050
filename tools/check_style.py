#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the house style that a formatter cannot: one line per violation, exit status 1 if there is any.

Sources start with the two SPDX lines and have at most 600 lines, unless the first ten say "Long because ...".
No text leaves a task marked in it or names a path of somebody's machine.

usage: check_style.py [ROOT | --self-test]
"""

import re
import sys
import tempfile
from pathlib import Path

FOLDERS = [".ci", "benchmarks", "cmake", "docs", "examples", "python", "src", "studies", "tests", "tools"]
SOURCES = {".cmake", ".cpp", ".hpp", ".h", ".cu", ".cuh", ".py", ".sh"}
TEXTS = SOURCES | {".cff", ".cmake", ".json", ".md", ".toml", ".txt", ".yaml", ".yml"}
LONGEST = 450

SPDX = [
    re.compile(r"(//|#) SPDX-FileCopyrightText: \d{4} The Repose developers$"),
    re.compile(r"(//|#) SPDX-License-Identifier: BSD-3-Clause$"),
]
TASK = re.compile(r"\b(TO[D]O|FIX[M]E)\b")
MACHINE_PATH = re.compile(r"(?<![\w./~-])(/(home|Users|root|work|tmp|mnt|media|scratch)/\w|[A-Z]:\\Users\\)")


def is_script(file):
    with file.open("rb") as stream:
        return stream.read(2) == b"#!"


def header_problem(lines):
    after_shebang = lines[1:3] if lines and lines[0].startswith("#!") else lines[:2]
    if len(after_shebang) < 2 or not all(rule.match(line) for rule, line in zip(SPDX, after_shebang)):
        return "must start with the two SPDX lines (after #!, if there is one)"
    return None


def problems_of(file):
    lines = file.read_text(encoding="utf-8").splitlines()
    if file.suffix in SOURCES or is_script(file):
        problem = header_problem(lines)
        if problem:
            yield 1, problem
        if len(lines) > LONGEST and not any("Long because" in line for line in lines[:10]):
            yield len(lines), f'is longer than {LONGEST} lines: split it, or say "Long because ..." in the first ten'
    for number, line in enumerate(lines, 1):
        for rule, what in [(TASK, "do it, or open an issue"), (MACHINE_PATH, "is a path of one machine")]:
            found = rule.search(line)
            if found:
                yield number, f"{found.group()} {what}"


def texts(root):
    """The files to check: those in the project's folders and those at its top."""
    files = list(root.iterdir())
    for folder in FOLDERS:
        files += (root / folder).rglob("*")
    return sorted(file for file in files if file.is_file() and (file.suffix in TEXTS or is_script(file)))


def check(root):
    """(number of files, problems as "file:line: what") of a project."""
    files = texts(root)
    problems = [f"{file.relative_to(root)}:{line}: {what}" for file in files for line, what in problems_of(file)]
    return len(files), problems


# The self-test: files with and without violations; each violation must be found, and nothing else.
HEADER = "// SPDX-FileCopyrightText: 2026 The Repose developers\n// SPDX-License-Identifier: BSD-3-Clause\n"
PYTHON_HEADER = HEADER.replace("//", "#")
RIGHT = {
    "src/repose/core/vec.hpp": HEADER + "#pragma once\n",
    "python/repose/__init__.py": PYTHON_HEADER,
    "tools/tool.py": "#!/usr/bin/env python3\n" + PYTHON_HEADER,
    "dev": "#!/usr/bin/env bash\n" + PYTHON_HEADER,
    "tests/full.cpp": HEADER + "\n" * (LONGEST - 2),
    "tests/long.cpp": HEADER + "// Long because the table is one.\n" + "\n" * LONGEST,
    "docs/paths.md": "https://example.org/home/page, out/work/run.h5, /usr/bin/python3, the dataset /grains/id\n",
    "src/picture.png": "\n",
    "elsewhere/venv.py": "not ours\n",
}
WRONG = {
    "src/none.hpp:1": "#pragma once\n",
    "src/empty.cpp:1": "",
    "src/half.cpp:1": HEADER.splitlines()[0] + "\n",
    "src/late.cpp:1": "\n" + HEADER,
    "src/other.cpp:1": HEADER.replace("BSD-3-Clause", "MIT"),
    "tools/bare.py:1": "#!/usr/bin/env python3\n",
    ".ci/bare:1": "#!/usr/bin/env bash\n",
    f"tests/long_silent.cpp:{LONGEST + 1}": HEADER + "\n" * (LONGEST - 1),
    f"tests/long_late.cpp:{LONGEST + 30}": HEADER + "\n" * 10 + "// Long because\n" + "\n" * (LONGEST + 17),
    "src/task.cpp:3": HEADER + "// TO" + "DO: later\n",
    "src/mend.cpp:4": HEADER + "\n  // FIX" + "ME\n",
    "docs/task.md:1": "TO" + "DO\n",
    "python/path.py:3": PYTHON_HEADER + 'open("/' + 'home/someone/data.csv")\n',
    "docs/path.md:2": "Run\n`cd /" + "work/repose`\n",
    "CMakeLists.txt:1": "set(X C:\\" + "Users\\someone)\n",
}


def plant(root, path, text):
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    (root / path).write_text(text, encoding="utf-8")


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, text in RIGHT.items():
            plant(root, path, text)
        assert check(root) == (len(RIGHT) - 2, []), check(root)
        for place, text in WRONG.items():
            plant(root, place.split(":")[0], text)
        found = [problem.split(": ")[0] for problem in check(root)[1]]
        assert sorted(found) == sorted(WRONG), set(found) ^ set(WRONG)
    print(f"self-test: {len(WRONG)} planted violations found, {len(RIGHT)} right files passed")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    files, problems = check(root)
    if files == 0:
        problems = [f"no files of the project below {root}"]
    print("\n".join(problems) or f"{files} files keep the house style")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
