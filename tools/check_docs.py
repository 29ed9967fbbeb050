#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks the links of docs and README: one line "file:line: problem" per violation, exit status 1 if there is any.

Relative links and images lead to files, and #anchors to headings. The front page docs/index.md lists every page, and
docs/reference/cpp.md every header of the library. With --site, pages of a built site use nothing from elsewhere.

usage: check_docs.py [ROOT]
       check_docs.py --site FOLDER
       check_docs.py --self-test
"""

import re
import sys
import tempfile
from pathlib import Path

LINK = re.compile(r"(?<!\\)\]\((?!\w+:)<?([^)\s>]*)>?(?:\s+\"[^\"]*\")?\)")
FENCE = re.compile(r"^\s*(```+|~~~+)")
HEADING = re.compile(r"^#{1,6} +(.+?)\s*#*$")
REMOTE = re.compile(
    r"<(?:script|img|iframe|link)\b[^>]*?(?:src|href)=\"(?:https?:)?//[^\"]*\"|url\([\"']?(?:https?:)?//[^)]*\)"
)
HEADER = re.compile(r'#include "(repose/api/[\w.]+)"')


def prose_of(text):
    """(line number, line) of a Markdown text without its code: fenced blocks, indented blocks, `code`."""
    fence, before_is_text = "", False
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if mark and (not fence or line.strip().startswith(fence)):
            fence = "" if fence else mark[1]
        elif not fence and (before_is_text or not line.startswith("    ")):
            yield number, re.sub(r"(`+).+?\1", "", line)
            before_is_text = bool(line.strip())


def headings_of(text):
    """The headings of a Markdown text, as they are written."""
    fence = ""
    for line in text.splitlines():
        mark = FENCE.match(line)
        if mark and (not fence or line.strip().startswith(fence)):
            fence = "" if fence else mark[1]
        elif not fence and HEADING.match(line):
            yield HEADING.match(line)[1]


def anchors_of(text):
    """The anchors of the headings of a Markdown text, as repository browsers and the site make them."""
    anchors, count = set(), {}
    for title in headings_of(text):
        title = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title).replace("`", "")
        slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        again = count.get(slug, 0)
        count[slug] = again + 1
        anchors.add(f"{slug}-{again}" if again else slug)
    return anchors


class Pages:
    """The Markdown files of the project, each read once."""

    def __init__(self, root):
        self.root = root
        self.files = sorted((root / "docs").rglob("*.md")) + [root / "README.md"]
        self.texts = {}
        self.anchors = {}

    def text(self, file):
        """The text of a file."""
        if file not in self.texts:
            self.texts[file] = file.read_text(encoding="utf-8")
        return self.texts[file]

    def has_anchor(self, file, anchor):
        """Whether a heading of a file makes this anchor."""
        if file not in self.anchors:
            self.anchors[file] = anchors_of(self.text(file))
        return anchor in self.anchors[file]

    def links(self, file):
        """(line, link) of every relative link and image."""
        for number, line in prose_of(self.text(file)):
            for link in LINK.finditer(line):
                yield number, link[1]

    def problem(self, file, link):
        """What is wrong with a link of a file; empty if nothing is."""
        place, _, anchor = link.partition("#")
        target = (file.parent / place).resolve() if place else file
        if not target.exists():
            return f"{place} -> no such file"
        if anchor and target.suffix == ".md" and not self.has_anchor(target, anchor):
            return f"{link} -> no such heading"
        return ""


def listed(pages, name):
    """The pages to which a page leads, as files; an absent page leads to none."""
    file = pages.root / name
    if not file.exists():
        return set()
    return {(file.parent / link.partition("#")[0]).resolve() for _, link in pages.links(file)}


def check(root):
    """(number of links, problems) of a project."""
    pages = Pages(root)
    count, problems = 0, []
    for file in pages.files:
        path = file.relative_to(root)
        for number, link in pages.links(file):
            count += 1
            problem = pages.problem(file, link)
            problems += [f"{path}:{number}: {problem}"] if problem else []
    known = listed(pages, "docs/index.md") | listed(pages, "docs/theory/README.md") | {root / "docs/index.md"}
    for file in pages.files:
        if root / "docs" in file.parents and file not in known:
            problems.append(f"docs/index.md:1: has no link to {file.relative_to(root / 'docs')}")
    api = root / "src/repose/api/repose.hpp"
    for header in HEADER.findall(pages.text(api)) if api.exists() else []:
        if root / "src" / header not in listed(pages, "docs/reference/cpp.md"):
            problems.append(f"docs/reference/cpp.md:1: has no link to {header}")
    return count, problems


def check_site(folder):
    """(number of files, problems) of a built site: what a browser would fetch from elsewhere."""
    files = [file for file in sorted(folder.rglob("*")) if file.suffix in (".html", ".css")]
    problems = []
    for file in files:
        for found in REMOTE.finditer(file.read_text(encoding="utf-8")):
            problems.append(f"{file.relative_to(folder)}: is not of this site: {found.group()}")
    return len(files), problems


RIGHT = {
    "README.md": "[docs](docs/index.md) and [a heading](docs/a.md#two-words), [site](https://example.org/none)\n",
    "docs/index.md": "# Front\n- [a](a.md)\n- [theory](theory/README.md)\n- [here](#front)\n"
    "- [C++](reference/cpp.md)\n",
    "docs/a.md": "# A\n## Two *words*\n## Twice: `x`\n## Twice: `x`\n```\n[no](no.md)\n# Code\n```\n"
    "`[no](no.md)` [b](#twice-x-1)\n\n    [no](no.md)\n",
    "docs/theory/README.md": "# Theory\n[b](b.md) ![a](../a.png)\n",
    "docs/theory/b.md": "# B\n",
    "docs/a.png": "",
    "docs/reference/cpp.md": "[scene](../../src/repose/api/scene.hpp)\n",
    "src/repose/api/repose.hpp": '#include "repose/api/scene.hpp"\n',
    "src/repose/api/scene.hpp": "",
}
WRONG = {
    "docs/gone.md:2": "# Gone\n[a](gone/b.md)\n",
    "docs/anchor.md:1": "[a](a.md#code)\n",
    "docs/own.md:1": "[a](#none)\n",
    "docs/picture.md:3": "# Picture\n\n![a](none.png)\n",
    "docs/after.md:6": "- text\n\n    more\n```\n```\n[a](none.md)\n",
}


def plant(root, files):
    """Writes files, and adds the pages of docs to the front page."""
    for path, text in files.items():
        file = root / path.split(":")[0]
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


def self_test():
    """Each planted violation is found, and nothing else."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        plant(root, RIGHT)
        assert check(root) == (10, []), check(root)
        plant(root, WRONG)
        front = "".join(f"- [x]({place.split(':')[0][5:]})\n" for place in WRONG)
        plant(root, {"docs/index.md": RIGHT["docs/index.md"] + front})
        found = [problem.split(": ")[0] for problem in check(root)[1]]
        assert sorted(found) == sorted(WRONG), set(found) ^ set(WRONG)
        plant(root, {"docs/lost.md": "# Lost\n", "src/repose/api/repose.hpp": '#include "repose/api/new.hpp"\n'})
        text = "\n".join(check(root)[1])
        assert "has no link to lost.md" in text and "has no link to repose/api/new.hpp" in text, text
        site = root / "site"
        right = '<a href="https://example.org">x</a><script src="a.js"></script>'
        plant(site, {"a.html": right, "b.css": "url(a.woff)"})
        assert check_site(site) == (2, []), check_site(site)
        plant(site, {"c.html": '<script async src="https://x.org/a.js">', "d.css": "url('//x.org/a.woff')"})
        assert len(check_site(site)[1]) == 2, check_site(site)
    print(f"self-test: {len(WRONG) + 4} planted violations found")


def main(arguments):
    """Runs a check and returns the exit status."""
    if arguments == ["--self-test"]:
        self_test()
        return 0
    if arguments[:1] == ["--site"] and len(arguments) == 2:
        count, problems = check_site(Path(arguments[1]))
        summary = f"{count} files of the site use nothing from elsewhere"
        problems = problems or ([] if count else [f"no site in {arguments[1]}"])
    else:
        root = Path(arguments[0]).resolve() if arguments else Path(__file__).resolve().parent.parent
        count, problems = check(root)
        summary = f"{count} links of docs and README lead somewhere"
    print("\n".join(problems) or summary)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
