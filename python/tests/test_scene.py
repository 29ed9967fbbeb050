# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as Python objects: the keys, the checks and the messages of scene files."""

import doctest
import subprocess

import numpy as np
import pytest

import repose
from repose import keys, scene as scene_module
from repose.program import program
from repose.scene_keys import SceneKeys
from repose.toml_text import toml_text

TABLES = {
    "base": {"kind": "row", "half_width": 8.0},
    "source": {"kind": "pour", "count": 40, "rate": 1.0, "height": 10.0, "half_width": 2.0},
    "plane": [{"point": [-9.0, 0.0], "normal": [1.0, 0.0]}],
    "stop": {"at_rest": 1e-6, "time": 500.0},
}
TOML = """[base]
kind = "row"
half_width = 8.0
[source]
kind = "pour"
count = 40
rate = 1.0
height = 10.0
half_width = 2.0
[stop]
at_rest = 1e-6
time = 500.0
[[plane]]
point = [-9.0, 0.0]
normal = [1.0, 0.0]
"""


def test_examples_of_the_documentation():
    assert doctest.testmod(scene_module).failed == 0


def test_dicts_text_and_file_make_the_same_scene(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_text(TOML)
    whole = repose.Scene(TABLES).text()
    assert whole == repose.Scene.from_text(TOML).text() == repose.Scene.from_file(file).text()
    assert repose.Scene.from_text(whole).text() == whole


def test_keys_are_attributes_and_items_with_the_values_of_a_run():
    scene = repose.Scene(TABLES)
    assert scene.source.count == 40 and scene["source.count"] == 40
    assert scene.contact.friction == 0.5  # a default
    scene.contact.normal = {"law": "hooke", "stiffness": np.float64(700.0)}
    scene.source.count = np.int64(41)
    assert (scene.contact.normal.law, scene.contact.normal.stiffness, scene.source.count) == ("hooke", 700.0, 41)
    assert [plane["normal"] for plane in scene.plane] == [[1.0, 0.0]] and scene.wall == []
    scene.add("plane", point=[9.0, 0.0], normal=[-1.0, 0.0])
    assert [plane["normal"] for plane in scene["plane"]] == [[1.0, 0.0], [-1.0, 0.0]]


def test_a_table_that_is_set_replaces_its_keys():
    scene = repose.Scene(TABLES)
    scene.contact.normal = {"law": "hooke", "stiffness": 700.0}
    scene.contact.normal.stiffness = 800.0
    assert scene.contact.normal.stiffness == 800.0
    scene.contact.normal = {"law": "hooke", "stiffness": 900.0}
    assert scene.contact.normal.stiffness == 900.0


def test_tab_completion_knows_the_keys():
    scene = repose.Scene(TABLES)
    assert {"contact", "source", "base", "seed", "plane"} <= set(dir(scene))
    assert {"friction", "normal", "tangential"} <= set(dir(scene.contact))
    assert {"law", "stiffness", "exponent"} <= set(dir(scene.contact.normal))
    with pytest.raises(AttributeError, match="contact.frictoin: unknown key; known here: friction, normal, "):
        scene.contact.frictoin = 1.0
    with pytest.raises(AttributeError, match="contcat: unknown key"):
        scene.contcat  # noqa: B018
    with pytest.raises(KeyError, match="contact.frictoin"):
        scene["contact.frictoin"] = 1.0
    with pytest.raises(KeyError, match="plain: no list of tables; there are"):
        scene.add("plain", point=[0, 0])


def test_the_classes_of_the_keys_have_what_the_program_knows():
    """scene_keys.py is written by ./dev docs; a stale one would mislead editors and mypy."""

    def annotated(cls, prefix=""):
        import repose.scene_keys as module

        for name, kind in cls.__annotations__.items():
            if kind.startswith("list[dict"):
                assert name in keys.lists_of_tables()
            elif kind.endswith("Keys"):
                yield from annotated(getattr(module, kind), f"{prefix}{name}.")
            else:
                yield prefix + name.rstrip("_")

    assert sorted(annotated(SceneKeys)) == sorted(keys.known_keys())


@pytest.mark.parametrize("key, value", [("contact.friction", -1.0), ("base.kind", "rwo"), ("source.count", 1.5)])
def test_the_messages_are_those_of_the_program(tmp_path, key, value):
    scene = repose.Scene.from_text(TOML)
    scene[key] = value
    with pytest.raises(ValueError) as raised:
        scene.check()
    file = tmp_path / "scene.toml"
    file.write_text(TOML)
    checked = subprocess.run([program(), "check", file, "--set", f"{key}={toml_text(value)}"], capture_output=True,
                             text=True, check=False)
    assert checked.returncode == 2
    said = checked.stderr.strip().splitlines()[0].split(": ", 1)[1]
    assert said in str(raised.value)
    scene[key] = scene_value(key)  # a problem that is mended is gone
    scene.check()


def scene_value(key):
    return {"contact.friction": 0.5, "base.kind": "row", "source.count": 40}[key]


def test_all_problems_are_said_at_once():
    scene = repose.Scene.from_text(TOML)
    scene.contact.friction = -1.0
    scene.source.count = 0
    with pytest.raises(repose.InputError) as raised:
        repose.Simulation(scene)
    assert len(str(raised.value).splitlines()) == 2


def test_a_copy_is_its_own():
    scene = repose.Scene(TABLES)
    other = scene.copy()
    other.source.count = 7
    assert (scene.source.count, other.source.count) == (40, 7)


def test_values_as_toml():
    assert toml_text({"a b": [1, 2.5, "x\"y", True, 1e-300, float("inf")]}) == '{ "a b" = [1, 2.5, "x\\"y", true, 1e-300, inf] }'
    assert toml_text(np.array([1.0, 2.0])) == "[1.0, 2.0]"
    with pytest.raises(TypeError, match="no value of a scene"):
        toml_text(object())


def test_every_example_can_be_had():
    names = repose.example_scenes()
    assert "heap" in names and len(names) > 20
    for name in names:
        repose.Scene.example(name)
