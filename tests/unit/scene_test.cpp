// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/scene/bases/row.hpp"
#include "repose/scene/methods/soft.hpp"
#include "repose/scene/read.hpp"
#include "repose/scene/sources/drop.hpp"
#include "repose/scene/write.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

namespace repose {
namespace {

const std::string heap_text = R"(title = "a \"heap\""
[method]
time_step = "auto"
[contact]
friction = 0.4
normal = { law = "continuous", exponent = 36, cutoff = 1.2 }
[base]
kind = "row"
spacing = 1.1
half_width = 30
[[plane]]
point = [-30.0, 0.0]
normal = [1.0, 0.0]
[[grain]]
position = [0.0, 1.0]
diameter = 0.9
[source]
kind = "pour"
count = 10
rate = 0.62
[stop]
time = 50
)";

std::vector<std::string> problems_of(const std::string& text, const Overrides& overrides = {}) {
  try {
    scene_from_text(text, "scene.toml", overrides);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

bool any_contains(const std::vector<std::string>& lines, const std::string& part) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const auto& line) { return line.find(part) != std::string::npos; });
}

TEST(SceneRead, ValuesAndDefaults) {
  const auto scene = scene_from_text(heap_text, "scene.toml");
  EXPECT_EQ(scene.title, "a \"heap\"");
  EXPECT_FALSE(scene.method.as<SoftMethod>()->step);
  EXPECT_EQ(std::get<Cumulative>(scene.contact.tangential).friction, 0.4);
  EXPECT_EQ(std::get<Continuous>(scene.contact.normal).whole_exponent, 37U);
  EXPECT_EQ(scene.base.as<RowBase>()->spacing, 1.1);
  ASSERT_EQ(scene.planes.size(), 1U);
  ASSERT_EQ(scene.placed.size(), 1U);
  EXPECT_EQ(scene.placed[0].diameter, 0.9);
  EXPECT_EQ(scene.source.as<PourSource>()->height, 100.0);
  EXPECT_FALSE(scene.stop.at_rest);
  // "auto" takes half a radian of the stiffest contact, here that of the small placed grain.
  EXPECT_NEAR(scene.time_step() * scene.contact_frequency(), 0.5, 1e-12);
}

// Released above the highest grain, a grain may fall past all of the heap: the height of a triangle of 300 discs, as
// expected_column gives it, unless sides are nearer by than that.
TEST(SceneRead, FallFromAboveTheHeapIncludesTheHeap) {
  const auto fall = [](const std::string& above, const std::string& more) {
    const auto scene = scene_from_text(fmt::format("base = {{ kind = 'row', half_width = 30 }}\nstop = {{ time = 1 }}\n"
                                                   "source = {{ kind = 'pour', count = 300, rate = 1, height = 5, "
                                                   "height_above = '{}' }}\n{}",
                                                   above, more),
                                       "scene.toml");
    return 0.5 * scene.fastest_fall() * scene.fastest_fall();
  };
  const std::string pipe = "[[plane]]\npoint = [-4, 0]\nnormal = [1, 0]\n[[plane]]\npoint = [4, 0]\nnormal = [-1, 0]\n";
  EXPECT_NEAR(fall("base", ""), 5.0, 1e-12);
  EXPECT_NEAR(fall("apex", ""), 5.0 + std::sqrt(300 * 0.9 / std::sqrt(3.0)), 1e-12);
  EXPECT_NEAR(fall("apex", pipe), 5.0 + 4.0, 1e-12);
}

// The complete scene contains every key and reads back as itself.
TEST(SceneWrite, RoundTrip) {
  const std::string hooke = R"(
units = "SI"
grains = { diameter = 2e-3, mass = 1.1e-5, polydispersity = 0.1 }
contact = { normal = { law = "hooke", stiffness = 0.1 }, tangential = { law = "linear", stiffness = 0.03 } }
base = { kind = "plane", smooth = true }
source = { kind = "pour", count = 5, rate = 10, height = 0.1 }
stop = { at_rest = 1e-5 }
)";
  const std::string species = R"(
grains = { shares = "mass" }
base = { kind = "deposited", half_width = 20 }
source = { kind = "rain", count = 5, rate = 10, height_above = "apex", velocity = [0.1, -0.2] }
stop = { at_rest = 1e-5 }
[[species]]
sizes = { kind = "log-normal", mean = 0.8, deviation = 0.1 }
[[species]]
name = "sieved"
sizes = { kind = "sieve", diameters = [0.5, 0.7, 1.0], passing = [0.0, 0.4, 1.0] }
)";
  const std::string block = R"(
source = { kind = "lattice", rows = 3, columns = 4, gap = 0.1, jitter = 0.5 }
stop = { at_rest = 1e-5 }
[[species]]
sizes = { kind = "table", diameters = [0.5, 1.0], weights = [2, 1] }
)";
  for (const auto& text : {heap_text, hooke, species, block}) {
    const auto scene = scene_from_text(text, "scene.toml");
    const auto complete = scene_text(scene);
    const auto again = scene_text(scene_from_text(complete, "complete.toml"));
    EXPECT_EQ(complete, again);
    EXPECT_NE(complete.find("skin = "), std::string::npos);
  }
}

