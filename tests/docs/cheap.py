# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the test runs a command of a page in seconds: the whole mapping.

| command | what runs instead |
|---|---|
| `repose run SCENE` | `repose check SCENE` with the same --set and --seed |
| `repose sweep FILE` | the same with --check, which reads and describes everything; no share, no Slurm |
| `repose calibrate FILE` | the same with --check |
| `repose study run`, `page` | `repose study list` of the same studies |
| `repose plot` | the first of its pictures, of a small heap or sweep; the others must be known |
| `repose analyse`, `export`, `resume`, `solve` | the same on a small heap, a heap of rigid grains, or a sweep |
| `repose view DIR` | `repose export DIR --to html`, which makes the same page and ends |
| `repose theory` | the same, with small numbers in HEAVY |
| `repose check`, `scene`, `reference` and single options | the same |
| `python3 -c`, and the Python of a page | the same, beside folders of small heaps |
| `./dev VERB` | `./dev help`, which must list the verb and its options |

The options of each command must be among those that `repose VERB --help` lists.
"""

import re

# Numbers of models that make a table slow, and what the test uses.
HEAVY = {"layers": "40", "runs": "2", "width": "40", "samples": "10"}

# Commands that no test can run, by their beginning, with the reason.
EXCEPTED = {
    "repose run impact.toml": "needs the law that docs/tutorial/own-law.md adds; tests/how_to builds it",
    "repose sweep damp.toml": "needs the law that docs/tutorial/own-law.md adds; tests/how_to builds it",
}

RUN_ONLY = {"--out", "--threads"}  # options with a value that only a run has
RUN_FLAGS = {"--overwrite", "--quiet", "--profile", "--beyond-memory"}
SHARE_ONLY = {"--share", "--lease", "--array", "--time", "--partition"}
SHARE_FLAGS = {"--check", "--collect", "--slurm", "--submit"}


def without(words, valued, flags):
    """Words without some options and their values."""
    kept, skip = [], False
    for word in words:
        name = word.split("=")[0]
        if skip:
            skip = False
        elif name in valued:
            skip = "=" not in word
        elif word not in flags:
            kept.append(word)
    return kept


def pictures_of(words):
    """The pictures that a command names."""
    return words[words.index("--only") + 1].split(",") if "--only" in words else []


def light(words):
    """Words of a theory command, with small numbers."""
    return [re.sub(r"^(\w+)=\d+$", lambda w: f"{w[1]}={HEAVY.get(w[1], w[0].split('=')[1])}", word) for word in words]


def cheap_form(words, sweeps=()):
    """The arguments of `repose` that the test runs instead of those of a page, which writes the folders `sweeps`."""
    verb = words[0] if words else ""
    if verb == "run":
        return ["check", *without(words[1:], RUN_ONLY, RUN_FLAGS)]
    if verb in ("sweep", "calibrate"):
        return [*without(words, RUN_ONLY | SHARE_ONLY, RUN_FLAGS | SHARE_FLAGS), "--check"]
    if verb == "study":
        return ["study", "list", *without(words[2:], RUN_ONLY | {"--page"}, RUN_FLAGS)]
    if verb == "plot":
        pictures = pictures_of(words) or (["angle"] if words[1] in sweeps else ["heap"])
        small = ["--only", pictures[0], "--format", "png", "--dpi", "50"]
        return [*without(words, {"--only", "--format", "--dpi"}, set()), *small]
    if verb == "view":
        return ["export", words[1], "--to", "html"]
    if verb == "theory":
        return light(words)
    return words


def folders_of(words):
    """The run or sweep folders that a command reads."""
    if words[0] in ("plot", "analyse", "export", "resume"):
        return words[1:2]
    return []


def stand_in(words, sweeps):
    """Which small folder stands for the folder that a command reads: heap, rigid or sweep."""
    if words[1] in sweeps:
        return "sweep"
    return "rigid" if "--force-range" in words or "contact-problem" in words else "heap"
