# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Careless and hostile command lines and scenes: closed and full streams, odd numbers, scenes beyond any machine."""

import os

import pytest
from conftest import HEAP, summary

GRAIN = "[[grain]]\nposition = [0.0, 1.0]\n"
STOP = "[stop]\ntime = 1\n"
SMALL = HEAP.replace("count = 40", "count = 3")
LONG = HEAP.replace("at_rest = 1e-6\n", "").replace("time = 500", "time = 1e6")


# --- streams

VERBS_THAT_FAIL = ["check none.toml", "run none.toml", "resume none", "sweep none.toml", "analyse none", "plot none",
                   "theory none", "export none --to csv", "solve none.h5", "reference none", "fly", "run", ""]


@pytest.mark.parametrize("words", VERBS_THAT_FAIL)
@pytest.mark.parametrize("closed", ["2>&-", ">&- 2>&-", "<&- >&- 2>&-", "2>/dev/full"])
def test_the_exit_status_of_bad_input_survives_closed_streams(lab, words, closed):
    result = lab.shell(f"$REPOSE {words} {closed}")
    assert result.returncode == 2, result


def test_a_closed_stream_is_not_taken_by_a_file(lab):
    """What is meant for a closed stream must not land in a file that got its number."""
    lab.scene(SMALL)
    assert lab.shell("$REPOSE run scene.toml --out out >&- 2>&-").returncode == 0
    assert summary(lab.path / "out")["status"] == "finished"
    assert lab("analyse", "out").returncode == 0


PRINTING = ["check scene.toml", "theory pile-continuum", "theory --list", "scene", "scene heap", "reference summary",
            "--help", "--version", "--man", "--completion bash", "run --help"]


@pytest.mark.parametrize("words", PRINTING)
def test_a_full_device_is_a_failure(lab, words):
    lab.scene(SMALL)
    result = lab.shell(f"$REPOSE {words} >/dev/full")
    assert result.returncode == 1
    assert result.stderr == "repose: standard output: cannot be written: No space left on device\n"


@pytest.mark.parametrize("words", PRINTING)
def test_a_reader_that_leaves_is_no_failure(lab, words):
    lab.scene(SMALL)
    result = lab.shell(f"$REPOSE {words} | true; exit ${{PIPESTATUS[0]}}")
    assert (result.returncode, result.stderr) == (0, "")


def test_a_reader_that_leaves_does_not_end_a_run(lab):
    lab.scene(SMALL)
    result = lab.shell("$REPOSE run scene.toml --out out | true; exit ${PIPESTATUS[0]}")
    assert result.returncode == 0 and summary(lab.path / "out")["status"] == "finished"


def test_the_first_of_many_problems_and_their_number(lab):
    lab.scene("".join(f"key{k} = 1\n" for k in range(20000)) + GRAIN + STOP)
    lines = lab.refused("check", "scene.toml").splitlines()
    assert len(lines) == 51 and lines[-1] == "... and 19950 more problems"


# --- what is typed

@pytest.mark.parametrize("seed", ["", "0x5", "1e3", " 7", "7 ", "+7", "9223372036854775808", "1_000", "nan"])
def test_seeds_are_decimal_whole_numbers(lab, seed):
    lab.scene(SMALL)
    lab.refused("check", "scene.toml", "--seed", seed, parts=[f'--seed: must be a whole number, is "{seed}"'])


def test_a_seed_with_zeros_before_it_is_decimal(lab):
    lab.scene(SMALL)
    assert lab("run", "scene.toml", "--seed", "010", "--out", "out", "--quiet").returncode == 0
    assert summary(lab.path / "out")["seed"] == 10


@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "1e999", "", "-1"])
def test_tolerances_are_finite_numbers(lab, number):
    lab.refused("solve", "none.h5", f"--tolerance={number}", parts=["--tolerance"])


def test_more_threads_than_cores_or_grains_are_of_no_use(lab):
    lab.scene(HEAP.replace("count = 40", "count = 10"))
    result = lab("run", "scene.toml", "--threads", "1024", "--out", "out", "--quiet")
    assert result.returncode == 0 and summary(lab.path / "out")["threads"] <= os.cpu_count()


