# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the navigation of the site from the links of the pages that list other pages.

The front page lists pages below its headings, docs/theory/README.md in a table. Both read well in a repository browser.
A link to a Markdown file outside of docs, which is no page of the site, offers the file itself.
"""

import re
from pathlib import Path

PAGE = re.compile(r"\]\(([\w./-]+)\.(?:md|ipynb)\)")
SECTION = re.compile(r"^## (.+)$", re.MULTILINE)
LINK_OUT = re.compile(r"\[([^]`]+)\]\((\.\./[^)#\s]+\.md)\)")


def toctree(caption, pages):
    """A hidden table of contents."""
    options = [":hidden:", *([f":caption: {caption}"] if caption else [])]
    return "\n".join(["", "```{toctree}", *options, "", *dict.fromkeys(pages), "```", ""])


def with_contents(name, text):
    """The text of a page, with a table of contents of the pages that it lists."""
    if name == "theory/README":
        return text + toctree("", [page for page in PAGE.findall(text) if "/" not in page])
    if name != "index":
        return text
    titles = SECTION.split(text)[1:]
    for caption, section in zip(titles[::2], titles[1::2]):
        pages = PAGE.findall("\n".join(line for line in section.splitlines() if line.startswith("- ")))
        if pages:
            text += toctree(caption, pages)
    return text


def with_files(folder, docs, text):
    """The text of a page in `folder`, with links to Markdown files outside of `docs` as downloads."""

    def download(link):
        outside = docs not in (folder / link[2]).resolve().parents
        return f"{{download}}`{link[1]} <{link[2]}>`" if outside else link[0]

    return LINK_OUT.sub(download, text)


def read_source(app, name, source):
    """Sphinx calls this with the text of each page."""
    docs = Path(app.srcdir).resolve()
    source[0] = with_files(docs / Path(name).parent, docs, with_contents(name, source[0]))


def setup(app):
    """Sphinx calls this first."""
    app.connect("source-read", read_source)
    return {"parallel_read_safe": True}
