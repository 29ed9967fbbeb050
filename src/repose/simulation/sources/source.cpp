// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/source.hpp"

#include "repose/simulation/sources/pour.hpp"
#include "repose/simulation/sources/rain.hpp"
#include "repose/simulation/sources/sequential.hpp"

namespace repose {

namespace {

/// All grains are there at the start.
class Nothing final : public Source {
 public:
  bool done() const override { return true; }
  std::int64_t released() const override { return 0; }
  std::int64_t count() const override { return 0; }
  long next_step() const override { return 0; }
  bool release(Grains<2>&, long, const std::function<double()>&) override { return false; }
  double waiting(long) const override { return 0.0; }
  std::string buried() const override { return {}; }
  void exchange(Archive&) override {}
};

}  // namespace

std::unique_ptr<Source> make_source(const Scene& scene, double time_step, std::int64_t first_id) {
  if (scene.source.kind == "pour") return std::make_unique<Pour>(scene, time_step, first_id);
  if (scene.source.kind == "rain") return std::make_unique<Rain>(scene, time_step, first_id);
  if (scene.source.kind == "sequential") return std::make_unique<Sequential>(scene, time_step, first_id);
  return std::make_unique<Nothing>();
}

}  // namespace repose
