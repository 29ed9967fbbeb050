// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/make_kernel.hpp"

// The kernels in 3D that tests run.

namespace repose {

template std::unique_ptr<Method<3>> make_kernel(MaterialTable<AnyPairLaw>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<ContinuousCumulative>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<ElasticHertzMindlin>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<HookeLinear>, SoftSettings<3>);

}  // namespace repose
