# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""One style for all pictures: restrained, colour-blind safe (Okabe and Ito), small in vector formats."""

import io
import os
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib import colormaps
from matplotlib.colors import ListedColormap, to_hex, to_rgb

INK = "#1a1a1a"
GREY = "#6b6b6b"
FAINT = "#c9ced6"
BLUE = "#0072b2"
ORANGE = "#d55e00"
PURPLE = "#aa3377"
GREEN = "#009e73"
SKY = "#56b4e9"
AMBER = "#e69f00"
BROWN = "#8c510a"
SERIES = (BLUE, ORANGE, GREEN, PURPLE, SKY, AMBER)  # of series in one picture
MARKERS = ("o", "s", "^", "D", "v", "P")

GRAIN = "#a9c4dc"  # moving grains
GRAIN_EDGE = "#34506b"
SPECIES = (GRAIN, "#f2d27a", "#8fcbb0", "#7d8794", "#c993bb", "#e8b08c")  # of moving grains; the first of most runs
HELD = "#4d4d4d"  # base and other fixed grains

NEIGHBOURS = ("#ece7f2", "#fee391", "#fdae61", "#a6d96a", "#66c2a5", "#4393c3", "#2d3f8c")  # 0, 1, ... 6 or more

PACKING = "viridis_r"  # of solid fractions: dense is dark
LOAD = ListedColormap(colormaps["Blues"](np.linspace(0.03, 0.72, 256)), "load")  # light enough for INK lines on it

RC = {
    "font.family": "DejaVu Sans",
    "font.size": 8,
    "axes.labelsize": 8,
    "axes.linewidth": 0.6,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.use_mathtext": True,
    "axes.unicode_minus": True,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "xtick.minor.size": 1.5,
    "ytick.minor.size": 1.5,
    "legend.fontsize": 7,
    "legend.frameon": False,
    "legend.handlelength": 1.8,
    "legend.columnspacing": 1.4,
    "legend.borderaxespad": 0.0,
    "legend.borderpad": 0.0,
    "lines.linewidth": 1.0,
    "pdf.fonttype": 42,  # journals take no fonts of type 3
    "ps.fonttype": 42,
    "svg.hashsalt": "repose",  # the same figure gives the same file
}


def pale(colour, strength):
    """A colour mixed with white. It stands for transparency, which EPS lacks, and is the same in every format."""
    return to_hex(1.0 - strength * (1.0 - np.array(to_rgb(colour))))


@contextmanager
def context():
    """The settings of all pictures. Those of a user's matplotlibrc do not count: a picture is the same everywhere."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(RC)
        yield


@dataclass(frozen=True)
class Units:
    """Labels and values of lengths, times, stresses and energies with their units."""

    reduced: bool
    weightless: bool = False  # without gravity time, speed, stress and energy have no unit of their own
    dimension: int = 2

    def length(self, symbol):
        return f"{symbol} / σ" if self.reduced else f"{symbol} (m)"

    def length_value(self, value):
        return f"{value:.3g} σ" if self.reduced else f"{value:.3g} m"

    def time(self, symbol):
        return self._of(symbol, "√(σ/g)", "T", "s")

    def time_value(self, value):
        return f"{value:.6g}" + self._unit(" √(σ/g)", "", " s")

    def speed(self, symbol):
        return self._of(symbol, "√(gσ)", "L/T", "m/s")

    def speed_squared(self, symbol):
        return self._of(symbol, "gσ", "L²/T²", "m²/s²")

    def stress(self, symbol):
        if self.dimension == 3:
            return self._of(symbol, "(mg/σ²)", "M/(L T²)", "Pa")
        return self._of(symbol, "(mg/σ)", "M/T²", "N/m")

    def stress_value(self, value):
        reduced, si = (" mg/σ²", " Pa") if self.dimension == 3 else (" mg/σ", " N/m")
        return f"{value:.3g}" + self._unit(reduced, "", si)

    def density(self, symbol):
        """Mass per volume, or per area in two dimensions."""
        power = "³" if self.dimension == 3 else "²"
        return f"{symbol} / (m/σ{power})" if self.reduced else f"{symbol} (kg/m{power})"

    def mass(self, symbol):
        return f"{symbol} / m" if self.reduced else f"{symbol} (kg)"

    def energy(self, symbol):
        return self._of(symbol, "mgσ", "M L²/T²", "J")

    def energy_value(self, value):
        return f"{value:.4g}" + self._unit(" mgσ", "", " J")

    def force(self, symbol):
        """In grain weights where grains have a weight."""
        return f"{symbol}\n" + f"({self.force_word()})"

    def force_word(self):
        return "grain weights" if not self.weightless else self._unit("", "M L/T²", "N")

    def _unit(self, reduced, weightless, si):
        return (weightless if self.weightless else reduced) if self.reduced else si

    def _of(self, symbol, reduced, weightless, si):
        return f"{symbol} / {reduced}" if self.reduced and not self.weightless else f"{symbol} ({self._unit('', weightless, si)})"


def units_of(run):
    """Units of the scene of a run or sweep."""
    weight = run.attributes.get("grain_weight", 1.0)
    return Units(run.attributes["units"] == "reduced", not weight > 0.0, run.attributes.get("dimension", 2))


def fit(figure, area=(0.0, 0.0, 1.0, 1.0), **padding):
    """Fits the axes with their labels into an area (left, bottom, right, top) of the figure, in fractions of it."""
    for _ in range(2):  # ticks and their labels change with the size of the axes
        figure.tight_layout(pad=0.4, rect=area, **padding)


def caption(figure, text):
    """Small grey text in the top left corner."""
    width, height = figure.get_size_inches()
    figure.text(0.08 / width, 1.0 - 0.08 / height, text, ha="left", va="top", fontsize=7, color=GREY)


def save(figure, path, kind, dpi, title):
    """Writes a picture under a temporary name and renames it, so that no file is ever incomplete. Follows links, and
    writes straight into what is no regular file."""
    picture = _drawn(figure, kind, dpi, title)
    path = Path(path)
    if path.exists() and not path.is_file():
        path.write_bytes(picture)
        return
    path = Path(os.path.realpath(path))
    temporary = path.with_name(f".{path.name}.{os.uname().nodename}.{os.getpid()}")
    try:
        temporary.write_bytes(picture)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def _drawn(figure, kind, dpi, title):
    """The bytes of a picture. The same figure gives the same bytes: no format has the date."""
    dates = {"svg": {"Date": None}, "pdf": {"CreationDate": None}, "eps": {"Creator": "Repose"}}
    metadata = {"Title": title} if kind != "eps" else {}
    picture = io.BytesIO()
    before = os.environ.get("SOURCE_DATE_EPOCH")
    os.environ["SOURCE_DATE_EPOCH"] = "0"  # Matplotlib takes the date of EPS from it
    try:
        figure.savefig(picture, format=kind, dpi=dpi, metadata=metadata | dates.get(kind, {}))
    finally:
        if before is None:
            del os.environ["SOURCE_DATE_EPOCH"]
        else:
            os.environ["SOURCE_DATE_EPOCH"] = before
    return picture.getvalue()
