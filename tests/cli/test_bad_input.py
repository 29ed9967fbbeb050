# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Wrong scenes and wrong command lines: exit code 2, a helpful message, and no file written."""

import re

import pytest
from conftest import HEAP, number_in, summary

GRAIN = "[[grain]]\nposition = [0.0, 1.0]\n"
STOP = "[stop]\ntime = 1\n"


# the text, and parts that the message must contain
LATTICE = "[base]\nkind = 'row'\nhalf_width = 20\n[source]\nkind = 'lattice'\nrows = 5\n"

WRONG_SCENES = {
    "no automatic step": ("[contact]\nnormal = { law = 'hooke', stiffness = 1e-320 }\n" + GRAIN + "[grains]\nmass = 1e300\n" + STOP,
                          "method.time_step = \"auto\": finds no step"),
    "header without a key": ("seed = 1\n[?contact]\n", "scene.toml:2: a key must begin with a letter"),
    "accent outside text": ("# été\ntitle = 'été'\nété = 1\n", "scene.toml:3: letters beyond ASCII may stand in text"),
    "line break in a value": ("title = tru\nseed = 1\n", "scene.toml:1: Error while parsing boolean"),
    "lattice without rows": (LATTICE.replace("rows = 5\n", "") + STOP, "scene.toml:4: source.rows: missing"),
    "lattice without a base": ("[source]\nkind = 'lattice'\nrows = 5\n" + STOP, "scene.toml:2: source.kind = \"lattice\": needs a base"),
    "lattice wider than the base": (LATTICE.replace("5", "50") + STOP, "scene.toml:6: source.rows = 50: the pile must lie within"),
    "lattice too large": (LATTICE.replace("5", "500000") + STOP, "source.rows = 500000: must be at most 4000"),
    "lattice on a dense base": (LATTICE.replace("[source]", "spacing = 0.8\n[source]") + STOP,
                                "scene.toml:4: base.spacing = 0.8: must be 1 to 1.5 diameters"),
    "count of a lattice": (LATTICE + "count = 5\n" + STOP,
                           "scene.toml:7: source.count: unknown key; known here: base_count, break_at, columns, fixed_base, kind, rows"),
    "negative track": (GRAIN + STOP + "[output]\ntrack = -1\n", "output.track = -1: must be >= 0"),
    "no grains in an avalanche": (GRAIN + STOP + "[analysis]\navalanche = 0\n", "analysis.avalanche = 0: must be a whole number"),
    "unknown key at the top": ("gravitation = 1\n" + GRAIN + STOP, "scene.toml:1: gravitation: unknown key; known here:"),
    "unknown table": ("[sauce]\nkind = 'pour'\n" + GRAIN + STOP, "scene.toml:1: sauce: unknown key; known here:"),
    "unknown nested key": (
        "[contact]\nnormal = { law = 'hooke', stifness = 3 }\n" + GRAIN + STOP,
        "scene.toml:2: contact.normal.stifness: unknown key; known here: attraction, damping, law, restitution, "
        "stiffness, viscosity",
    ),
    "unknown key of a grain": (
        GRAIN + GRAIN + "radius = 1.0\n" + STOP,
        "scene.toml:5: grain[1].radius: unknown key; known here: diameter, fixed, material, position, spin, "
        "velocity",
    ),
    "key of another law": ("[contact.tangential]\nlaw = 'none'\nalpha = 1\n" + GRAIN + STOP,
                           "scene.toml:3: contact.tangential.alpha: unknown key; known here: law"),
    "text for a number": ("gravity = 'one'\n" + GRAIN + STOP,
                          'scene.toml:1: gravity = "one": must be a number, is text'),
    "number for text": ("title = 3\n" + GRAIN + STOP, "scene.toml:1: title = 3: must be text, is a whole number"),
    "fraction for a count": ("seed = 1.5\n" + GRAIN + STOP,
                             "scene.toml:1: seed = 1.5: must be a whole number, is a number"),
    "number for a flag": (GRAIN + "fixed = 1\n" + STOP,
                          "scene.toml:3: grain[0].fixed = 1: must be true or false, is a whole number"),
    "list of three": ("[[grain]]\nposition = [0, 1, 2]\n" + STOP,
                      "scene.toml:2: grain[0].position = [ 0, 1, 2 ]: must be a list of two numbers"),
    "list with text": ("[[grain]]\nposition = [0, 'a']\n" + STOP, "must be a list of two finite numbers"),
    "table for a number": ("[gravity]\nx = 1\n" + GRAIN + STOP, "scene.toml:1: gravity = "),
    "number for a table": ("contact = 0.5\n" + GRAIN + STOP,
                           "scene.toml:1: contact = 0.5: must be a table, is a number"),
    "table for a list of tables": ("[grain]\nposition = [0.0, 1.0]\n" + STOP, "a list of tables, each headed [[grain]]"),
    "date": ("gravity = 2026-01-01\n" + GRAIN + STOP, "gravity = 2026-01-01: must be a number, is a date or time"),
    "negative size": (GRAIN + "diameter = -1\n" + STOP, "scene.toml:3: grain[0].diameter = -1: must be > 0 [L]"),
    "size zero": ("[grains]\ndiameter = 0\n" + GRAIN + STOP, "scene.toml:2: grains.diameter = 0: must be > 0 [L]"),
    "zero count": (HEAP.replace("count = 40", "count = 0"),
                   "scene.toml:6: source.count = 0: must be a whole number from 1"),
    "huge count": (HEAP.replace("count = 40", "count = 9223372036854775808"), "scene.toml:6: "),
    "zero rate": (HEAP.replace("rate = 1.0", "rate = 0.0"), "scene.toml:7: source.rate = 0: must be > 0 [1/T]"),
    "negative seed": ("seed = -1\n" + GRAIN + STOP, "scene.toml:1: seed = -1: must be a whole number from 0"),
    "cutoff": ("[contact]\nnormal = { cutoff = 0.9 }\n" + GRAIN + STOP,
               "scene.toml:2: contact.normal.cutoff = 0.9: must be >= 1 [diameters]"),
    "polydispersity one": ("[grains]\npolydispersity = 1.5\n" + GRAIN + STOP,
                           "scene.toml:2: grains.polydispersity = 1.5: must be >= 0 and <"),
    "nan": ("gravity = nan\n" + GRAIN + STOP, "scene.toml:1: gravity = nan: must be a finite number"),
    "inf": (GRAIN + "[stop]\ntime = inf\n", "scene.toml:4: stop.time = inf: must be a finite number [T]"),
    "minus inf": (HEAP.replace("rate = 1.0", "rate = 1.0\nx = -inf"),
                  "scene.toml:8: source.x = -inf: must be a finite number [L]"),
    "nan in a list": ("[[grain]]\nposition = [nan, 1.0]\n" + STOP, "must be a list of two finite numbers"),
    "unknown word": ("[contact]\nnormal = { law = 'herz' }\n" + GRAIN + STOP,
                     'scene.toml:2: contact.normal.law = "herz": must be one of "continuous", "hooke", "hertz"'),
    "no stop": (GRAIN, "stop: missing: give time, at_rest or both"),
    "no grains": (STOP, "there are no grains"),
    "empty file": ("", "there are no grains"),
    "syntax error": (GRAIN + "diameter = = 1\n" + STOP, "scene.toml:3: "),
    "key twice": ("seed = 1\nseed = 2\n" + GRAIN + STOP, "scene.toml:2: "),
    "text not closed": ("title = \"abc\n" + GRAIN + STOP, "scene.toml:1: "),
}


