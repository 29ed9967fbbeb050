// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/source.hpp"

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

void SourceKind::add_grains(const Scene&, Grains<2>&, std::int64_t&) const {}

std::unique_ptr<Source> SourceKind::start(const Scene&, double, std::int64_t) const {
  return std::make_unique<Nothing>();
}

std::unique_ptr<Source> make_source(const Scene& scene, double time_step, std::int64_t first_id) {
  return scene.source->start(scene, time_step, first_id);
}

}  // namespace repose
