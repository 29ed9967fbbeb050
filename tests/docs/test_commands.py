# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every command of docs and README works. cheap.py says in which form each kind of command runs here."""

import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
from cheap import EXCEPTED, cheap_form, folders_of, pictures_of, stand_in
from commands import ROOT, Command, commands_of, is_synopsis, pages_of, python_of, saved_files, words_of

PROGRAM = os.environ.get("REPOSE_PROGRAM", "")
PACKAGE = os.environ.get("REPOSE_PYTHON_PATH") or str(Path(PROGRAM).parent / "python")
LIMIT = 300  # seconds: far more than any command takes here

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
[output]
window = 10
"""
RIGID = HEAP.replace("1e-6", "1e-3") + '[method]\nkind = "contact-dynamics"\n'
SWEEP = 'scene = "heap.toml"\nseeds = 2\n[vary]\nbase.spacing = [1.0, 1.1]\n'


def all_commands():
    """One parameter for each different command; the same line on several pages runs once."""
    first = {}
    for page, text in pages_of(ROOT):
        for command in commands_of(page, text):
            first.setdefault((command.text, "saved" if saved_files(text) else ""), command)
    return list(first.values())


def sweeps_of(page):
    """The folders that the sweeps of a page write."""
    found = {"out/sweep"}
    for command in commands_of(page, (ROOT / page).read_text(encoding="utf-8")):
        words = command.words
        if words[1:2] == ["sweep"] and "--out" in words:
            found.add(words[words.index("--out") + 1])
    return found


def folders_named(page):
    """The folders that the commands of a page write or read."""
    commands = commands_of(page, (ROOT / page).read_text(encoding="utf-8"))
    return {"out/heap"}.union(*(re.findall(r"\bout/[\w-]+", command.text) for command in commands))


def run(words, folder, **environment):
    """Runs a program in a folder."""
    return subprocess.run(words, cwd=folder, env={**os.environ, "REPOSE_PYTHON_PATH": PACKAGE, **environment},
                          capture_output=True, text=True, errors="replace", timeout=LIMIT)


def expect_success(words, folder, command, **environment):
    """Runs a program, which must succeed, and returns what it prints."""
    result = run(words, folder, **environment)
    assert result.returncode == 0, f"{command}\nran as {shlex.join(words)}\n{result.stderr}{result.stdout}"
    return result.stdout + result.stderr


@pytest.fixture(scope="session")
def made(tmp_path_factory):
    """The small folders that stand for those of the pages."""
    assert Path(PROGRAM).is_file(), "set REPOSE_PROGRAM to the path of the program"
    place = tmp_path_factory.mktemp("made")
    for name, text in {"heap.toml": HEAP, "rigid.toml": RIGID, "sweep.toml": SWEEP}.items():
        (place / name).write_text(text)
    for name in ("heap", "rigid"):
        expect_success([PROGRAM, "run", f"{name}.toml", "--out", name, "--quiet"], place, name)
    expect_success([PROGRAM, "sweep", "sweep.toml", "--out", "sweep", "--quiet"], place, "sweep")
    expect_success([PROGRAM, "export", "rigid", "--to", "contact-problem", "--out", "problem"], place, "problem")
    return place


@pytest.fixture(scope="session")
def helps(made):
    """What `repose VERB --help` prints, by verb; asked once."""
    known = {}

    def help_of(verb):
        if verb not in known:
            known[verb] = expect_success([PROGRAM, *([verb] if verb else []), "--help"], made, verb)
        return known[verb]

    return help_of


def room(tmp_path, command, made):
    """A folder like the root of the sources for a command: examples, saved files, small runs."""
    for name in ("examples", "benchmarks", "studies"):
        (tmp_path / name).symlink_to(ROOT / name)
    (tmp_path / "docs/images").mkdir(parents=True)
    (tmp_path / "out").mkdir()
    for name, text in saved_files((ROOT / command.page).read_text(encoding="utf-8")).items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    sweeps = sweeps_of(command.page)
    for name in folders_named(command.page):
        (tmp_path / name).symlink_to(made / ("sweep" if name in sweeps else "heap"))
    return tmp_path


def check_options(words, helps):
    """The options of a command are known to its verb."""
    verb = words[0] if words and not words[0].startswith("-") else ""
    for word in words:
        if word.startswith("--"):
            assert re.search(rf"(?<![\w-]){word.split('=')[0]}(?![\w-])", helps(verb)), f"repose {verb} knows no {word}"


def cheap(words, command, made):
    """The arguments that run instead, with small folders and files in place of those that the command reads."""
    sweeps = sweeps_of(command.page)
    words = cheap_form(words, sweeps)
    if words[0] == "solve":
        return ["solve", str(made / "problem/problem.h5"), *words[2:]]
    for folder in folders_of(words):
        small = stand_in(words, sweeps)
        words = [str(made / small) if word == folder else word for word in words]
    return words


def check_pictures(words, command, made):
    """The pictures that a command names exist for its kind of folder."""
    small = "sweep" if words[1] in sweeps_of(command.page) else "heap"
    unknown = run([PROGRAM, "plot", str(made / small), "--only", "?"], made).stderr
    known = re.split(r"[,\s]+", unknown.partition("choose from ")[2])
    for name in pictures_of(words):
        assert name in known, f"{command}\nno picture {name} of a {small}: {unknown}"


def check_dev(words):
    """`./dev help` lists a verb and its options."""
    listed = subprocess.run([ROOT / "dev", "help"], capture_output=True, text=True, check=True).stdout
    assert re.search(rf"^  {words[1]}\b", listed, re.MULTILINE), f"./dev knows no {words[1]}"
    for word in words[2:]:
        assert not word.startswith("--") or word in listed, f"./dev {words[1]} knows no {word}"


@pytest.mark.parametrize("command", all_commands(), ids=str)
def test_command(command, made, helps, tmp_path):
    reason = next((text for start, text in EXCEPTED.items() if command.text.startswith(start)), None)
    if reason:
        pytest.skip(reason)
    if command.words[0] == "./dev":
        check_dev(command.words)
        return
    place = room(tmp_path, command, made)
    if command.words[0] == "python3":
        expect_success([sys.executable, *command.words[1:]], place, command, PYTHONPATH=PACKAGE)
        return
    words = command.words[1:]
    check_options(words, helps)
    if len(pictures_of(words)) > 1:
        check_pictures(words, command, made)
    expect_success([PROGRAM, *cheap(words, command, made)], place, command)


@pytest.mark.parametrize("page", [page for page, text in pages_of(ROOT) if python_of(text)])
def test_python(page, made, tmp_path):
    script = python_of((ROOT / page).read_text(encoding="utf-8"))
    expect_success([sys.executable, "-c", script], room(tmp_path, Command(page, 1, ""), made), page, PYTHONPATH=PACKAGE)


def test_exceptions_are_in_use():
    texts = [command.text for command in all_commands()]
    assert all(any(text.startswith(start) for text in texts) for start in EXCEPTED)


PAGE = """Prose: repose run no.toml
```
repose run a.toml \\
  --set x=1   # says so
./dev test
repose run DIR --out D
$ repose check b.toml | head
X=1 repose plot out/heap > log
```
```toml
repose run no.toml
```
    repose run no.toml

    repose sweep c.toml
    output

