# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Help, manual page and shell completion: complete, true to each other, and their examples run."""

import re
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import HEAP, LIMIT, PROGRAM, repose

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"

# Quick scenes under the names that the examples use.
QUICK = {
    "heap.toml": HEAP + "[output]\nframes = 40\n",
    "heap-cd.toml": '[method]\nkind = "contact-dynamics"\n' + HEAP.replace("time = 500", "time = 15"),
    "sweeps/spacing.toml": 'scene = "../heap.toml"\nseeds = 2\n[set]\nsource.count = 20\n[vary]\n'
    "base.spacing = [1.0, 1.1]\n",
    "calibrations/angle.toml": 'scene = "../heap.toml"\nseeds = 2\n[[parameter]]\nkey = "contact.friction"\n'
    'range = [0.1, 0.8]\n[[target]]\nmeasure = "coordination"\nvalue = 4.3\nerror = 1.0\n[design]\nstart = 4\nmost = 4\n',
}


def printed(*words):
    result = repose(*words)
    assert result.returncode == 0 and result.stderr == "", result.stderr
    return result.stdout


def section(help_text, name):
    """The lines of a section of a help text, without their indent of two."""
    body = re.search(rf"^{name}\n((?:  .*\n)+)", help_text, flags=re.M)
    assert body, f"no {name} in {help_text}"
    return [line[2:] for line in body.group(1).splitlines()]


def names_in(lines):
    return [line.split()[0] for line in lines if not line.startswith(" ")]


VERBS = ["scene", "check", "run", "resume", "sweep", "calibrate", "study", "analyse", "plot", "view", "theory", "export", "solve",
         "reference"]


def examples_of(*verb):
    return [line for line in section(printed(*verb, "--help"), "Examples") if not line.startswith(" ")]


def all_examples():
    """The commands of all examples once each, in the order of the help."""
    return list(dict.fromkeys(command for verb in [[], *([verb] for verb in VERBS)] for command in examples_of(*verb)))


def test_the_help_lists_every_verb():
    listed = names_in(section(printed("--help"), "Verbs"))
    assert listed == VERBS
    for verb in listed:
        assert f"Usage: repose {verb}" in printed(verb, "--help")


@pytest.mark.parametrize("verb", VERBS)
def test_the_help_of_a_verb_shows_examples_of_it(verb):
    commands = examples_of(verb)
    assert any(command.startswith(f"repose {verb} ") for command in commands)
    assert all(command.startswith("repose ") for command in commands)


@pytest.mark.parametrize("words", [[], *([verb] for verb in VERBS)])
def test_the_help_fits_a_terminal(words):
    assert max(map(len, printed(*words, "--help").splitlines())) <= 88


def test_files_in_examples_exist_and_their_scenes_are_valid():
    scenes = 0
    for command in all_examples():
        words = shlex.split(command)
        for word in words:
            if word.startswith("examples/"):
                assert (EXAMPLES.parent / word).is_file(), command
        if words[1] in ("run", "check") and words[2].startswith("examples/"):
            settings = [word for at, word in enumerate(words) if words[at - 1] == "--set" or word == "--set"]
            printed("check", EXAMPLES.parent / words[2], *settings)
            scenes += 1
    assert scenes >= 4


def test_all_examples_run_one_after_the_other(lab):
    for name, text in QUICK.items():
        (lab.path / "examples" / name).parent.mkdir(parents=True, exist_ok=True)
        (lab.path / "examples" / name).write_text(text)
    for command in all_examples():
        words = shlex.split(command)
        if words[1] == "plot" and "--only" not in words:  # one picture stands for all
            command += " --only " + ("theory" if "--theory" in words else "angle" if words[2] == "spacing" else "heap")
        prefix = "timeout --foreground --preserve-status --signal INT 2 " if words[1] == "view" else ""  # which does not end by itself
        shell = f'repose() {{ {prefix}{shlex.quote(PROGRAM)} "$@"; }}\n{command}'
        result = subprocess.run(["bash", "-c", shell], cwd=lab.path, capture_output=True, text=True, timeout=LIMIT)
        assert result.returncode == 0, f"{command}: {result.stderr}"
    written = ["my-heap.toml", "heap/pictures/heap.png", "heap/pictures/theory.png", "heap/pictures/chains.png", "theory.png",
               "rough/run.h5", "angle/calibration.json", "spacing/table.csv", "cluster/slurm/batch.sh", "spacing/pictures/angle.png", "heap/export/vtk/grains.pvd", "heap/export/html/run.html", "heap/export/movie/heap.mp4",
               "tables/grains.csv", "ife.csv", "ife.png"]
    missing = [name for name in written if not (lab.path / name).is_file()]
    assert not missing