TEST(SceneRead, AllProblemsAtOnceWithFileLineAndKey) {
  const auto lines = problems_of(R"(
gravity = -1
[contact]
frictoin = 0.4
normal = { law = "continuous", cutoff = 0.9 }
[base]
kind = "row"
half_width = "wide"
[source]
kind = "pour"
count = 0
[stop]
time = 1
)");
  EXPECT_TRUE(any_contains(lines, "scene.toml:2: gravity = -1: must be >= 0"));
  EXPECT_TRUE(any_contains(
      lines,
      "scene.toml:4: contact.frictoin: unknown key; known here: cohesion, friction, normal, rolling, tangential"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:5: contact.normal.cutoff = 0.9: must be >= 1"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:8: base.half_width = \"wide\": must be a number, is text"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:11: source.count = 0: must be a whole number from 1"));
  EXPECT_TRUE(any_contains(lines, "source.rate: missing"));
}

TEST(SceneRead, Overrides) {
  Overrides overrides;
  overrides.set = {"contact.friction=0.1", "title=plain words", "contact.normal.law=hooke",
                   "contact.normal.exponent = 12"};
  overrides.seed = 9;
  const auto lines = problems_of(heap_text, overrides);
  ASSERT_EQ(lines.size(), 2U);  // keys of the other law: the exponent from the command line, the cutoff from the file
  EXPECT_TRUE(any_contains(lines, "--set contact.normal.exponent = 12: contact.normal.exponent: unknown key"));
  EXPECT_TRUE(any_contains(lines, "scene.toml:6: contact.normal.cutoff: unknown key"));
  overrides.set.resize(2);
  const auto scene = scene_from_text(heap_text, "scene.toml", overrides);
  EXPECT_EQ(scene.contact.friction, 0.1);
  EXPECT_EQ(scene.title, "plain words");
  EXPECT_EQ(scene.seed, 9);
}

TEST(SceneRead, UnstableStepIsRefusedWithTheLargestThatIsNot) {
  const auto step = [](const std::string& value) {
    Overrides overrides;
    overrides.set = {"method.time_step=" + value, "contact.normal.exponent=144"};
    return problems_of(heap_text, overrides);
  };
  const auto lines = step("0.001");
  ASSERT_EQ(lines.size(), 1U);
  const std::string mark = "not refused is ";
  const auto begin = lines[0].find(mark) + mark.size();
  const double largest = std::stod(lines[0].substr(begin));
  EXPECT_TRUE(step(std::to_string(0.99 * largest)).empty());
  EXPECT_FALSE(step(std::to_string(1.01 * largest)).empty());
}

// Inputs found by the fuzzer (tests/fuzz) and by reading the code. Each caused a crash or was accepted silently.
const std::string one_grain = "[[grain]]\nposition = [0.0, 1.0]\n[stop]\ntime = 1\n";

// A quoted name with dots or brackets is never a known key. It must not be ignored silently or taken for an entry of a
// list.
TEST(SceneRead, QuotedNamesThatLookLikePathsAreUnknown) {
  for (const std::string name : {"", "contact.friction", "grain[0].spin", "a[x", "a[99999999999999999999"}) {
    const auto line = "\"" + name + "\" = 0.9\n";
    auto lines = problems_of("a = []\n" + line + one_grain);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_TRUE(any_contains(lines, "scene.toml:2: \"" + name + "\": unknown key; keys are words")) << lines[0];
    lines = problems_of("[contact]\n" + line + one_grain);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(any_contains(lines, "scene.toml:2: contact.\"" + name + "\": unknown key")) << lines[0];
  }
  Overrides overrides;
  overrides.set = {"contact={\"\" = 1}"};
  EXPECT_TRUE(any_contains(problems_of(one_grain, overrides), "--set contact={\"\" = 1}: contact.\"\": unknown key"));
}

// A quotation mark before the closing three belongs to the text. The rest is parsed normally.
TEST(SceneRead, LongTextWithQuotationMarksAtItsEnd) {
  EXPECT_EQ(scene_from_text("title = \"\"\"a\"\"\"\"\"  # \"\n" + one_grain, "scene.toml").title, "a\"\"");
  EXPECT_EQ(scene_from_text("title = '''été''''\n" + one_grain, "scene.toml").title, "été'");
  EXPECT_TRUE(any_contains(problems_of("title = '''a''''\nété = 1\n" + one_grain), "scene.toml:2: letters beyond"));
  EXPECT_TRUE(any_contains(problems_of("title = \"\"\"\\\n\"\"\"\nété = 1\n"), "scene.toml:3: letters beyond"));
}

// toml++ has undefined behaviour for most letters at places where it expects white space, which only sanitizers show.
TEST(SceneRead, LettersWhereTomlLooksForWhiteSpace) {
  EXPECT_EQ(scene_from_text("title = \"\"\"\\\n  été\"\"\"\n" + one_grain, "scene.toml").title, "été");
  EXPECT_EQ(problems_of("title = \"\"\"\\é\"\"\"\n" + one_grain).size(), 1U);
  EXPECT_EQ(problems_of("seed = 1e\"é\"\n" + one_grain).size(), 1U);
}

// toml++ breaks long lists over several lines.
TEST(SceneRead, ListsAndTablesInMessagesAreOneLine) {
  const auto of_gravity = [](const std::string& value) { return problems_of("gravity = " + value + "\n" + one_grain); };
  EXPECT_EQ(of_gravity("[0.01, [], -1e-300, {}, \"a\"]"),
            std::vector<std::string>{
                "scene.toml:1: gravity = [ 0.01, [], -1e-300, {}, \"a\" ]: must be a number, is a list"});
  EXPECT_EQ(
      of_gravity("{ a = nan, b = 2026-01-01 }"),
      std::vector<std::string>{"scene.toml:1: gravity = { a = nan, b = 2026-01-01 }: must be a number, is a table"});
}

TEST(SceneRead, KeysOfVeryManySteps) {
  std::string key = "a";
  for (int k = 0; k < 100000; ++k) key += ".a";
  for (const auto& text : {key + " = 1\n", "\n[" + key + "]\n"}) {
    const auto lines = problems_of(text);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(any_contains(lines, ": a key of more than 30 steps"));
  }
  Overrides overrides;
  overrides.set = {key + "=1"};
  EXPECT_EQ(problems_of(one_grain, overrides).size(), 1U);
  // Dots elsewhere are allowed.
  EXPECT_TRUE(problems_of("title = \"" + key.substr(0, 59999) + "\"  # " + key + "\n" + one_grain).empty());
}

// The time is proportional to the length of the file: eight times the grains take eight times as long, while comparing
// every key with every other takes 64 times as long. The bound lies three times off both.
TEST(SceneRead, TimeIsProportionalToTheGrainsPlaced) {
  const auto seconds = [](int grains) {
    std::string text = "[stop]\ntime = 1\n";
    for (int k = 0; k < grains; ++k) text += "[[grain]]\nposition = [0.0, " + std::to_string(k) + ".5]\n";
    const auto begin = std::clock();
    EXPECT_EQ(scene_from_text(text, "scene.toml").placed.size(), static_cast<std::size_t>(grains));
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  const auto few = std::min(seconds(2500), seconds(2500));
  EXPECT_LT(seconds(20000), 24 * few);
}

// toml++ gives no double for a whole number that a double cannot represent exactly.
TEST(SceneRead, WholeNumbersBeyondTheDoubles) {
  Overrides overrides;
  overrides.set = {"gravity=9223372036854775807", "method.skin=9007199254740993"};
  const auto scene = scene_from_text(one_grain, "scene.toml", overrides);
  EXPECT_EQ(scene.gravity, 0x1p63);
  EXPECT_EQ(scene.method.as<SoftMethod>()->skin, 0x1p53);
  overrides.set = {"stop.time=9223372036854775807"};
  EXPECT_EQ(scene_from_text(one_grain, "scene.toml", overrides).stop.time, 0x1p63);
  const auto far = scene_from_text("[[grain]]\nposition = [0, 9223372036854775807]\n[stop]\ntime = 1\n", "scene.toml");
  EXPECT_EQ(far.placed[0].position[1], 0x1p63);
}

// An exponent below 0 is one problem, and no unsigned whole exponent is computed from it.
TEST(SceneRead, ExponentBelowZeroIsOneProblem) {
  for (const std::string value : {"-5", "-inf"}) {
    Overrides overrides;
    overrides.set = {"contact.normal.exponent=" + value};
    EXPECT_EQ(problems_of(one_grain, overrides).size(), 1U) << value;
  }
}

// Defaults that follow from other keys are checked like given values, so that none is written as inf.
TEST(SceneRead, DefaultsThatOverflow) {
  const auto overflow = [](const std::vector<std::string>& settings, const std::string& part) {
    Overrides overrides;
    overrides.set = settings;
    const auto lines = problems_of(one_grain, overrides);
    EXPECT_TRUE(any_contains(lines, part)) << part;
    overrides.set.push_back(part.substr(0, part.find(':')) + "=1");
    EXPECT_LT(problems_of(one_grain, overrides).size(), lines.size()) << part;
  };
  overflow({"grains.diameter=1e306"}, "box.half_width: missing, and its default is inf: must be a finite");
  overflow({"grains.diameter=5e-324"}, "method.skin: missing, and its default is 0: must be > 0 [L]");
  overflow({"grains.diameter=1e100", "gravity=1e-308"}, "output.series: missing, and its default is inf");
}

}  // namespace
}  // namespace repose
