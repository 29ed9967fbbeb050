// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/scene/quantity.hpp"

#include "repose/core/errors.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/write.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace repose {
namespace {

// Decimal numbers that the library's factors give exactly once they are rounded to 15 digits.
TEST(Quantity, IsANumberInTheUnitOfItsKey) {
  EXPECT_EQ(number_of_quantity("5 mm", "L"), 5e-3);
  EXPECT_EQ(number_of_quantity("6.9e-1 cm", "L"), 6.9e-3);
  EXPECT_EQ(number_of_quantity("2 g/cm^3", "M/L^3"), 2000.0);
  EXPECT_EQ(number_of_quantity("70 GPa", "M/(L T^2)"), 7e10);
  EXPECT_EQ(number_of_quantity("4 N/mm", "M/T^2"), 4000.0);
  EXPECT_EQ(number_of_quantity("-3 cm/s", "L/T"), -0.03);
  EXPECT_EQ(number_of_quantity("2 min", "T"), 120.0);
  EXPECT_EQ(number_of_quantity("50 Hz", "1/T"), 50.0);
  EXPECT_EQ(number_of_quantity("3 kN", "M L/T^2"), 3000.0);
  EXPECT_EQ(number_of_quantity("30 degrees", "deg"), 30.0);
  EXPECT_NEAR(number_of_quantity("1 rad", "deg"), 57.2957795130823, 1e-12);
}

std::string refusal(const std::string& text, const std::string& unit) {
  try {
    number_of_quantity(text, unit);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Quantity, OfAnotherKindOrWithoutAUnitIsRefused) {
  EXPECT_EQ(refusal("5 kg", "L"), "is of another kind; must be a quantity in m");
  EXPECT_EQ(refusal("5", "L"), "is of another kind; must be a quantity in m");
  EXPECT_EQ(refusal("5 mmm", "L"), "is no quantity that is known; must be a number in m");
  EXPECT_EQ(refusal("5 mm", "diameters"), "must be a plain number");
  EXPECT_EQ(refusal("5 mm", ""), "must be a plain number");
}

constexpr const char* silo = R"({}
[grains]
diameter = {}
[[material]]
name = "glass"
density = {}
young_modulus = {}
poisson_ratio = 0.22
[contact]
normal = {{ law = "hertz", restitution = 0.6 }}
[base]
kind = "plane"
[source]
kind = "pour"
count = 5
rate = {}
height = {}
velocity = {}
[stop]
time = {}
)";

TEST(Quantity, ScenesWithUnitsEqualThoseWithNumbers) {
  const auto units = fmt::format(fmt::runtime(silo), "units = \"SI\"", "\"5 mm\"", "\"2.5 g/cm^3\"", "\"100 MPa\"",
                                 "\"20 Hz\"", "\"12 cm\"", "[\"-10 cm/s\", 0.0]", "\"1 min\"");
  const auto numbers = fmt::format(fmt::runtime(silo), "units = \"SI\"", "0.005", "2500.0", "1e8", "20.0", "0.12",
                                   "[-0.1, 0.0]", "60.0");
  EXPECT_EQ(scene_text(scene_from_text(units, "scene")), scene_text(scene_from_text(numbers, "scene")));
}

TEST(Quantity, EveryMistakeOfASceneIsALine) {
  const auto text = fmt::format(fmt::runtime(silo), "units = \"SI\"", "\"5 kg\"", "2500.0", "\"1 MP\"", "20.0", "0.12",
                                "[\"1 s\", 0.0]", "60.0");
  try {
    scene_from_text(text, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 3U);
    EXPECT_EQ(error.problems()[0],
              "scene.toml:3: grains.diameter = \"5 kg\": is of another kind; must be a quantity in m");
  }
  const auto reduced =
      fmt::format(fmt::runtime(silo), "", "\"5 mm\"", "1.0", "1e8", "20.0", "0.12", "[0.0, 0.0]", "60.0");
  try {
    scene_from_text(reduced, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems()[0],
              "scene.toml:3: grains.diameter = \"5 mm\": a quantity with a unit needs units = \"SI\"");
  }
}

}  // namespace
}  // namespace repose
