// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The library as other programs see it. These headers need the standard library alone; units are those of the scene:
// M, L, T in reduced units. How to build against an installed Repose: docs/how-to/use-the-library.md.

#include "repose/api/analysis.hpp"
#include "repose/api/scene.hpp"
#include "repose/api/simulation.hpp"
#include "repose/api/theory.hpp"
