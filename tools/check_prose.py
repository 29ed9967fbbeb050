#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks names and prose: one line "file:line: word -> replacement" per violation, exit status 1 if there is any.

Comments, docstrings, messages and docs use plain English (PHRASES), identifiers say what they name (NAMES). Tests that
comments and docs name exist: files below tests/, `Suite.Test` and test_function. Folders below src/repose, examples and
the targets of links in docs exist.

usage: check_prose.py [ROOT | --self-test]
"""

import fnmatch
import re
import sys
import tempfile
import tokenize
from pathlib import Path

FOLDERS = ["benchmarks", "docs", "examples", "python", "src", "tests", "tools"]
CPP = {".cpp", ".hpp", ".h"}
HASH = {".cmake", ".in", ".py", ".sh", ".toml", ".txt"}  # comments begin with #

# Phrases of comments, messages and docs, and what to write instead. Spaces also match line breaks.
PHRASES = [
    (r"go(es)? on|went on|gone on|going on", "continues, resumes"),
    (r"anew", "again"),
    (r"fore(tell|tells|told)", "predicts, predicted"),
    (r"(laid|lay|lays|laying) (over|on)", "overlaid, compared with"),
    (r"tak(e|es|en|ing) up", "resumes, carries"),
    (r"(is|are|was|were) (told|said)", "is reported"),
    (r"that (is|are|was|were) there", "that exists, present"),
    (r"to be told", 'Call this when ... / "the caller reports ..."'),
    (r"to be called (when|at|after|before|at the)", "Call this when ..."),
    (r"who(so)?ever", "name the subject"),
    (r"stretch(es)? of|(a|the|this|that|each) stretch", "interval"),
    (r"spells?", "batch"),
    (r"(a|the|one|first|last|next|every|each|this) look", "check"),
    (r"shares? of", "fraction of"),
    (r"of way", "of displacement"),
    (r"bit for bit", "to the bit"),
]
COMMENT_STARTS = [(r"Of (?!course)", "name the noun")]

# Identifiers that are riddles, and what to name instead. Matched against whole identifiers of code.
NAMES = [
    (r"be_member", "run_member"),
    (r"taken_up", "resume"),
    (r"lay_theory_on|laid_on", "compare"),
    (r"as_kept", "stored"),
    (r"look_after|looked_after", "observe"),
    (r"set_push", "to_push"),
    (r"taken_\w+", "take_..."),
    (r"pushed_on", "name the force"),
    (r"go_on|goes_on|start_anew|foretold\w*", "resume, restart, predicted"),
    (r"(\w+_)?[Ss]tretch(es)?_?", "interval"),
    (r"(\w+_)?[Ss]pells?_?", "batch"),
    (r"kWay|Ways?|ways?_?|\w+_way_?", "displacement, path, unit"),
    (r"Share|share_?|(\w+_)?shares_?", "fraction, range, workspace"),
    (r"look|(\w+_)?looks_?", "check, search"),
    (r"plane_partner", "wall_partner"),
]

IDENTIFIER = re.compile(r"[A-Za-z_]\w*")
TEST_PATH = re.compile(r"(?<![\w./-])(?:tests|examples)/[\w/.-]*\w")
LINK = re.compile(r"\]\((?!\w+:)([^)\s#]+)")
SOURCE_FOLDER = re.compile(r"(?<![\w./-])src/repose/(\w+)(?![\w.*{<])")
SUITE_TEST = re.compile(r"(?<![\w./*-])([A-Z]\w+)\.([A-Z]\w*\*?|\*(?!\*))(?![\w(])")
TEST_FUNCTION = re.compile(r"(?<![\w/.-])test_\w+(?:\.py)?")
VALIDATED = re.compile(r"Validated by (.*?)(?:\.(?=\s|$)|$)", re.DOTALL)
NAMED_FILE = re.compile(r"[\w/.-]+\.(?:cpp|hpp|py|md)\b")


def compiled(rules):
    return [(re.compile(r"\b(?:" + rule.replace(" ", r"\s+") + r")\b", re.IGNORECASE), better) for rule, better in rules]


PHRASE_RULES = compiled(PHRASES)
START_RULES = [(re.compile(rule), better) for rule, better in COMMENT_STARTS]
NAME_RULES = [(re.compile(rule), better) for rule, better in NAMES]


COMMENT, TEXT, MESSAGE, CODE = "comment", "text", "message", "code"


class Parts:
    """A file in parts: paragraphs of prose, and identifiers."""

    def __init__(self):
        self.prose = []  # (first line, text, kind)
        self.names = []  # (line, identifier)

    def add_prose(self, line, text, kind):
        first, above, kind_above = self.prose[-1] if self.prose else (0, "", None)
        if kind == kind_above == COMMENT and first + above.count("\n") + 1 == line:
            self.prose[-1] = (first, above + "\n" + text, COMMENT)
        else:
            self.prose.append((line, text, kind))


CPP_TOKEN = re.compile(
    r'R"(?P<mark>[^(\s]*)\((?P<raw>.*?)\)(?P=mark)"|"(?P<text>(?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\\n])+\'|//(?P<line>[^\n]*)'
    r"|/\*(?P<block>.*?)\*/|(?P<name>[A-Za-z_]\w*)|\d[\w.']*",
    re.DOTALL,
)


def parts_of_cpp(text):
    parts = Parts()
    line = 1
    position = 0
    for found in CPP_TOKEN.finditer(text):
        line += text.count("\n", position, found.start())
        position = found.start()
        if found["name"]:
            if not re.search(r"(\.|->)$", text[max(0, position - 2) : position]):  # a member is reported where declared
                parts.names.append((line, found["name"]))
        elif found["line"] is not None:
            parts.add_prose(line, re.sub(r"^/?!?<?\s*", "", found["line"]), COMMENT)
        else:
            parts.add_prose(line, found["raw"] or found["text"] or found["block"] or "", TEXT if found["block"] else MESSAGE)
    return parts


def parts_of_python(text):
    parts = Parts()
    for token in tokenize.generate_tokens(iter(text.splitlines(keepends=True)).__next__):
        if token.type == tokenize.COMMENT:
            parts.add_prose(token.start[0], token.string.lstrip("#! "), COMMENT)
        elif token.type == tokenize.STRING:
            docstring = token.string.endswith('"""')
            parts.add_prose(token.start[0], token.string.strip("rbfu\"'"), TEXT if docstring else MESSAGE)
        elif token.type == tokenize.NAME:
            parts.names.append((token.start[0], token.string))
    return parts