def options_of(verb):
    return names_in(section(printed(verb, "--help"), "Options"))


def test_manual_page_has_every_verb_option_and_example():
    page = printed("--man").replace("\\-", "-")
    for verb in VERBS:
        part = re.search(rf"^\.SS repose {verb} .*\n((?:(?!\.S[SH]).*\n)+)", page, flags=re.M).group(1)
        for option in set(options_of(verb)) - {"--help"}:
            assert re.search(rf"^\.B {option}\b", part, flags=re.M), f"{verb} {option}"
        for command in examples_of(verb):
            assert f"\n{command}\n" in part


@pytest.mark.skipif(not shutil.which("groff"), reason="no groff here")
def test_manual_page_is_good_troff():
    page = printed("--man")
    result = subprocess.run(["groff", "-man", "-ww", "-Tascii"], input=page, capture_output=True, text=True, timeout=LIMIT)
    assert result.returncode == 0 and result.stderr == "" and "REPOSE(1)" in result.stdout


def completions(*words, cwd=None):
    """What bash offers for the last word of a command line."""
    line = ["repose", *words]
    script = printed("--completion", "bash") + (
        f"COMP_WORDS=({shlex.join(line)}); COMP_CWORD={len(line) - 1}\n_repose\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n"
    )
    result = subprocess.run(["bash", "-u", "-c", script], cwd=cwd, capture_output=True, text=True, timeout=LIMIT)
    assert result.returncode == 0 and result.stderr == "", result.stderr
    return set(result.stdout.split("\n")) - {""}


def test_bash_completes_verbs_options_and_words():
    assert completions("") >= {*VERBS, "--version", "--help"}
    assert completions("the") == {"theory"}
    for verb in VERBS:
        assert completions(verb, "--") == set(options_of(verb))
    assert completions("export", "heap", "--to", "") == {"vtk", "ovito", "csv", "html", "movie", "contact-problem"}
    assert completions("theory", "pile-") == {"pile-continuum", "pile-lattice", "pile-tent"}
    assert completions("--completion", "") == {"bash", "zsh"}
    assert completions("run", "heap.toml", "--seed", "") == set()


def test_bash_completes_scenes_and_folders(tmp_path):
    (tmp_path / "heap.toml").touch()
    (tmp_path / "my scene.toml").touch()
    (tmp_path / "notes.txt").touch()
    (tmp_path / "out").mkdir()
    assert completions("run", "", cwd=tmp_path) == {"heap.toml", "my scene.toml", "out"}
    assert completions("run", "heap.toml", "--out", "", cwd=tmp_path) == {"out"}
    assert completions("plot", "", cwd=tmp_path) == {"out"}
    assert completions("solve", "", cwd=tmp_path) == {"heap.toml", "my scene.toml", "notes.txt", "out"}


def test_zsh_completion_has_every_verb_and_option():
    script = printed("--completion", "zsh")
    assert script.startswith("#compdef repose\n")
    for verb in VERBS:
        part = re.search(rf"^ +{verb}\) _arguments(.*?);;", script, flags=re.M | re.S).group(1)
        assert set(re.findall(r"'\*?(--[a-z-]+)\[", part)) == set(options_of(verb))


@pytest.mark.parametrize("words, message", [
    (["run"], "repose run: SCENE is required (`repose run --help`"),
    (["run", "x.toml", "--threads", "0"], 'repose run: --threads: must be a whole number from 1 to 1024, is "0"'),
    (["run", "x.toml", "--seed", "1.5"], '--seed: must be a whole number, is "1.5"'),
    (["run", "x.toml", "--out"], "repose run: --out: needs a value"),
    (["run", "x.toml", "--out", "a", "--out", "b"], "repose run: --out: is given more than once"),
    (["export", "x", "--to", "obj"], '--to: must be one of vtk, ovito, csv, html, movie, contact-problem, is "obj"'),
    (["export", "x"], "repose export: --to is required"),
    (["solve", "x", "--tolerance", "nan"], '--tolerance: must be a number >= 0, is "nan"'),
    (["solve", "x", "--most-sweeps", "-1"], '--most-sweeps: must be a whole number >= 0, is "-1"'),
    (["fly"], "repose: The following argument was not expected: fly (`repose --help`"),
])
def test_a_wrong_command_line_is_answered_in_one_line(lab, words, message):
    said = lab.refused(*words, parts=[message])
    assert len(said.splitlines()) == 1
