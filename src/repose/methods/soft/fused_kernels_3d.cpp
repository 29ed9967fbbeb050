// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/methods/soft/make_kernel.hpp"

namespace repose {

template std::unique_ptr<Method<3>> make_kernel(MaterialTable<HookeLinear>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<HookeCumulative>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<HertzMindlin>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<ElasticHertzMindlin>, SoftSettings<3>);
template std::unique_ptr<Method<3>> make_kernel(MaterialTable<ContinuousCumulative>, SoftSettings<3>);

}  // namespace repose
