// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/source.hpp"

#include <limits>

namespace repose {

namespace {

/// All grains exist at the start.
template <int D>
class Nothing final : public Source<D> {
 public:
  bool done() const override { return true; }
  std::int64_t released() const override { return 0; }
  std::int64_t count() const override { return 0; }
  double due() const override { return std::numeric_limits<double>::infinity(); }
  bool release(Grains<D>&, double, const SourceView&) override { return false; }
  double waiting(double) const override { return 0.0; }
  std::string buried() const override { return {}; }
  void exchange(Archive&) override {}
};

}  // namespace

void SourceKind::add_grains(const Scene&, Grains<2>&, std::int64_t&) const {}
void SourceKind::add_grains(const Scene&, Grains<3>&, std::int64_t&) const {}

std::unique_ptr<Source<2>> SourceKind::start(const Scene&, const TimeSteps&, std::int64_t, Dimension<2>) const {
  return std::make_unique<Nothing<2>>();
}
std::unique_ptr<Source<3>> SourceKind::start(const Scene&, const TimeSteps&, std::int64_t, Dimension<3>) const {
  return std::make_unique<Nothing<3>>();
}

}  // namespace repose
