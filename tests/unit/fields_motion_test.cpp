// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"
#include "repose/core/random.hpp"
#include "support/fields.hpp"
#include "support/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace repose {
namespace {

/// A square lattice of `side` discs in x and y, with given velocities.
Grains<2> lattice(int side, const std::function<Vec<2>(const Vec<2>&, int)>& velocity) {
  Grains<2> grains;
  for (int k = 0; k < side * side; ++k) {
    auto grain = unit_disc(k % side, k / side);
    grain.velocity = velocity(grain.position, k);
    grains.add(grain, k);
  }
  return grains;
}

/// Two independent numbers with mean 0 and variance 1.
Vec<2> normal_pair(int k) {
  const auto draw = [&](std::uint32_t n) { return uniform(5, Purpose::grain_size, static_cast<std::uint64_t>(k), n); };
  const double size = std::sqrt(-2.0 * std::log(1.0 - draw(0)));
  const double angle = 2.0 * std::numbers::pi * draw(1);
  return {{size * std::cos(angle), size * std::sin(angle)}};
}

// Linear flows, v = a + G r. In the bulk the mean velocity is that at the place, because a Gaussian leaves linear
// fields (ripple of the lattice: exp(-2 pi^2) = 3e-9). The variance about the mean velocity would be width^2 |G|^2/2;
// about the linear flow it is zero at any place, edges included, to the rounding of squared velocities of 1e3.
TEST(FieldsOfMotion, LinearFlowsHaveNoTemperature) {
  struct Flow {
    double xx, xy, yx, yy;
  };
  for (const auto& g :
       {Flow{0.0, 0.0, 0.0, 0.0}, Flow{0.0, -0.5, 0.5, 0.0}, Flow{0.0, 1.2, 0.0, 0.0}, Flow{0.7, 0.0, 0.0, -0.7}}) {
    const auto flow = [&](const Vec<2>& r) {
      return Vec<2>{{3.0 + g.xx * r[0] + g.xy * r[1], -2.0 + g.yx * r[0] + g.yy * r[1]}};
    };
    const auto grains = lattice(24, [&](const Vec<2>& r, int) { return flow(r); });
    const auto fields = coarse_grained({grains, {}}, {}, all_of(grains), {}, {1.0});
    std::size_t inside = 0;
    for (std::size_t k = 0; k < fields.density.size(); ++k) {
      const Vec<2> place{{fields.x[k % fields.x.size()], fields.y[k / fields.x.size()]}};
      if (fields.density[k] > 0.1) {
        EXPECT_NEAR(fields.temperature[k], 0.0, 1e-11);
      }
      if (std::min({place[0], place[1], 23.0 - place[0], 23.0 - place[1]}) < 7.0) continue;
      ++inside;
      for (int a = 0; a < 2; ++a) EXPECT_NEAR(fields.velocity[static_cast<std::size_t>(a)][k], flow(place)[a], 1e-6);
    }
    EXPECT_GT(inside, 100U);
  }
}

// Independent velocities of variance 4 on top of a shear flow. A width of 1 leaves 4 pi = 12.6 grains in a Gaussian, of
// which the fit takes 2/12.6 = 16 % away; the estimate has no such bias. The mean over the grains has a relative
// standard error of 1/sqrt(N) = 1.7 %, a little more by the overlap of Gaussians; tolerance 4 of them.
TEST(FieldsOfMotion, ThermalVelocitiesHaveTheirVariance) {
  const auto grains = lattice(60, [](const Vec<2>& r, int k) {
    const auto thermal = normal_pair(k) * 2.0;
    return Vec<2>{{thermal[0] + 0.3 * r[1], thermal[1]}};
  });
  const auto fields = coarse_grained({grains, {}}, {}, all_of(grains), {}, {1.0});
  double mean = 0.0;
  double mass = 0.0;
  for (std::size_t k = 0; k < fields.density.size(); ++k) {
    if (!(fields.density[k] > 0.2)) continue;
    mean += fields.density[k] * fields.temperature[k];
    mass += fields.density[k];
  }
  EXPECT_NEAR(mean / mass / 4.0, 1.0, 0.07);
}

// One grain has a velocity, but no temperature.
TEST(FieldsOfMotion, ASingleGrainHasNoTemperature) {
  Grains<2> grains;
  grains.add(unit_disc(0.0, 0.0), 0);
  grains.line[0].velocity = {{1.0, -2.0}};
  const auto fields = coarse_grained({grains, {}}, {}, {true}, {}, {1.0});
  for (std::size_t k = 0; k < fields.density.size(); ++k) {
    if (!(fields.density[k] > 1e-6)) continue;
    EXPECT_TRUE(std::isnan(fields.temperature[k]));
    EXPECT_NEAR(fields.velocity[0][k], 1.0, 1e-12);
    EXPECT_NEAR(fields.velocity[1][k], -2.0, 1e-12);
  }
}

// The lattice pile has contacts at +-60 degrees alone: fabric diag(1/4, 3/4), four contacts per disc, two per lattice
// cell of area sqrt(3)/2. Away from the surface the ripple is damped by 4e-12 (fields_test.cpp). A threshold above all
// forces leaves nothing.
TEST(FieldsOfContacts, FabricOfTheLatticePile) {
  const auto pile = lattice_pile(45);
  const auto fields = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {1.0, 0.2});
  std::size_t compared = 0;
  for (std::size_t k = 0; k < fields.density.size(); ++k) {
    const double x = fields.x[k % fields.x.size()];
    const double y = fields.y[k / fields.x.size()];
    const double away = std::min({y, (std::sqrt(3.0) * x - y) / 2.0, (std::sqrt(3.0) * (44.0 - x) - y) / 2.0});
    if (away < 8.0) continue;
    ++compared;
    EXPECT_NEAR(fields.fabric[0][k], 0.25, 1e-9);
    EXPECT_NEAR(fields.fabric[1][k], 0.0, 1e-9);
    EXPECT_NEAR(fields.fabric[2][k], 0.75, 1e-9);
    EXPECT_NEAR(fields.coordination[k], 4.0, 1e-9);
    EXPECT_NEAR(fields.contacts[k], 4.0 / std::sqrt(3.0), 1e-9);
  }
  EXPECT_GT(compared, 20U);
  const auto none = coarse_grained({pile.grains, {}}, pile.contacts, all_of(pile.grains), {}, {1.0, 1e3});
  for (std::size_t k = 0; k < none.density.size(); ++k) {
    EXPECT_EQ(none.contacts[k], 0.0);
    EXPECT_TRUE(std::isnan(none.fabric[0][k]));
    if (none.density[k] > 0.0) {
      EXPECT_EQ(none.coordination[k], 0.0);
    }
  }
}

}  // namespace
}  // namespace repose
