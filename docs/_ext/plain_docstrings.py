# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Docstrings are plain text: their indented blocks are code, and types lead to the page that documents them."""

import re
from types import ModuleType

from sphinx.util import logging
from sphinx.util.nodes import make_refnode

import repose

logger = logging.getLogger(__name__)


def indented(line):
    """Whether a line of a docstring is indented."""
    return line.startswith("    ")


def with_code(lines):
    """The lines of a docstring, with a mark before each indented block that follows a paragraph."""
    made = []
    for before, line in zip([""] + lines, lines):
        above = next((text for text in reversed(made) if text.strip()), "")
        plain = not indented(above) and not above.endswith("::") and not above.startswith("..")
        if indented(line) and not before.strip() and plain:
            made += ["::", ""]
        made.append(line)
    return made


def with_shapes(lines):
    """The lines of a docstring, in which a shape at the start, as in "(N) ids", is no item of a list."""
    return [re.sub(r"^\((\w)\) ", r"\\(\1) ", line) for line in lines]


def process(_, kind, __, documented, ___, lines):
    """Autodoc calls this with the lines of each docstring, without the indentation that all of them have."""
    if kind == "module" and documented.__doc__:
        lines[:] = documented.__doc__.splitlines() + [""]
    lines[:] = with_code(with_shapes(lines))


def find_public_name(app, _, node, text):
    """A link to a class by the module that defines it leads to the name under which the package offers it."""
    target = node.get("reftarget", "")
    if node.get("refdomain") != "py" or not target.startswith("repose."):
        return None
    public = "repose." + target.rsplit(".", 1)[-1]
    found = app.env.domains["py"].objects.get(public)
    if found is None or public == target:
        return None
    return make_refnode(app.builder, node["refdoc"], found.docname, found.node_id, text, public)


def check_public_names(_, env):
    """Warns of public names of the package that have no entry: autodoc leaves out silently what cannot be imported."""
    objects = env.domains["py"].objects
    if "reference/python" not in env.found_docs:
        return
    for name in repose.__all__:
        try:
            has_entry = f"repose.{name}" in objects or isinstance(getattr(repose, name), ModuleType)
            reason = "" if has_entry else "no such entry"
        except Exception as error:
            reason = str(error)
        if reason:
            logger.warning("repose.%s is public, but not on the page: %s", name, reason, location="reference/python")


def setup(app):
    """Sphinx calls this first."""
    app.connect("autodoc-process-docstring", process)
    app.connect("missing-reference", find_public_name)
    app.connect("env-check-consistency", check_public_names)
    return {"parallel_read_safe": True}
