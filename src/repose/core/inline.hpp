// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Marks what an inner loop calls: small functions that must be inlined (compilers decline silently otherwise).
#define REPOSE_FN [[gnu::always_inline]] inline
