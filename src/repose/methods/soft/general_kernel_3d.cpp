// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/make_kernel.hpp"

namespace repose {

template std::unique_ptr<Method<3>> make_kernel(MaterialTable<AnyPairLaw>, SoftSettings<3>);

}  // namespace repose