@pytest.mark.parametrize("command", ["run", "check"])
@pytest.mark.parametrize("name", WRONG_SCENES)
def test_wrong_scene(lab, name, command):
    text, part = WRONG_SCENES[name]
    lab.scene(text)
    said = lab.refused(command, "scene.toml", parts=[part])
    assert len(said.strip().splitlines()) >= 1


@pytest.mark.parametrize("name", ["cutoff", "nan", "zero count", "negative size", "unknown word", "table for a number",
                                  "table for a list of tables", "number for a table", "nan in a list"])
def test_one_problem_gives_one_line(lab, name):
    lab.scene(WRONG_SCENES[name][0])
    said = lab.refused("run", "scene.toml")
    assert len(said.strip().splitlines()) == 1, said


def test_an_unstable_step_is_refused_with_the_largest_stable_one(lab):
    lab.scene(HEAP)
    options = ["--set", "method.time_step=0.1", "--set", "stop.time=0.5", "--out", "out"]
    said = lab.refused("run", "scene.toml", *options, parts=["--set method.time_step=0.1: method.time_step = 0.1: unstable"])
    largest = number_in(said, "not refused is")
    auto = number_in(said, '"auto" takes')
    assert 0.45 < auto / largest < 0.55
    options[1] = f"method.time_step={1.01 * largest}"
    lab.refused("run", "scene.toml", *options, parts=["unstable"])
    options[1] = f"method.time_step={0.999 * largest}"
    result = lab("run", "scene.toml", *options)
    assert result.returncode == 0, result.stderr


