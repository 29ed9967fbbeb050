# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Legends and colour bars in rows above the axes of a picture of grains."""

from matplotlib.backends.backend_agg import FigureCanvasAgg

from repose import style

# inches
LEGEND_ROW = 0.18
BAR_ROW = 0.34  # a colour bar with its numbers
BAR_WIDTH, BAR_HEIGHT = 2.0, 0.08


def legend_above(panel, handles, title=None, down=0.0):
    """One row of handles above the axes, `down` [inch] below the upper edge of the space for legends."""
    at = _title_above(panel, title, down)
    labels = [handle.get_label() for handle in handles]
    panel.figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=len(handles))


def colour_bar_above(panel, mappable, title, handles=(), extend="neither"):
    """Title, colour bar and handles in one row above the axes."""
    width, height = panel.figure.get_size_inches()
    left, top = _title_above(panel, title)
    low = top - (BAR_HEIGHT + 0.02) / height
    axes = panel.figure.add_axes([left, low, BAR_WIDTH / width, BAR_HEIGHT / height])
    bar = panel.figure.colorbar(mappable, cax=axes, orientation="horizontal", extend=extend)
    bar.outline.set_linewidth(0.4)
    axes.tick_params(labelsize=6, length=2, pad=1.5)
    axes.locator_params(axis="x", nbins=6, steps=[1, 2, 5, 10])
    if handles:
        at = (left + (BAR_WIDTH + 0.25) / width, top)
        labels = [handle.get_label() for handle in handles]
        panel.figure.legend(handles, labels, loc="upper left", bbox_to_anchor=at, ncol=len(handles))


def _title_above(panel, title, down=0.0):
    """Writes the title of a row; the point (x, y) where the row continues, as fractions of the figure."""
    width, height = panel.figure.get_size_inches()
    at = (0.08 / width, 1.0 - (panel.legend_top + down - 0.04) / height)
    if not title:
        return at
    text = panel.figure.text(*at, title, ha="left", va="top", fontsize=7, color=style.INK)
    extent = text.get_window_extent(FigureCanvasAgg(panel.figure).get_renderer())
    return ((extent.x1 / panel.figure.dpi + 0.12) / width, at[1])
