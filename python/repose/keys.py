# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Keys of a scene as attributes: `scene.contact.normal.stiffness`. What there is comes from the program."""

import keyword
from functools import cache
from typing import TYPE_CHECKING

import repose_compiled


@cache
def known_keys():
    """Every key of a scene by its dotted name: tuples of the kind of its value, unit, what is allowed, default and meaning; a
    key has several where it means different things. Keys of lists of tables are not among them."""
    known = {}
    for key, *rest in repose_compiled.scene_keys():
        if "[]" not in key:
            known.setdefault(key, []).append(tuple(rest))
    return known


@cache
def names_below(prefix):
    """The next steps of the keys that begin with `prefix` ("" or "contact."), in order."""
    steps = [key[len(prefix) :].split(".")[0] for key in known_keys() if key.startswith(prefix)]
    return list(dict.fromkeys(steps))


@cache
def lists_of_tables():
    """The lists of tables of a scene, each with the names of its keys."""
    lists = {}
    for key, *_ in repose_compiled.scene_keys():
        if "[]." in key:
            name, rest = key.split("[].", 1)
            lists.setdefault(name, []).append(rest)
    return lists


def as_attribute(name):
    """A step of a key as an attribute: words of Python get an underscore, `start.from_`."""
    return name + "_" if keyword.iskeyword(name) else name


class Keys:
    """The keys of a scene below a table; `dir()` and the Tab key list them."""

    def __init__(self, scene, prefix):
        object.__setattr__(self, "_scene", scene)
        object.__setattr__(self, "_prefix", prefix)

    def __dir__(self):
        return [as_attribute(name) for name in names_below(self._prefix)]

    if not TYPE_CHECKING:  # the classes of scene_keys.py say what there is

        def __getattr__(self, name):
            if name.startswith("_"):
                raise AttributeError(name)
            key = self._known(name)
            if names_below(key + "."):
                return Keys(self._scene, key + ".")
            return self._scene[key]

        def __setattr__(self, name, value):
            self._scene[self._known(name)] = value

    def __repr__(self):
        return f"<keys {self._prefix}*: {', '.join(dir(self))}>"

    def _known(self, name):
        known = names_below(self._prefix)
        for step in known:
            if as_attribute(step) == name:
                return self._prefix + step
        raise AttributeError(f"{self._prefix}{name}: unknown key; known here: {', '.join(known)}")