def largest_step_named(lab, settings):
    said = lab.refused("run", "scene.toml", "--set", "method.time_step=1", *settings)
    return re.search(r"not refused is ([-+0-9.e]+),", said).group(1)


@pytest.mark.parametrize("exponent", [36, 50, 80, 144])
def test_the_very_step_that_the_message_names_is_accepted(lab, exponent):
    lab.scene(HEAP)
    settings = ["--set", f"contact.normal.exponent={exponent}"]
    step = largest_step_named(lab, settings)
    result = lab("check", "scene.toml", *settings, "--set", f"method.time_step={step}")
    assert result.returncode == 0, result.stderr


def test_unstable_step_in_the_file_has_its_line(lab):
    lab.scene("[method]\ntime_step = 0.1\n" + HEAP)
    lab.refused("run", "scene.toml", parts=["scene.toml:2: method.time_step = 0.1: unstable"])


def test_scene_file_that_is_missing_a_folder_or_not_text(lab):
    lab.refused("run", "absent.toml", parts=["absent.toml: cannot read: No such file or directory"])
    (lab.path / "folder").mkdir()
    lab.refused("run", "folder", parts=["folder: cannot read: is a folder"])
    lab.refused("run", "folder/absent/deeper.toml", parts=["cannot read: No such file or directory"])
    (lab.path / "rubbish.toml").write_bytes(bytes(range(256)) * 40)
    lab.refused("run", "rubbish.toml", parts=["rubbish.toml:"])
    (lab.path / "zeros.toml").write_bytes(bytes(4096))
    lab.refused("run", "zeros.toml", parts=["zeros.toml:1: "])
    lab.refused("run", "rubbish.toml/below", parts=["cannot read: Not a directory"])


def test_scene_file_with_a_name_too_long(lab):
    lab.refused("run", "x" * 300 + ".toml", parts=["cannot read: File name too long"])


SETTINGS = {
    "no equals": ("gravity", "--set gravity: must be KEY=VALUE"),
    "no key": ("=3", "--set =3: must be KEY=VALUE"),
    "empty": ("", "must be KEY=VALUE"),
    "unknown key": ("gravty=3", "--set gravty=3: gravty: unknown key"),
    "no value": ("gravity=", "gravity"),
    "wrong type": ("gravity=heavy", '--set gravity=heavy: gravity = "heavy": must be a number, is text'),
    "out of bounds": ("source.count=-3", "--set source.count=-3: source.count = -3: must be a whole number from 1"),
    "below a value": ("source.count.more=3", '"count" is not a table'),
    "dots only": ("...=3", "--set ...=3: "),
    "dot at the end": ("source.=3", "--set source.=3: "),
    "two values": ("gravity=1\nseed=5", "--set gravity=1"),
    "index": ("grain[0].diameter=2", "--set grain[0].diameter=2: "),
    "replaces a table": ("source=3", "--set source=3: source = 3: must be a table"),
}


