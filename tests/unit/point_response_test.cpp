// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/read.hpp"
#include "repose/sweep/response.hpp"
#include "repose/theory/point_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace repose {
namespace {

constexpr double depth = 16.0;
constexpr double poisson = 0.3;
constexpr double past_linear = 1.05;                     // of the response to the larger load
const std::vector<double> amplitudes = {0.9, 1.0, 1.1};  // by seed: mean 1, standard deviation 0.1

constexpr auto smooth_springs = "[contact]\nfriction = 0.0\n";

Scene bed(double place, double force, const std::string& contact) {
  auto scene = scene_from_text(contact + R"([base]
kind = "row"
half_width = 40
[source]
kind = "pour"
count = 1
rate = 1.0
height = 20
half_width = 2
[stop]
time = 1.0
)",
                               "bed.toml");
  scene.box.x = "periodic";
  scene.box.half_width = 40.5;
  if (force > 0.0) scene.loads = {{.position = {place, depth}, .force = {0.0, -force}}};
  return scene;
}

/// The fraction of the load that a disc of the base carries, by an elastic layer.
double fraction_of_load(double from_load) {
  theory::PointLoad layer;
  layer.floor = "rough-rigid";
  layer.poisson = poisson;
  layer.load_width = 1.0 / depth;
  constexpr int parts = 40;
  double sum = 0.0;
  for (int k = 0; k < parts; ++k) {
    sum += theory::elastic_stress(layer, (from_load + (k + 0.5) / parts - 0.5) / depth) / depth / parts;
  }
  return sum;
}

/// A plan with an unloaded bed, two positions of a load of 2 and one of a load of 4, and members with planted
/// responses.
struct Planted {
  SweepPlan plan;
  SweepTable table;

  explicit Planted(const std::string& contact = smooth_springs) {
    plan.seeds = {1, 2, 3};
    const std::vector<std::pair<double, double>> loads = {{0.0, 0.0}, {0.0, 2.0}, {5.0, 2.0}, {0.0, 4.0}};
    for (const auto& [place, force] : loads) {
      SweepPoint point;
      point.name = "point-" + std::to_string(plan.points.size());
      point.scene = bed(place, force, contact);
      plan.points.push_back(point);
      for (std::size_t s = 0; s < plan.seeds.size(); ++s) {
        // Differences between the positions of a seed cancel in its mean.
        const double at_place = place > 0.0 ? -0.02 : 0.02;
        const double amplitude = (amplitudes[s] + at_place) * (force > 3.0 ? past_linear : 1.0);
        MemberRow member{
            .point = plan.points.size() - 1, .seed = plan.seeds[s], .status = "finished", .values = {}, .base = {}};
        for (int k = -40; k <= 40; ++k) {
          const double from_load = std::remainder(k - place, 81.0);
          member.base.x.push_back(k);
          member.base.normal.push_back(10.0 + std::sin(k) + force * amplitude * fraction_of_load(from_load));
          member.base.shear.push_back(0.0);
        }
        table.members.push_back(std::move(member));
      }
    }
  }

  Record<2> state() const {
    Record<2> record;
    record.scene = plan.points[0].scene;
    Grains<2> grains;
    for (const double x : {0.0, 5.0}) {
      Grain<2> grain;
      grain.position = {{x, depth}};
      grain.inverse_mass = 1.0;
      grains.add(grain, static_cast<std::int64_t>(x));
    }
    record.grains = {grains, {}};
    return record;
  }

  std::vector<PointResponse> responses() const {
    return point_responses(plan, table, [&](std::size_t /*member*/) { return state(); });
  }
};

