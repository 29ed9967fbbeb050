# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes to begin with, and the reference of their keys."""

import re
import subprocess
from pathlib import Path

import pytest
from conftest import LIMIT, PROGRAM

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
SELF_CONTAINED = sorted(path.stem for path in EXAMPLES.glob("*.toml") if not path.stem.startswith("from-"))


def said(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True, timeout=LIMIT).stdout


def test_list_of_kinds_is_that_of_the_examples():
    listed = [line.split()[0] for line in said("scene").splitlines()]
    assert sorted(listed) == SELF_CONTAINED


@pytest.mark.parametrize("kind", SELF_CONTAINED)
def test_a_scene_to_begin_with_is_complete(lab, kind):
    """It passes the check wherever it lies, and `check` says the same of it as of the example."""
    lab.scene(said("scene", kind))
    mine = lab("check", "scene.toml")
    assert mine.returncode == 0, mine.stderr
    assert mine.stdout == said("check", str(EXAMPLES / f"{kind}.toml"))


def test_unknown_kind_and_page(lab):
    lab.refused("scene", "castle", parts=["castle: no such kind of scene; must be", "heap | "])
    lab.refused("reference", "castle", parts=["castle: no such page"])


def keys_of(text):
    """Keys of a scene file as the reference writes them: (table, key); entries of lists of tables are one table."""
    table = ""
    for line in text.splitlines():
        if header := re.match(r"\[\[?([\w.]+)\]?\]", line):
            table = header[1]
        elif key := re.match(r"(?:# )?(\w+) = ", line):
            yield table, key[1]


def test_the_reference_names_every_key_that_scenes_have():
    reference = said("reference", "scene")
    tables = dict(re.findall(r"<!-- table: (.+?) -->\n(.*?)<!-- end -->", reference, re.DOTALL))
    seen = set()
    for kind in SELF_CONTAINED:
        for table, key in keys_of(said("scene", kind)):
            top, *below = table.split(".")
            section = tables.get(f"[{top}]") or tables.get(f"[[{top}]]") or tables["outside tables"]
            if top == "pair":
                section += tables["[contact]"]  # whose laws a pair may have too
            name = ".".join([*below, key])
            assert f"| `{name}` |" in section, (kind, table, key)
            seen.add((table, key))
    assert len(seen) > 80


def test_every_row_of_the_reference_has_a_meaning():
    rows = re.findall(r"^\| `[\w.]+` \|.*$", said("reference", "scene"), re.MULTILINE)
    full = [row for row in rows if row.count("|") > 4]
    assert len(full) > 100
    assert all(row.rstrip("| ").split("|")[-1].strip() for row in full)
