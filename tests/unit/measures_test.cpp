// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/results/registry.hpp"
#include "repose/results/summary.hpp"
#include "repose/scene/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace repose {
namespace {

Record<2> record_of(const std::string& method) {
  Record<2> record;
  const auto text = method == "deposition"
                        ? "[method]\nkind = \"deposition\"\ncritical_angle = 30\n[base]\nkind = "
                          "\"contiguous\"\ncount = 4\n[source]\ncount = 3\n"
                        : "[[grain]]\nposition = [0.0, 1.0]\n[stop]\ntime = 1\n[method]\nkind = \"" + method + "\"\n";
  record.scene = scene_from_text(text, "scene.toml");
  return record;
}

std::string summary_of(const Record<2>& record) { return summary_text(record, Results<2>{}); }

TEST(Measures, NamesAreUniqueAndHaveTheirObject) {
  std::set<std::string> names;
  for (const auto& measure : measures()) {
    EXPECT_TRUE(names.insert(measure.name).second) << measure.name;
    const auto dot = measure.name.rfind('.');
    if (dot == std::string::npos) continue;
    const auto* object = find_measure(measure.name.substr(0, dot));
    ASSERT_NE(object, nullptr) << measure.name;
    EXPECT_EQ(object->kind, KnownMeasure::Kind::object) << measure.name;
  }
  EXPECT_GT(names.size(), 80U);
}

TEST(Measures, AreFoundByTheNamesOfSweeps) {
  ASSERT_NE(find_measure("packing.solid_fraction.mean"), nullptr);
  EXPECT_EQ(find_measure("packing.solid_fraction.mean")->name, "packing.solid_fraction");
  EXPECT_EQ(find_measure("heap_height")->unit, "L");
  EXPECT_FALSE(find_measure("seed")->of_grains);
  EXPECT_EQ(find_measure("heap_height.mean"), nullptr);
  EXPECT_EQ(find_measure("nothing"), nullptr);
}

TEST(Measures, AreNullOrLeftOutWhereTheMethodHasNone) {
  const auto soft = summary_of(record_of("soft"));
  EXPECT_NE(soft.find("\"solver\": null"), std::string::npos);
  EXPECT_NE(soft.find("\"velocities\": \"half-step\""), std::string::npos);
  EXPECT_EQ(soft.find("\"critical_angle\""), std::string::npos);
  const auto rigid = summary_of(record_of("contact-dynamics"));
  EXPECT_NE(rigid.find("\"solver\": {\n    \"steps\": 0,\n    \"sweeps_per_step\": null"), std::string::npos);
  const auto deposited = summary_of(record_of("deposition"));
  EXPECT_NE(deposited.find("\"velocities\": null"), std::string::npos);
  EXPECT_NE(deposited.find("\"critical_angle\": 30.0,\n  \"state_hash\""), std::string::npos);
}

void add_oddities(Registry& to) {
  to.measures.push_back(measure("odd", "L", "an object", [](const Measured&) { return Object{}; }));
  to.measures.push_back(measure("odd.infinite", "L", "not a number of JSON", [](const Measured&) { return HUGE_VAL; }));
  to.measures.push_back(measure("odd.list", "L", "", [](const Measured&) { return std::vector<double>{1.5, NAN}; }));
  to.measures.push_back(measure("odd.estimate", "L", "", [](const Measured&) { return Estimate{2, 1.0, 0.5, 0.25}; }));
  to.measures.push_back(measure(
      "odd.rigid", "", "", [](const Measured&) { return 1; }, Needs::solver));
  to.measures.push_back(only_where([](const Measured&) { return false; },
                                   measure("odd.absent", "", "", [](const Measured&) { return 1; })));
  to.measures.push_back(
      measure("none", "", "an object that is null", [](const Measured&) { return std::optional<Object>(); }));
  to.measures.push_back(measure("none.below", "", "", [](const Measured&) -> int { throw std::logic_error("asked"); }));
}

TEST(Measures, OthersAreAddedByOneCall) {
  register_subject(add_oddities);
  EXPECT_THROW(register_subject(add_oddities), std::invalid_argument);
  const auto summary = summary_of(record_of("soft"));
  EXPECT_NE(summary.find("  \"odd\": {\n"
                         "    \"infinite\": null,\n"
                         "    \"list\": [\n      1.5,\n      null\n    ],\n"
                         "    \"estimate\": {\n      \"mean\": 1.0,\n      \"error\": 0.25\n    },\n"
                         "    \"rigid\": null\n"
                         "  },\n"
                         "  \"none\": null,\n"
                         "  \"checksum\""),
            std::string::npos)
      << summary;
  EXPECT_EQ(find_measure("odd.estimate.error")->unit, "L");
}

}  // namespace
}  // namespace repose
