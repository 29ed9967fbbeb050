#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the pages of docs/reference say what the program knows: one line per stale page, exit status 1 if any.

`repose reference PAGE` prints a page, or only its tables. A table stands between <!-- table: NAME --> and <!-- end -->;
the page holds the same two lines, with prose around them that is written by hand.

usage: check_reference.py REPOSE_PROGRAM [--write] [ROOT]
       check_reference.py --self-test
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

TABLE = re.compile(r"<!-- table: (.+?) -->\n.*?<!-- end -->\n", re.DOTALL)


def printed(program, *arguments):
    return subprocess.run([program, "reference", *arguments], capture_output=True, text=True, check=True).stdout


def filled_in(page, text, printed_text):
    """(the page with the printed tables in their places, problems)."""
    tables = {table[1]: table[0] for table in TABLE.finditer(printed_text)}
    if not tables:
        return printed_text, []
    held = {table[1] for table in TABLE.finditer(text)}
    problems = [f"{page}: has no place for the table {name}" for name in tables if name not in held]
    problems += [f"{page}: the program prints no table {name}" for name in sorted(held - tables.keys())]
    return TABLE.sub(lambda table: tables.get(table[1], table[0]), text), problems


def check(program, root, write=False):
    """Problems as "page: what"; with `write`, stale tables are replaced instead."""
    problems = []
    for name in printed(program).split():
        page = f"docs/reference/{name}.md"
        file = root / page
        text = file.read_text(encoding="utf-8") if file.is_file() else ""
        fresh, found = filled_in(page, text, printed(program, name))
        problems += found
        if fresh == text:
            continue
        if write:
            file.write_text(fresh, encoding="utf-8")
        else:
            problems.append(f"{page}: is stale: run ./dev docs")
    return problems


PROGRAM = """#!/bin/sh
case "$2" in
  "") echo tables; echo whole ;;
  tables) printf '<!-- table: one -->\\n| new |\\n<!-- end -->\\n<!-- table: two -->\\n| 2 |\\n<!-- end -->\\n' ;;
  whole) echo '# All of it' ;;
esac
"""
TABLE_ONE = "<!-- table: one -->\n| {} |\n<!-- end -->\n"
TABLE_TWO = "<!-- table: two -->\n| 2 |\n<!-- end -->\n"


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        program = root / "program"
        program.write_text(PROGRAM, encoding="utf-8")
        program.chmod(0o755)
        pages = root / "docs/reference"
        pages.mkdir(parents=True)
        (pages / "tables.md").write_text("Prose.\n" + TABLE_ONE.format("old") + "More.\n" + TABLE_TWO, encoding="utf-8")
        stale = check(str(program), root)
        assert [problem.split(": ")[0] for problem in stale] == ["docs/reference/tables.md", "docs/reference/whole.md"]
        assert check(str(program), root, write=True) == [] and check(str(program), root) == []
        text = (pages / "tables.md").read_text(encoding="utf-8")
        assert text == "Prose.\n" + TABLE_ONE.format("new") + "More.\n" + TABLE_TWO, text
        (pages / "tables.md").write_text(TABLE_TWO + "<!-- table: three -->\n<!-- end -->\n", encoding="utf-8")
        wrong = check(str(program), root)
        assert any("no place for the table one" in problem for problem in wrong), wrong
        assert any("prints no table three" in problem for problem in wrong), wrong
    print("self-test: stale, missing and unknown tables found")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    write = "--write" in arguments
    places = [argument for argument in arguments if argument != "--write"]
    if not places:
        print(__doc__.strip())
        return 2
    root = Path(places[1]) if len(places) > 1 else Path(__file__).resolve().parent.parent
    problems = check(places[0], root, write)
    print("\n".join(problems) or "the reference pages are up to date")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
