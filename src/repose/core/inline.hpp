// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks small functions that inner loops call and that must be inlined; without it, compilers may silently decline.
#define REPOSE_FN [[gnu::always_inline]] inline