# --- scenes

def test_a_load_on_a_grain_that_never_exists_is_refused(lab):
    load = "[[load]]\ngrain = {}\nforce = [0.0, -1.0]\n"
    last = 17 + 40 - 1  # base grains at x = -8 .. 8, then those that are poured
    for grain in (last + 1, 999999):
        lab.scene(HEAP + load.format(grain))
        lab.refused("check", "scene.toml", parts=[f"load[0].grain = {grain}: no such grain; ids go from 0 to {last}"])
    lab.scene(HEAP + load.format(3))
    lab.refused("check", "scene.toml", parts=["load[0].grain = 3: this grain is fixed"])
    lab.scene(HEAP + load.format(last))
    assert lab("check", "scene.toml").returncode == 0


def test_a_load_on_a_grain_that_a_start_does_not_bring_is_refused(lab):
    lab.run(SMALL)
    lab.scene("[start]\nfrom = 'out'\n[[load]]\ngrain = 500\nforce = [0.0, -1.0]\n" + STOP, "again.toml")
    lab.refused("run", "again.toml", "--out", "again", parts=["load[0].grain = 500: no such grain; ids go from 0 to 19"])


def test_a_mark_of_byte_order_is_read(lab):
    (lab.path / "scene.toml").write_bytes(b"\xef\xbb\xbf" + SMALL.replace("\n", "\r\n").encode())
    assert lab("check", "scene.toml").returncode == 0
    (lab.path / "scene.toml").write_bytes(SMALL.encode("utf-16"))
    lab.refused("check", "scene.toml", parts=["scene.toml: cannot read: is UTF-16; save it as UTF-8"])


def test_a_title_beyond_what_files_hold_is_refused(lab):
    lab.scene(f"title = '{'x' * 70000}'\n" + SMALL)
    lab.refused("check", "scene.toml", parts=["scene.toml:1: title: has 70000 bytes; must have at most 60000"])
    lab.run(f"title = '{'x' * 60000}'\n" + SMALL)


LENGTHS = {"bin_width": (0.01, 1e6), "base_bin": (0.01, 1e6), "field_width": (0.05, 1e4)}


@pytest.mark.parametrize("key", LENGTHS)
@pytest.mark.parametrize("value", ["1e-300", "1e-6", "1e308"])
def test_lengths_of_the_analysis_have_bounds(lab, key, value):
    lab.scene(SMALL)
    lab.refused("check", "scene.toml", "--set", f"analysis.{key}={value}", parts=[f"analysis.{key} = ", "diameters"])


@pytest.mark.parametrize("key, end", [(key, end) for key, ends in LENGTHS.items() for end in ends])
def test_the_analysis_within_its_bounds_ends(lab, key, end):
    lab.run(SMALL + f"[analysis]\n{key} = {end}\n")


@pytest.mark.parametrize("setting", ["direction_bins=2000000000", "contact_gap=1000"])
def test_counts_of_the_analysis_have_bounds(lab, setting):
    lab.scene(SMALL)
    lab.refused("check", "scene.toml", "--set", "analysis.packing=true", "--set", f"analysis.{setting}", parts=["must be"])


def test_memory_is_foreseen(lab):
    """A track of every step of ten million times sqrt(d/g) is refused, before anything is written."""
    lab.scene(LONG)
    settings = ["--set", "output.track=1e-9", "--set", "stop.time=1e7"]
    for verb in ("check", "run"):
        lab.refused(verb, "scene.toml", *settings, parts=["scene.toml: needs about", "GB of memory, this machine has"])
    assert "GB of memory" in lab("check", "scene.toml").stdout


def test_a_run_stops_at_rest_whatever_the_rows_of_its_series(lab):
    text = SMALL.replace("time = 500\n", "") + "[output]\nseries = 1e12\n"
    found = summary(lab.run(text))
    assert found["status"] == "finished" and found["time"] < 100
