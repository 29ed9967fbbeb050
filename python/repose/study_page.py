# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a page with the verdicts and figures of studies: `python3 -m repose.study_page RESULTS PAGE STUDY...`, called by
`repose study page`. Figures are copied beside the page, into images/studies."""

import os
import shutil
import sys
from collections import Counter
from pathlib import Path

from repose.errors import RunFolderError, complain, say
from repose.study_folder import StudyFolder

GROUPS = {
    "baxter1997": "Baxter, Tüzün, Burnell and Heyes 1997",
    "bratberg2003": "Bratberg 2003",
    "liffman1992": "Liffman, Chan and Hughes 1992",
    "dip": "The dip",
    "others": "Other people's heaps",
    "cones": "Spheres: cones, packings and columns",
}
HEAD = """# {title}
<!-- Written by `repose study page`: edit the files in studies/ instead. -->
Each study holds what a document states against runs or models of Repose. This page has the results of the **{form}** form;
`{command}` makes it again. A claim *agrees* if the 95 % interval of its statistic lies within its bounds, *disagrees* if
the interval lies wholly outside, and is *undecided* otherwise. An equivalence is *equivalent* or *different* by the same
rule. *Not determined*: statics leaves the forces of rigid grains open. Tests, bootstraps and Holm's correction are those of
[sweeps](reference/sweep.md); "Holm" has the verdict corrected for the number of claims of that study. n counts the runs
behind a number. A number of a model, and the deviation of a pile in which nothing is random, are exact.

## All verdicts
"""


def number(value):
    """A number as text; a dash where there is none."""
    return "–" if value is None else f"{value:.4g}"


def bounds(claim):
    """The bounds of a claim as text."""
    low, high = claim["above"], claim["below"]
    if claim["kind"] == "equivalence":
        return f"within {number(high)}"
    if low is not None and high is not None:
        return f"{number(low)} to {number(high)}"
    return f"> {number(low)}" if high is None else f"< {number(high)}"


def found(claim):
    """Value and standard error of a claim as text."""
    error = claim["error"]
    return number(claim["value"]) + (f" ± {error:.2g}" if error else "")


def interval(claim):
    """The interval of a claim as text."""
    if claim["low"] is None or claim["low"] == claim["high"]:
        return "exact" if claim["low"] is not None else "–"
    return f"{number(claim['low'])} to {number(claim['high'])}"


def cell(text):
    """Text that a table of Markdown takes."""
    return text.replace("|", "\\|").replace("\n", " ")


def summary_table(studies):
    """A line for each study: its verdicts, counted."""
    lines = ["| study | what | verdicts |", "|---|---|---|"]
    for study in studies:
        words = Counter(claim["verdict"] for claim in study.claims)
        text = ", ".join(f"{count} {word}" for word, count in sorted(words.items()))
        lines.append(f"| [{study.name}](#{anchor(study)}) | {cell(study.title)} | {text} |")
    return lines


def anchor(study):
    """The link to the section of a study."""
    kept = "".join(c for c in heading(study).lower() if c.isalnum() or c in " -_")
    return kept.replace(" ", "-")


def heading(study):
    return f"{study.name}: {study.title}"


def section(study, images, page):
    """Heading, statement, figure and claims of a study."""
    lines = [f"### {heading(study)}", f"{study.source}. {study.states}", ""]
    if study.remark:
        lines += [study.remark, ""]
    figure = study.path / "figure.png"
    if figure.is_file():
        images.mkdir(parents=True, exist_ok=True)
        copy = images / f"{study.name}.png"
        shutil.copyfile(figure, copy)
        lines += [f"![{study.title}]({os.path.relpath(copy, page.parent)})", ""]
    lines += ["| claim | claimed | found | 95 % interval | n | verdict | Holm |", "|---|---|---|---|---|---|---|"]
    for claim in study.claims:
        count = "" if claim["n"] is None else claim["n"]
        words = [cell(claim["claim"]), bounds(claim), found(claim), interval(claim), count, claim["verdict"], claim["verdict_holm"]]
        lines.append("| " + " | ".join(str(word) for word in words) + " |")
    return [*lines, ""]


def write(results, page, names):
    """Writes the page of the studies that have results; names those that have none."""
    studies, missing = [], []
    for name in names:
        folder = Path(results, *name.split(".", 1))
        if (folder / "study.json").is_file():
            studies.append(StudyFolder(folder))
        else:
            missing.append(name)
    if not studies:
        raise RunFolderError(f"{results}: holds no results of these studies (`repose study run` makes them)")
    form = studies[0].content["form"]
    groups = {study.name.split(".")[0] for study in studies}
    command = "./dev figures" + "".join(f" {group}" for group in sorted(groups & {"dip", "others", "cones"}))
    if form != "quick":
        command = "repose study run all, then repose study page"
    title = GROUPS.get(*groups, "Studies") if len(groups) == 1 else "Studies"
    lines = [HEAD.format(title=title, form=form, command=command).rstrip(), *summary_table(studies), ""]
    if missing:
        lines += [f"Not run: {', '.join(missing)}.", ""]
    group = ""
    for study in studies:
        if study.name.split(".")[0] != group:
            group = study.name.split(".")[0]
            lines += [f"## {GROUPS.get(group, group)}", ""]
        lines += section(study, page.parent / "images" / "studies", page)
    page.write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")
    say(f"{page}: {len(studies)} studies, {sum(len(study.claims) for study in studies)} claims")


def main(arguments=None):
    """Exit status 0, or 2 with one line on stderr."""
    results, page, *names = sys.argv[1:] if arguments is None else arguments
    try:
        write(Path(results), Path(page), names)
    except RunFolderError as error:
        complain(f"repose study: {error}")
        return 2
    except OSError as error:
        complain(f"repose study: {error.filename}: cannot be written: {error.strerror}")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
