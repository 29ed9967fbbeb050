# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as objects, with the keys, the checks and the messages of scene files.

>>> import repose
>>> scene = repose.Scene.example("heap")
>>> scene.contact.friction = 0.3
>>> scene["source.count"] = 200
>>> scene.contact.friction, scene.base.kind
(0.3, 'row')
"""

import copy
import tomllib
from os import fspath
from typing import TYPE_CHECKING

import repose_compiled
from repose.keys import Keys, known_keys, lists_of_tables, names_below
from repose.scene_keys import SceneKeys
from repose.toml_text import toml_key, toml_text


class Scene(SceneKeys):
    """A scene to run. Its keys are attributes (`scene.contact.friction`) and items (`scene["contact.friction"]`), in the
    units of the scene; docs/reference/scene.md lists them. A key that is read has the value that a run would use,
    defaults too. What is set is checked as a whole by `check`, by reading a key and by a simulation: ValueError then, with
    a line for each problem in the words of the program. An unknown key is an AttributeError or a KeyError at once."""

    def __init__(self, tables=None):
        """A scene from nested dicts, as in a scene file: {"base": {"kind": "row"}, "plane": [{...}]}; empty without."""
        super().__init__(self, "")
        object.__setattr__(self, "_text", "")
        object.__setattr__(self, "_path", None)
        object.__setattr__(self, "_settings", {})
        object.__setattr__(self, "_checked", None)
        for name, value in (tables or {}).items():
            self._take(name, value)

    @classmethod
    def from_file(cls, path):
        """The scene of a file. Paths in it are relative to the file."""
        scene = cls()
        object.__setattr__(scene, "_path", fspath(path))
        scene.check()
        return scene

    @classmethod
    def from_text(cls, toml):
        """The scene of a text in TOML. Paths in it are relative to the current folder."""
        scene = cls()
        object.__setattr__(scene, "_text", toml)
        scene.check()
        return scene

    @classmethod
    def example(cls, name):
        """A scene that comes with the program; `example_scenes()` names them."""
        return cls.from_text(repose_compiled.example_text(name))

    def check(self):
        """ValueError with a line for every problem of the scene; returns the scene if there is none."""
        self._compiled()
        return self

    def text(self):
        """The scene file with every key, as a run folder keeps it."""
        return self._compiled().text()

    def add(self, table, **keys):
        """Appends a table to a list of tables: scene.add("plane", point=[0, 0], normal=[0, 1])."""
        lists = lists_of_tables()
        if table not in lists:
            raise KeyError(f"{table}: no list of tables; there are {', '.join(lists)}")
        lines = [f"{toml_key(key)} = {toml_text(value)}\n" for key, value in keys.items()]
        self._change(text=self._text + f"\n[[{table}]]\n" + "".join(lines))
        return self

    def copy(self):
        """A scene of its own with the same keys."""
        return copy.deepcopy(self)

    def __deepcopy__(self, memo):
        scene = Scene()
        for name in ("_text", "_path", "_checked"):
            object.__setattr__(scene, name, getattr(self, name))
        object.__setattr__(scene, "_settings", dict(self._settings))
        return scene

    def __getitem__(self, key):
        """The value of a key: bool, int, float, text or list; a dict of a table, a list of dicts of a list of tables."""
        value = tomllib.loads(self.text())
        for step in key.split("."):
            if not isinstance(value, dict) or step not in value:
                raise KeyError(f"{key}: the scene has no such key")
            value = value[step]
        return value

    def __setitem__(self, key, value):
        if key not in known_keys() and not names_below(key + "."):
            raise KeyError(f"{key}: unknown key of a scene")
        below = [old for old in self._settings if old == key or old.startswith(key + ".")]
        settings = {old: text for old, text in self._settings.items() if old not in below}
        self._change(settings=settings | {key: toml_text(value)})

    if not TYPE_CHECKING:

        def __getattr__(self, name):
            if name in lists_of_tables():
                return tomllib.loads(self.text()).get(name, [])
            return super().__getattr__(name)

    def __dir__(self):
        return [*object.__dir__(self), *super().__dir__(), *lists_of_tables()]

    def __repr__(self):
        return f"<Scene {self._path or ''}{' with ' if self._settings else ''}{', '.join(self._settings)}>"

    def _take(self, name, value):
        if isinstance(value, dict):
            for key, entry in value.items():
                self._take(f"{name}.{key}", entry)
        elif isinstance(value, (list, tuple)) and name in lists_of_tables():
            for entry in value:
                self.add(name, **entry)
        else:
            self[name] = value

    def _change(self, text=None, settings=None):
        if text is not None:
            if self._path is not None:
                raise ValueError("a scene of a file has no tables to add to: put them into the file, or use from_text")
            object.__setattr__(self, "_text", text)
        if settings is not None:
            object.__setattr__(self, "_settings", settings)
        object.__setattr__(self, "_checked", None)

    def _compiled(self):
        """The checked scene."""
        if self._checked is None:
            settings = list(self._settings.items())
            made = (
                repose_compiled.Scene(self._text, settings)
                if self._path is None
                else repose_compiled.Scene.from_file(self._path, settings)
            )
            object.__setattr__(self, "_checked", made)
        return self._checked


def example_scenes():
    """Title of every scene that comes with the program, by name."""
    return dict(repose_compiled.example_names())