TEST(PointResponse, FindsThePlantedResponse) {
  const auto responses = Planted{}.responses();
  ASSERT_EQ(responses.size(), 2U);
  const auto& one = responses[0];
  EXPECT_EQ(one.without, "point-0");
  EXPECT_EQ(one.places, 2U);
  EXPECT_EQ(one.depth.count, 3U);
  EXPECT_DOUBLE_EQ(one.depth.mean, depth);
  EXPECT_DOUBLE_EQ(one.bin, 2.0 / depth);  // whole pitches, at least a tenth of the depth
  double total = 0.0;
  double moment = 0.0;
  for (int k = -40; k <= 40; ++k) {
    total += fraction_of_load(k);
    if (std::abs(k) <= 2.0 * depth) moment += k * k / depth / depth * fraction_of_load(k);
  }
  EXPECT_NEAR(one.total.mean, total, 1e-12);
  EXPECT_NEAR(total, 1.0, 0.015);  // the rest, 1 %, lies beyond 2.53 depths
  EXPECT_NEAR(one.second_moment.mean, moment, 1e-12);
  EXPECT_NEAR(one.second_moment.error, 0.1 / std::sqrt(3.0) * moment, 1e-12);  // between seeds, not between positions
  for (std::size_t b = 0; b < one.x.size(); ++b) {
    // The bin is two pitches wide and holds half of each outer disc.
    const double k = one.x[b] * depth;
    const double expected =
        (0.5 * fraction_of_load(k - 1.0) + fraction_of_load(k) + 0.5 * fraction_of_load(k + 1.0)) * depth / 2.0;
    EXPECT_NEAR(one.bins[b].mean, expected, 1e-12) << one.x[b];
    EXPECT_NEAR(one.bins[b].error, 0.1 / std::sqrt(3.0) * std::abs(expected), 1e-12) << one.x[b];
  }
  EXPECT_TRUE(std::isnan(one.nonlinearity));
  // The first amplitude of the larger load against the smaller one, at their common position.
  EXPECT_NEAR(responses[1].nonlinearity, past_linear - 1.0, 1e-12);
}

TEST(PointResponse, JudgesTheCurves) {
  const auto one = Planted{}.responses()[0];
  ASSERT_EQ(one.curves.size(), 4U);
  for (const auto& curve : one.curves) {
    double chi_square = 0.0;
    for (std::size_t b = 0; b < one.x.size(); ++b) {
      const double off = (one.bins[b].mean - curve.values[b]) / (0.1 / std::sqrt(3.0) * one.bins[b].mean);
      chi_square += off * off;
    }
    EXPECT_NEAR(curve.chi_square, chi_square, 1e-6 * chi_square) << curve.name;
  }
  EXPECT_EQ(one.poisson, 0.25);  // for springs without a tangential part
  // Forces are spread over a pitch, 1/16 of the depth, which changes the fit by about its square.
  EXPECT_NEAR(one.fitted_poisson, poisson, 0.02);
  EXPECT_LT(one.curves[3].chi_square, one.curves[0].chi_square);
  EXPECT_LT(one.curves[0].chi_square, 0.1 * one.curves[1].chi_square);
}

// Rigid grains have a friction of their own, in the law of impulses: smooth ones are a network without tangential
// stiffness, nu = (1 - 0)/4, others have k_t/k_n = 1/2.
TEST(PointResponse, PoissonRatioOfRigidGrainsIsOfTheirFriction) {
  const std::string rigid = "[method]\nkind = \"contact-dynamics\"\n[contact]\nfriction = ";
  EXPECT_EQ(Planted(rigid + "0.0\n").responses()[0].poisson, 0.25);
  EXPECT_EQ(Planted(rigid + "0.5\n").responses()[0].poisson, 0.125);
  EXPECT_EQ(Planted("[contact]\nfriction = 0.5\n").responses()[0].poisson, 0.125);
}

TEST(PointResponse, NeedsSeedsInCommon) {
  Planted planted;
  for (auto& member : planted.table.members) {
    if (member.point == 0 && member.seed == 2) member.status = "failed";
  }
  EXPECT_EQ(planted.responses()[0].depth.count, 2U);
  for (auto& member : planted.table.members) {
    if (member.point == 0) member.status = "failed";
  }
  EXPECT_TRUE(planted.responses().empty());
}

}  // namespace
}  // namespace repose
