# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every public name of the package has its docstring, and every public field a comment that the documentation shows."""

import ast
import inspect
import textwrap
import types

import pytest

import repose
from repose import theory

NAMES = {f"repose.{name}": getattr(repose, name) for name in repose.__all__}
OF_THEORY = {f"theory.{name}": thing for name, thing in vars(theory).items()
             if getattr(thing, "__module__", "") == theory.__name__ and not name.startswith("_")}  # fmt: skip
PUBLIC = NAMES | OF_THEORY
CLASSES = {name: thing for name, thing in PUBLIC.items() if inspect.isclass(thing)}


def own_docstring(thing):
    """The docstring of a thing itself: none that it inherits, nor the signature that a dataclass gets without one."""
    if inspect.isclass(thing):
        text = vars(thing).get("__doc__") or ""
        return "" if text.startswith(f"{thing.__name__}(") else text
    return getattr(thing, "__doc__", "") or ""


def public_members(kind):
    """(name, function or property) that a class itself defines for its users."""
    for name, thing in vars(kind).items():
        documented = isinstance(thing, (property, staticmethod, classmethod, types.FunctionType))
        if documented and not name.startswith("_"):
            yield name, getattr(thing, "__func__", thing)


def undocumented_fields(kind):
    """Names of public fields of a class without `#: meaning` on their line."""
    if kind.__module__ == "repose_compiled":
        return []
    lines, _ = inspect.getsourcelines(kind)
    tree = ast.parse(textwrap.dedent("".join(lines)))
    fields = [entry for entry in tree.body[0].body if isinstance(entry, ast.AnnAssign)]
    text = textwrap.dedent("".join(lines)).splitlines()
    return [field.target.id for field in fields
            if not field.target.id.startswith("_") and "#: " not in text[field.lineno - 1]]  # fmt: skip


@pytest.mark.parametrize("name", PUBLIC)
def test_a_public_name_has_a_docstring(name):
    assert own_docstring(PUBLIC[name]).strip(), name


@pytest.mark.parametrize("name", CLASSES)
def test_members_have_docstrings_and_fields_have_comments(name):
    bare = [member for member, thing in public_members(CLASSES[name]) if not own_docstring(thing).strip()]
    assert bare == [] and undocumented_fields(CLASSES[name]) == []


def test_what_is_missing_is_found():
    class Inherits(repose.Scene):
        def bare(self):
            pass

    assert own_docstring(Inherits) == "" and [name for name, thing in public_members(Inherits) if not thing.__doc__] == ["bare"]
    assert undocumented_fields(WithFields) == ["bare"]
    assert {"Scene", "Simulation", "Grains", "SweepFolder"} <= {kind.__name__ for kind in CLASSES.values()}
    assert {"theory.Model", "theory.predict"} <= OF_THEORY.keys()


class WithFields:
    """For the test above."""

    named: int  #: its meaning
    bare: int  # its meaning
    _own: int