def parts_of_text(text, markdown):
    """Paragraphs and table rows of docs, or the comments of other files. Text in code fences is CODE."""
    parts = Parts()
    fenced = False
    paragraph = []
    for number, line in enumerate(text.splitlines() + [""], 1):
        fenced ^= markdown and line.lstrip().startswith("```")
        comment = re.match(r"\s*#+\s?(.*)", line) if not markdown else None
        if markdown and line.strip() and not fenced and not line.startswith("|"):
            paragraph.append((number, line))
            continue
        if paragraph:
            parts.add_prose(paragraph[0][0], "\n".join(part for _, part in paragraph), TEXT)
            paragraph = []
        if comment:
            parts.add_prose(number, comment[1], COMMENT)
        elif markdown and line.strip():
            parts.add_prose(number, line, CODE if fenced else TEXT)
    return parts


def parts_of(file, text):
    if file.suffix in CPP:
        return parts_of_cpp(text)
    if file.suffix == ".py":
        return parts_of_python(text)
    return parts_of_text(text, file.suffix == ".md")


def shown(text):
    return " ".join(text.split())


def word_problems(parts, test):
    """Strings of tests are input, or expect messages that are checked where they are written."""
    for first, text, kind in parts.prose:
        if kind == CODE or (kind == MESSAGE and test):
            continue
        starts = START_RULES if kind == COMMENT else []
        for rule, better in PHRASE_RULES:
            for found in rule.finditer(text):
                yield first + text.count("\n", 0, found.start()), f'"{shown(found.group())}" -> {better}'
        for rule, better in starts:
            if rule.match(text):
                yield first, f'a comment that begins with "{shown(rule.match(text).group())}" -> {better}'
    for line, name in parts.names:
        for rule, better in NAME_RULES:
            if rule.fullmatch(name):
                yield line, f"{name} -> {better}"
                break


