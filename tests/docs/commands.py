# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Finds the commands in the code blocks of docs and README, and the files that a page asks its reader to save."""

import re
import shlex
from dataclasses import dataclass, field
from pathlib import Path

FENCE = re.compile(r"^\s*```(.*)$")
SHELL = {"", "bash", "console", "sh", "shell"}  # languages of blocks that hold commands
COMMAND = re.compile(r"^(?:\$ )?((?:[A-Z_]+=\S+ +)*(?:(?:build/\w+/)?repose|\./dev|python3 -c)(?: .*)?)$")
PLACEHOLDER = re.compile(r"^[\[<]*[A-Z][A-Z0-9_-]*(?:[./=,:].*)?[\]>.]*$")
ASSIGNMENT = re.compile(r"^[A-Z_]+=")
SAVED = re.compile(r"[Ss]ave (?:this|it) as `([^`\n]+)`[^`]*```\w*\n(.*?)```", re.DOTALL)
PYTHON = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)


@dataclass
class Command:
    """A command line of a page."""

    page: str  # relative to the root
    line: int
    text: str
    words: list = field(default_factory=list)  # without assignments, comment, and what follows a pipe

    def __str__(self):
        return f"{self.page}:{self.line}: {self.text}"


def code_lines(text):
    """(line number, line) of the code blocks that may hold commands: fenced, and indented after an empty line."""
    fence, indented, before = None, False, ""
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        if mark:
            fence = mark[1].strip() if fence is None else None
        elif fence is not None:
            if fence in SHELL:
                yield number, line
        else:
            starts = not before.strip() or before.startswith("#")
            indented = line.startswith("    ") and (indented or starts)
            if indented:
                yield number, line[4:]
        before = line


def joined(lines):
    """The lines, with those that end in a backslash joined to the next."""
    first, text = None, ""
    for number, line in lines:
        first = first or number
        text += line.rstrip("\\").strip() + " "
        if not line.endswith("\\"):
            yield first, text.strip()
            first, text = None, ""


def words_of(text):
    """The words of the first program of a command line."""
    words = shlex.split(text, comments=True)
    while ASSIGNMENT.match(words[0]):
        words.pop(0)
    end = next((k for k, word in enumerate(words) if word in ("|", ">", "&&", ";", "&")), len(words))
    return words[:end]


def is_synopsis(words):
    """Whether words such as DIR, SCENE.toml, KEY=VALUE or N stand for something else."""
    return any(PLACEHOLDER.match(word) for word in words)


def commands_of(page, text):
    """The commands of a page, without synopses."""
    for number, line in joined(code_lines(text)):
        found = COMMAND.match(line)
        words = words_of(found[1]) if found else []
        if words and not is_synopsis(words):
            yield Command(page, number, line, words)


def saved_files(text):
    """The content, by name, of the files that a page asks its reader to save."""
    return dict(SAVED.findall(text))


def python_of(text):
    """The Python of a page as one script."""
    return "\n".join(PYTHON.findall(text))


def pages_of(root):
    """(name, text) of README and every page of docs."""
    for file in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        yield str(file.relative_to(root)), file.read_text(encoding="utf-8")


ROOT = Path(__file__).resolve().parents[2]
