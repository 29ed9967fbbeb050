// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace repose {

/// 1 / (I / m r^2): a disc has I = m r^2 / 2, a sphere 2/5 m r^2.
template <int D>
inline constexpr double inverse_inertia_factor = D == 2 ? 2.0 : 2.5;

}  // namespace repose
