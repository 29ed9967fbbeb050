// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Small plots by uPlot, in the colours of the page.

import uPlot from "uplot";
import { textOf, ticks } from "./colour";
import type { Inks } from "./theme";

export interface Line {
  label: string;
  values: (number | null)[];
  colour: string;
  /** Draw points instead of a line, or with it. */
  points?: boolean;
  line?: boolean;
}

export interface PlotOptions {
  width: number;
  height: number;
  inks: Inks;
  xLabel?: string;
  log?: boolean;
  /** Shown for numbers on the x axis, where these stand for names. */
  xNames?: string[];
  /** Called with x where the plot is clicked. */
  click?: (x: number) => void;
  /** Draws over the plot. */
  over?: (plot: uPlot) => void;
  /** Leave room beside the first and the last x. */
  roomy?: boolean;
  /** Bounds of y that must be seen, besides the values. */
  include?: [number, number];
}

const axisFont = '11px "Helvetica Neue", "Segoe UI", Arial, "Liberation Sans", sans-serif';

/** uPlot wants null where a value is not defined; logarithms leave out what is not positive. */
export function plottable(values: ArrayLike<number>, log = false): (number | null)[] {
  return Array.from({ length: values.length }, (_, i) => {
    const value = values[i]!;
    return Number.isFinite(value) && (!log || value > 0) ? value : null;
  });
}

export function makePlot(parent: HTMLElement, x: ArrayLike<number>, lines: Line[], options: PlotOptions): uPlot {
  const { inks } = options;
  const grid = { stroke: `${inks.faint}33`, width: 1 };
  const ticks = { stroke: `${inks.faint}66`, width: 1, size: 4 };
  const axis = { stroke: inks.ink, font: axisFont, grid, ticks };
  const names = options.xNames;
  const plot = new uPlot(
    {
      width: Math.max(options.width, 60),
      height: options.height,
      legend: { show: false },
      padding: [8, 10, 0, 0],
      cursor: { drag: { x: true, y: false }, points: { size: 6 }, y: false },
      scales: {
        x: { time: false, ...(names ? { range: (): [number, number] => [-0.5, names.length - 0.5] } : options.roomy ? { range: roomy } : {}) },
        y: {
          distr: options.log ? 3 : 1,
          ...(options.log || !options.include ? {} : { range: includeRange(options.include) }),
        },
      },
      axes: [
        {
          ...axis,
          size: options.xLabel ? 28 : 24,
          ...(options.xLabel ? { label: options.xLabel, labelSize: 16, labelFont: axisFont, labelGap: -2 } : {}),
          space: 56,
          values: (_: uPlot, places: number[]) => places.map((value) => (names ? names[value] ?? "" : textOf(Number(value.toPrecision(10)), 5))),
          ...(names ? { splits: () => names.map((_, i) => i) } : {}),
        },
        {
          ...axis,
          size: 50,
          space: 26,
          ...(options.log ? { splits: powers, filter: (_: uPlot, places: number[]) => places } : {}),
          values: (_: uPlot, places: (number | null)[]) => places.map((value) => (value === null ? "" : textOf(Number(value.toPrecision(10)), 4))),
        },
      ],
      series: [
        {},
        ...lines.map((line) => ({
          label: line.label,
          stroke: line.colour,
          width: line.line === false ? 0 : 1.4,
          spanGaps: false,
          points: { show: line.points === true, size: 6, fill: line.colour, stroke: line.colour },
        })),
      ],
      hooks: { draw: options.over ? [options.over] : [] },
    },
    [Array.from(x), ...lines.map((line) => line.values)] as uPlot.AlignedData,
    parent,
  );
  if (options.click) {
    let from = 0;
    plot.over.addEventListener("pointerdown", (event) => (from = event.clientX));
    plot.over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - from) < 4) options.click!(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
    });
  }
  return plot;
}

function roomy(_: uPlot, from: number, to: number): [number, number] {
  const margin = 0.04 * (to - from) || Math.abs(from) * 0.1 || 1;
  return [from - margin, to + margin];
}

/** At most five powers of ten. */
function powers(plot: uPlot): number[] {
  const { min, max } = plot.scales["y"]!;
  return min && max && min > 0 ? ticks({ low: min, high: max, log: true }, 4) : [];
}

function includeRange([low, high]: [number, number]): (plot: uPlot, from: number, to: number) => [number, number] {
  return (_, from, to) => {
    const least = Math.min(from ?? low, low);
    const most = Math.max(to ?? high, high);
    const margin = 0.06 * (most - least) || 1;
    return [least - margin, most + margin];
  };
}

/** A line at x, over a plot. */
export function cursorAt(plot: uPlot, x: number, colour: string): void {
  const { ctx, bbox } = plot;
  const at = Math.round(plot.valToPos(x, "x", true)) + 0.5;
  if (!(at >= bbox.left - 1 && at <= bbox.left + bbox.width + 1)) return;
  ctx.save();
  ctx.strokeStyle = colour;
  ctx.lineWidth = window.devicePixelRatio || 1;
  ctx.beginPath();
  ctx.moveTo(at, bbox.top);
  ctx.lineTo(at, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}