@pytest.mark.parametrize("name", SETTINGS)
def test_wrong_setting(lab, name):
    setting, part = SETTINGS[name]
    lab.scene(HEAP)
    lab.refused("run", "scene.toml", "--set", setting, parts=[part])


@pytest.mark.parametrize("options", [
    ["--threads", "0"], ["--threads", "-1"], ["--threads", "two"], ["--threads", "100000"], ["--fast"], ["--seed", "x"],
    ["--seed", "1.5"], ["--seed", "-1"], ["--seed", "99999999999999999999"], ["--set"], ["--out"], ["second.toml"],
])
def test_wrong_option(lab, options):
    lab.scene(HEAP)
    said = lab.refused("run", "scene.toml", *options)
    assert said.strip(), "no message"
    assert options[0].lstrip("-") in said


def test_wrong_command(lab):
    lab.refused()
    lab.refused("run", parts=["SCENE"])
    lab.refused("fly", parts=["fly"])


def test_all_problems_of_scene_and_folder_at_once(lab):
    lab.scene("""gravity = -1
[contact]
frictoin = 0.4
normal = { cutoff = 0.9 }
[source]
kind = "pour"
count = 0
rate = "fast"
[stop]
time = 1
""")
    (lab.path / "full").mkdir()
    (lab.path / "full/letter.txt").write_text("dear\n")
    said = lab.refused("run", "scene.toml", "--out", "full", parts=[
        "scene.toml:1: gravity = -1", "scene.toml:3: contact.frictoin", "scene.toml:4: contact.normal.cutoff",
        "scene.toml:7: source.count", 'scene.toml:8: source.rate = "fast"', "full: folder is not empty"])
    assert len(said.strip().splitlines()) == 6, said


# --- numbers far outside any sensible range: they are refused, or run correctly

@pytest.mark.parametrize("setting", ["base.half_width=1e12", "base.spacing=1e-10"])
def test_a_base_of_too_many_grains_is_refused(lab, setting):
    lab.scene(HEAP)
    lab.refused("run", "scene.toml", "--set", setting, "--out", "out", before="ulimit -v 1000000", parts=["base."])


@pytest.mark.parametrize("key", ["output.series", "output.frames", "output.window", "stop.time"])
@pytest.mark.parametrize("value", ["1e18", "1e99"])
def test_a_very_late_time_is_never_reached(lab, key, value):
    """A very late time must not overflow into the first step."""
    lab.scene(HEAP.replace("time = 500", "time = 80"))
    result = lab("run", "scene.toml", "--set", f"{key}={value}", "--out", "out", "--quiet")
    if result.returncode == 2:
        assert key in result.stderr
        return
    assert result.returncode == 0, result.stderr
    numbers = summary(lab.path / "out")
    assert numbers["time"] > 40, f"stopped at time {numbers['time']}: {numbers['stop_reason']}"
    frames = lab.path / "out/frames"
    assert key != "output.frames" or not frames.exists() or not list(frames.iterdir())


def test_a_very_low_rate_releases_one_grain(lab):
    lab.scene(HEAP.replace("time = 500", "time = 20"))
    result = lab("run", "scene.toml", "--set", "source.rate=1e-99", "--out", "out", "--quiet")
    assert result.returncode == 2 or summary(lab.path / "out")["grains_released"] == 1


def test_a_grain_far_outside_of_a_periodic_box_does_not_hang(lab):
    lab.scene("[[grain]]\nposition = [1e17, 0.5]\n[box]\nx = 'periodic'\nhalf_width = 5\n[stop]\ntime = 1\n")
    assert lab("run", "scene.toml", "--out", "out", "--quiet").returncode in (0, 2)
