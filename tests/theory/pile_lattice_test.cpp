// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/pile_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace repose::theory {
namespace {

using std::numbers::pi;

struct Force {
  double x = 0.0;
  double y = 0.0;
};

// The pile as a set of positions (row, twice x). Its forces follow from the balance of one disc after another, from the
// top row down, without counting diagonals.
class BruteForcePile {
 public:
  BruteForcePile(double slope_deg, std::int64_t base_count) {
    const double tan_slope = std::tan(slope_deg * (pi / 180.0));
    for (std::int64_t row = 0; row < base_count; ++row) {
      for (std::int64_t twice_x = row; twice_x <= 2 * (base_count - 1) - row; twice_x += 2) {
        const double x = 0.5 * static_cast<double>(twice_x);
        const double y = 0.5 * std::numbers::sqrt3 * static_cast<double>(row);
        const double bound = tan_slope * std::min(x, static_cast<double>(base_count - 1) - x);
        if (y <= bound + 1e-9) load_[{-row, twice_x}] = {0.0, 1.0};
      }
    }
    for (auto& [place, load] : load_) {
      if (place.first < 0) pass_down(place, load);
    }
  }

  std::size_t discs() const { return load_.size(); }
  bool every_disc_has_both_supports() const { return supported_; }

  /// The loads on the disc from above plus its weight, y downward: the force of the disc on the ground.
  Force on_ground(std::int64_t i) const { return load_.at({0, 2 * i}); }

 private:
  using Place = std::pair<std::int64_t, std::int64_t>;  // minus row, twice x: the top row comes first

  /// The forces f and g that carry the load along the contacts down to the left and right, (-1/2, cos 30) and
  /// (1/2, cos 30).
  void pass_down(const Place& place, const Force& load) {
    const double cosine = std::cos(pi / 6.0);
    const double sum = load.y / cosine;
    const double difference = 2.0 * load.x;
    for (const auto& [side, size] : {std::pair{-1, 0.5 * (sum - difference)}, std::pair{1, 0.5 * (sum + difference)}}) {
      const auto support = load_.find({place.first + 1, place.second + side});
      if (support == load_.end()) {
        supported_ = false;
        continue;
      }
      support->second.x += 0.5 * side * size;
      support->second.y += cosine * size;
    }
  }

  std::map<Place, Force> load_;
  bool supported_ = true;
};

const std::vector<double> slopes = {0.4, 5.0, 17.3, 30.0, 41.9, 45.0, 52.6, 59.0, 59.999, 60.0};

// Tolerance: sums of up to 60 rows of rounded forces.
TEST(PileLattice, EqualsForcesPassedDownDiscByDisc) {
  for (const double slope : slopes) {
    for (const std::int64_t n : {2, 3, 7, 20, 45, 60}) {
      const BruteForcePile pile{slope, n};
      EXPECT_TRUE(pile.every_disc_has_both_supports()) << slope << ' ' << n;
      const PileLattice model{.slope_deg = slope, .base_count = n};
      EXPECT_EQ(evaluate(model).number("discs"), static_cast<double>(pile.discs())) << slope << ' ' << n;
      for (std::int64_t i = 0; i < n; ++i) {
        const auto force = base_force(model, i);
        const auto expected = pile.on_ground(i);
        EXPECT_NEAR(force.normal, expected.y, 1e-11) << slope << ' ' << n << ' ' << i;
        EXPECT_NEAR(force.shear, expected.x, 1e-11) << slope << ' ' << n << ' ' << i;
      }
    }
  }
}

TEST(PileLattice, NormalForcesSumToTheWeightExactly) {
  for (const double slope : slopes) {
    for (const std::int64_t n : {2, 44, 45, 1001, 100'000}) {
      const auto table = evaluate(PileLattice{.slope_deg = slope, .base_count = n});
      double sum = 0.0;  // halves: exact
      for (const double normal : table.column("normal").values) sum += normal;
      EXPECT_EQ(sum, table.number("weight")) << slope << ' ' << n;
    }
  }
}

// The numbers of discs in the paper. At 60 degrees, eqs (42) and (44), with discs counted from 1.
TEST(PileLattice, PublishedPiles) {
  EXPECT_EQ(evaluate(PileLattice{.slope_deg = 30.0, .base_count = 45}).number("discs"), 360.0);
  EXPECT_EQ(evaluate(PileLattice{.slope_deg = 30.0, .base_count = 180}).number("discs"), 5490.0);
  for (const std::int64_t k : {2, 45, 1000, 1'000'000}) {
    const PileLattice model{.slope_deg = 60.0, .base_count = k};
    const auto layers = static_cast<double>(k);
    EXPECT_EQ(evaluate(model).number("discs"), 0.5 * layers * (layers + 1.0)) << k;
    for (const std::int64_t i : {std::int64_t{1}, std::int64_t{2}, (k + 1) / 2, k}) {
      const auto force = base_force(model, i - 1);
      const double horizontal = (2.0 * static_cast<double>(i) - layers - 1.0) / (2.0 * std::numbers::sqrt3);
      EXPECT_EQ(force.normal, 0.5 * (layers + 1.0)) << k << ' ' << i;
      EXPECT_NEAR(force.shear, horizontal, 1e-15 * layers) << k << ' ' << i;
    }
  }
  const auto corner = base_force(PileLattice{.slope_deg = 60.0, .base_count = 45}, 44);
  EXPECT_NEAR(corner.shear, 12.70, 0.005);
}

}  // namespace
}  // namespace repose::theory