class Tests:
    """The tests of the project."""

    def __init__(self, root):
        self.root = root
        self.cpp = set()
        self.python = set()
        for file in sorted(root.glob("tests/**/*.cpp")):
            text = file.read_text(encoding="utf-8")
            self.cpp |= {f"{a}.{b}" for a, b in re.findall(r"\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", text)}
        self.suites = {name.split(".")[0] for name in self.cpp}
        for file in [*root.glob("tests/**/*.py"), *root.glob("python/tests/*.py")]:
            self.python.add(file.name)
            self.python |= set(re.findall(r"^\s*def (test_\w+)", file.read_text(encoding="utf-8"), re.MULTILINE))

    def file_exists(self, name):
        return (self.root / name).exists() or any(self.root.glob(name + "*"))

    def problems(self, text, docs):
        """(offset, problem) of every test in the text that does not exist."""
        for found in TEST_PATH.finditer(text):
            if not self.file_exists(found.group()):
                yield found.start(), f"{found.group()} -> no such file"
        for found in SOURCE_FOLDER.finditer(text):
            if not self.file_exists(f"src/repose/{found[1]}"):
                yield found.start(), f"{found.group()} -> no such folder"
        for found in VALIDATED.finditer(text):
            for name in NAMED_FILE.finditer(found[1]):
                if not name.group().startswith("tests/") and not self.file_exists(name.group()):
                    yield found.start(1) + name.start(), f"Validated by {name.group()} -> no such file"
        if not docs:
            return
        for found in SUITE_TEST.finditer(text):
            # Outside of tables and backquotes, "Name.Name" may be anything else.
            meant = found[1] in self.suites or text.startswith("|") or text[found.start() - 1 : found.start()] == "`"
            if meant and not fnmatch.filter(self.cpp, found.group()):
                yield found.start(), f"{found.group()} -> no such test"
        for found in TEST_FUNCTION.finditer(text):
            if found.group() not in self.python:
                yield found.start(), f"{found.group()} -> no such test"


def problems_of(path, file, tests):
    parts = parts_of(file, file.read_text(encoding="utf-8"))
    if path == "python/repose/scene_keys.py":
        parts.names.clear()  # they are keys of scenes
    found = list(word_problems(parts, path.startswith("tests/")))
    for first, text, kind in parts.prose:
        for offset, problem in tests.problems(text, file.suffix == ".md") if kind != MESSAGE else []:
            found.append((first + text.count("\n", 0, offset), problem))
        for link in LINK.finditer(text) if file.suffix == ".md" and kind != CODE else []:
            if not (file.parent / link[1]).exists():
                found.append((first + text.count("\n", 0, link.start()), f"{link[1]} -> no such file"))
    return sorted(found)


def texts(root):
    files = list(root.iterdir())
    for folder in FOLDERS:
        files += (root / folder).rglob("*")
    wanted = CPP | HASH | {".md"}
    own = "tools/check_prose.py"
    return sorted(f for f in files if f.is_file() and f.suffix in wanted and str(f.relative_to(root)) != own)


def check(root):
    """(number of files, problems as "file:line: word -> replacement") of a project."""
    files = texts(root)
    tests = Tests(root)
    problems = []
    for file in files:
        path = file.relative_to(root).as_posix()
        problems += [f"{path}:{line}: {problem}" for line, problem in problems_of(path, file, tests)]
    return len(files), problems