- list
    repose run no.toml
"""


def test_commands_are_found():
    found = [command.words for command in commands_of("page", PAGE)]
    assert found == [["repose", "run", "a.toml", "--set", "x=1"], ["./dev", "test"], ["repose", "check", "b.toml"],
                     ["repose", "plot", "out/heap"], ["repose", "sweep", "c.toml"]]


def test_synopses_are_told_apart():
    for word in ("DIR", "SCENE.toml", "N", "KEY=VALUE", "I/N", "[STUDY]"):
        assert is_synopsis(words_of(f"repose x {word}")), word
    for word in ("out/N2", "units=SI", "a.toml", "--set", "2"):
        assert not is_synopsis(words_of(f"repose x {word}")), word


def test_wrong_commands_are_found(made, helps, tmp_path):
    with pytest.raises(AssertionError):
        check_dev(["./dev", "none"])
    with pytest.raises(AssertionError):
        check_options(["run", "x.toml", "--none"], helps)
    page = Command("README.md", 1, "")
    place = room(tmp_path, page, made)
    for words in (["run", "examples/none.toml"], ["run", "examples/heap.toml", "--set", "none=1"],
                  ["study", "run", "none"], ["plot", "out/heap", "--only", "none"],
                  ["theory", "osl", "--set", "none=1"]):
        assert run([PROGRAM, *cheap(words, page, made)], place).returncode != 0, words
