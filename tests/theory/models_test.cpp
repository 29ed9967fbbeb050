// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/models.hpp"

#include "repose/core/errors.hpp"

#include <gtest/gtest.h>

#include <string>

namespace repose::theory {
namespace {

std::string complaint(const std::string& model, const std::vector<Setting>& settings) {
  try {
    make_model(model, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Models, AllProblemsAtOnce) {
  EXPECT_EQ(complaint("pile-continuum", {{"slope_deg", "61"}, {"points", "2.5"}, {"slope", "3"}}),
            "pile-continuum: slope_deg = 61: must be > 0 and < 60 (deg)\n"
            "pile-continuum: points = 2.5: is not a whole number; must be from 2 to 1000000\n"
            "pile-continuum: slope: no such parameter; must be points | slope_deg");
  EXPECT_EQ(complaint("pile-continuum", {{"slope_deg", "3"}, {"slope_deg", "4"}}),
            "pile-continuum: slope_deg = 4: is set twice");
  EXPECT_EQ(complaint("pile-continuum", {{"slope_deg", "30deg"}}),
            "pile-continuum: slope_deg = 30deg: is not a number; must be > 0 and < 60 (deg)");
  EXPECT_EQ(complaint("pile-continuum", {{"slope_deg", "nan"}}),
            "pile-continuum: slope_deg = nan: is not a number; must be > 0 and < 60 (deg)");
  EXPECT_NE(complaint("pyramid", {}).find("pyramid: no such model of theory; must be "), std::string::npos);
}

TEST(Models, NamesAndTextsAreComplete) {
  for (const auto& model : default_models()) {
    const auto text = text_of(model);
    EXPECT_FALSE(text.name.empty());
    EXPECT_FALSE(text.about.empty()) << text.name;
    EXPECT_FALSE(text.source.empty()) << text.name;
    for (const auto& parameter : parameters_of(model)) EXPECT_FALSE(parameter.about.empty()) << parameter.name;
  }
}

}  // namespace
}  // namespace repose::theory
