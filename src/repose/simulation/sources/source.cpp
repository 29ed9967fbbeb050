// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/source.hpp"

#include "repose/simulation/sources/pour.hpp"
#include "repose/simulation/sources/rain.hpp"
#include "repose/simulation/sources/sequential.hpp"

#include <limits>

namespace repose {

namespace {

/// All grains exist at the start.
class Nothing final : public Source {
 public:
  bool done() const override { return true; }
  std::int64_t released() const override { return 0; }
  std::int64_t count() const override { return 0; }
  double due() const override { return std::numeric_limits<double>::infinity(); }
  bool release(Grains<2>&, double, const std::function<double()>&) override { return false; }
  double waiting(double) const override { return 0.0; }
  std::string buried() const override { return {}; }
  void exchange(Archive&) override {}
};

}  // namespace

std::unique_ptr<Source> make_source(const Scene& scene, const TimeSteps& steps, std::int64_t first_id) {
  if (scene.source.kind == "pour") return std::make_unique<Pour>(scene, steps, first_id);
  if (scene.source.kind == "rain") return std::make_unique<Rain>(scene, steps, first_id);
  if (scene.source.kind == "sequential") return std::make_unique<Sequential>(scene, steps, first_id);
  return std::make_unique<Nothing>();
}

}  // namespace repose