# The self-test: files with and without violations; each violation must be found, and nothing else.
RIGHT = {
    "src/repose/core/a.hpp": '// The run resumes. Course of action: go one way.\nint displacement = one.share;  ///< of the wall\n',
    "src/repose/core/b.cpp": '/* The share price. */ f("spelled out tests/unit/x.cpp", R"(a way of looking)");\n',
    "tests/unit/a_test.cpp": "TEST(Law, Holds) {}\nTEST_F(Law, HoldsToo) {}\nTEST_P(Other, Case) {}\n",
    "tests/cli/test_a.py": '"""Tests."""\n\n\ndef test_it_holds():\n    assert "goes on" in message()\n',
    "docs/page.md": "Law.Holds, Law.*, Law.Hold*, `test_it_holds`, test_a.py, tests/unit, src/repose/core/x.hpp. See [a page](page.md#top)\n"
    "and [a site](https://example.org/none).\n"
    "```\ngoes on anew\n```\n",
    "src/repose/core/d.hpp": "/// A law. Validated by tests/unit/a_test.cpp (all)\n/// and tests/cli/test_a.py.\nstruct Law {};\n",
    "notes.txt": "it goes on\n# a comment\n",
}
WRONG = {
    "src/repose/core/on.hpp:1": "// It goes\n// on.\n",
    "src/repose/core/anew.hpp:1": "int x;  // builds it anew\n",
    "src/repose/core/of.hpp:1": "/// Of the last step.\nint x;\n",
    "src/repose/core/of2.hpp:1": "int x;  ///< Of the last step\n",
    "src/repose/core/told.cpp:2": '\nthrow Error("this was told before");\n',
    "src/repose/core/call.hpp:1": "/// To be called when grains were added.\n",
    "src/repose/core/raw.cpp:2": 'auto s = R"(\nfirst foretold\n)";\n',
    "src/repose/core/name.cpp:1": "double wall_way = 0.0;\n",
    "src/repose/core/name2.cpp:1": "struct Stretch {};\n",
    "src/repose/core/name3.cpp:3": "\n\nvoid set_push();\n",
    "src/repose/core/valid.hpp:2": "/// A law. Validated by\n/// tests/unit/no_test.cpp.\nstruct Law {};\n",
    "src/repose/core/valid2.hpp:1": "/// Validated by b_test.cpp.\n",
    "src/repose/scene/valid.hpp:1": "// Tested in tests/unit/gone_test.cpp.\n",
    "python/a.py:1": '"""See tests/unit/gone_test.cpp."""\n',
    "tests/cli/test_b.py:2": "\n# It is taken\n# up again.\n",
    "tests/cli/test_c.py:1": '"""The laws that are there."""\n',
    "docs/word.md:2": "One line,\nwhoever reads it.\n",
    "docs/table.md:1": "| a spell | b |\n",
    "docs/suite.md:1": "Law.Fails\n",
    "docs/suite2.md:1": "`Gone.*`\n",
    "docs/function.md:1": "`test_gone`\n",
    "docs/folder.md:1": "In src/repose/run the program runs.\n",
    "docs/example.md:1": "`repose run examples/gone.toml`\n",
    "docs/link.md:2": "A\n[page](gone.md).\n",
    "CMakeLists.txt:2": "set(X)\n# A stretch of text.\n",
}


def plant(root, path, text):
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    (root / path).write_text(text, encoding="utf-8")


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, text in RIGHT.items():
            plant(root, path, text)
        assert check(root) == (len(RIGHT), []), check(root)
        for place, text in WRONG.items():
            plant(root, place.split(":")[0], text)
        found = [problem.split(": ")[0] for problem in check(root)[1]]
        assert sorted(found) == sorted(WRONG), set(found) ^ set(WRONG)
    print(f"self-test: {len(WRONG)} planted violations found, {len(RIGHT)} right files passed")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
    files, problems = check(root)
    if files == 0:
        problems = [f"no files of the project below {root}"]
    print("\n".join(problems) or f"{files} files keep to plain names and prose")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
