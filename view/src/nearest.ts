// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

/** A displacement by the nearest image in a box that is periodic over `period` (0: it is not). */
export function nearest(dx: number, period: number): number {
  return period > 0 ? dx - period * Math.round(dx / period) : dx;
}
