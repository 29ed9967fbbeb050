// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/methods/hybrid.hpp"
#include "repose/scene/methods/soft.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/scene.hpp"

#include <gtest/gtest.h>

namespace repose {
namespace {

const std::string pile = R"(
[method]
kind = "soft"
[contact]
friction = 0.3
[for.soft]
method.viscous_damping = 3.0
contact.normal = { law = "hooke", stiffness = 4e4 }
[for.hybrid]
method.stiffness = 1e5
contact.friction = 0.0
[base]
kind = "plane"
[source]
kind = "lattice"
rows = 5
[stop]
time = 1
)";

Scene read(const std::vector<std::string>& settings, const std::string& text = pile) {
  Overrides overrides;
  overrides.set = settings;
  return scene_from_text(text, "pile.toml", overrides);
}

std::vector<std::string> problems_of(const std::vector<std::string>& settings, const std::string& text = pile) {
  try {
    read(settings, text);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(ForMethod, EachMethodHasItsKeys) {
  const auto soft = read({});
  EXPECT_EQ(soft.method.as<SoftMethod>()->viscous_damping, 3.0);
  EXPECT_EQ(std::get<Hooke>(soft.contact.normal).stiffness, 4e4);
  EXPECT_EQ(soft.contact.friction, 0.3);
  const auto hybrid = read({"method.kind=hybrid"});
  EXPECT_EQ(hybrid.method.as<HybridMethod>()->given_stiffness, 1e5);
  EXPECT_EQ(hybrid.contact.impulse.friction, 0.0);
  EXPECT_EQ(read({"method.kind=contact-dynamics"}).contact.impulse.friction, 0.3);
}

// What is set replaces what the file says for the method, in whatever order the settings come.
TEST(ForMethod, SettingsComeLast) {
  const auto one = read({"method.stiffness=2e5", "method.kind=\"hybrid\"", "contact.friction=0.2"});
  EXPECT_EQ(one.method.as<HybridMethod>()->given_stiffness, 2e5);
  EXPECT_EQ(one.contact.impulse.friction, 0.2);
  EXPECT_EQ(read({"method={kind=\"hybrid\"}"}).method.as<HybridMethod>()->given_stiffness, 1e5);
}

TEST(ForMethod, ProblemsHaveTheirLines) {
  auto text = pile;
  text.replace(text.find("viscous_damping"), 15, "viscous_dampnig");
  auto lines = problems_of({}, text);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].find("pile.toml:7: method.viscous_dampnig: unknown key"), 0U) << lines[0];
  text.replace(text.find("for.hybrid"), 10, "for.hybird");
  text.replace(text.find("viscous_dampnig"), 15, "viscous_damping");
  EXPECT_EQ(problems_of({}, text),
            (std::vector<std::string>{"pile.toml:9: for.hybird: no method; methods are soft, contact-dynamics, "
                                      "deposition, hybrid"}));
  const auto without = pile.substr(0, pile.find("[for.soft]"));
  EXPECT_EQ(problems_of({}, "for = 3\n" + without).front(),
            "pile.toml:1: for: must hold tables of keys, as in [for.soft]");
  EXPECT_EQ(problems_of({}, "for.soft = 3\n" + without).front(), "pile.toml:1: for.soft: must be a table of keys");
}

}  // namespace
}  // namespace repose
