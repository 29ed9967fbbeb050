# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""How Sphinx builds the documentation (`./dev docs`)."""

import os
import re
import sys
from pathlib import Path

docs = Path(__file__).resolve().parent
root = docs.parent
sys.path.insert(0, str(docs / "_ext"))


def package_folder():
    """The folder with the Python package and its compiled module, as a build leaves them."""
    places = [os.environ.get("REPOSE_PYTHON_PATH"), root / "build/release/python", root / "build/dev/python"]
    return next((str(place) for place in places if place and Path(place).is_dir()), str(root / "python"))


sys.path.insert(0, package_folder())
os.environ["PYTHONPATH"] = package_folder()  # notebooks run in a Python of their own
os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # its debugger, which nobody uses here, warns otherwise

project = "Repose"
author = "The Repose developers"
copyright = "2026 The Repose developers"  # noqa: A001  # Sphinx reads this name
version = release = re.search(r"VERSION (\d[\d.]*)", (root / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
language = "en"

extensions = ["myst_parser", "sphinx.ext.autodoc", "contents", "plain_docstrings", "nbsphinx"]
exclude_patterns = ["_ext", "**.ipynb_checkpoints"]
myst_heading_anchors = 6  # links such as page.md#section, as repository browsers make them
smartquotes = False
default_role = "literal"  # one backquote in docstrings is code

autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "undoc-members": True, "special-members": "__getitem__"}
# Types in signatures that have no page: those of other libraries, and those behind the public names.
nitpick_ignore_regex = [("py:class", r".*")]

nbsphinx_execute = "always"  # notebooks are stored without outputs; a cell that fails ends the build
nbsphinx_timeout = 120  # seconds for a cell
nbsphinx_requirejs_path = nbsphinx_widgets_path = ""  # scripts from elsewhere, which no page needs

html_theme = "furo"
html_title = "Repose"
html_copy_source = False
html_show_sphinx = False
pygments_style = "tango"


def without_equations(app, name, *_):
    """Sphinx calls this before it writes a page. Those of notebooks would fetch MathJax from elsewhere, for no equation."""
    app.env.get_domain("math").data["has_equations"].pop(name, None)


def setup(app):
    """Sphinx calls this first."""
    app.connect("html-page-context", without_equations, priority=400)  # before MathJax asks
