// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/hash.hpp"
#include "repose/io/hdf5_archive.hpp"
#include "repose/io/seal.hpp"
#include "repose/methods/soft/soft.hpp"
#include "support/soft_world.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>

// A changed file is refused; stored state is restored to the bit.

namespace repose {
namespace {

using testing::settings_2d;

class CheckpointTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }

  const testing::TemporaryFolder folder_;
};

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void set_content(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

// The hash of an empty input equals that of the reference program (xxhsum 0.8.1 -H2).
TEST_F(CheckpointTest, HashOfNothing) {
  EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_NE(hash_of("a"), hash_of("b"));
  Hash pieces;
  pieces.add("hea", 3);
  pieces.add("p", 1);
  EXPECT_EQ(pieces.text(), hash_of("heap"));
}

TEST_F(CheckpointTest, EveryChangedByteAndEveryCutShows) {
  {
    Hdf5File file(path("a.h5"));
    file.dataset("x", std::vector<double>(500, 1.25), 1, "L", "test");
    file.commit();
  }
  ASSERT_EQ(broken_seal(path("a.h5")), "");
  const auto content = content_of(path("a.h5"));
  for (std::size_t place = 0; place < content.size(); place += 37) {
    auto changed = content;
    changed[place] = static_cast<char>(changed[place] ^ 0x40);
    set_content(path("b.h5"), changed);
    EXPECT_NE(broken_seal(path("b.h5")), "") << "byte " << place;
    EXPECT_THROW(Hdf5Reader{path("b.h5")}, InputError);
    set_content(path("b.h5"), content.substr(0, place));
    EXPECT_NE(broken_seal(path("b.h5")), "") << "cut at " << place;
  }
  set_content(path("b.h5"), content + "x");
  EXPECT_NE(broken_seal(path("b.h5")), "");
}

template <class Kept>
void keep(const std::string& path, Kept& kept) {
  Hdf5File file(path);
  ArchiveWriter archive(file, "state");
  kept.exchange(archive);
  file.commit();
}
template <class Kept>
void bring_back(const std::string& path, Kept& kept) {
  const Hdf5Reader file(path);
  ArchiveReader archive(file, "state");
  kept.exchange(archive);
}

using Law = PairLaw<Hooke, Cumulative>;

/// Grains in a box with a moving lid.
struct Crowd {
  Crowd() : method(make_kernel<2>(laws, settings())), team(2) {
    for (int k = 0; k < 40; ++k) {
      Grain<2> grain;
      grain.position = {{1.1 * (k % 8) - 3.85 + 0.03 * (k % 3), 0.7 + 1.1 * (k / 8)}};
      grain.radius = 0.4 + 0.02 * (k % 5);
      grain.mass = 4 * grain.radius * grain.radius;
      grain.inverse_mass = 1.0 / grain.mass;
      grains.add(grain, k);
    }
    method->grains_added(grains);
  }
  static SoftSettings<2> settings() {
    auto made = settings_2d(1e-3, 1.0);
    made.walls = {Wall<2>{.point = {}, .normal = {{0.0, 1.0}}},
                  Wall<2>{.point = {{0.0, 8.0}}, .normal = {{0.0, -1.0}}}};
    made.walls[1].motion = {
        .kind = WallMotion<2>::Kind::force, .direction = {{0.0, -1.0}}, .force = 40.0, .mass = 30.0};
    return made;
  }
  void exchange(Archive& archive) {
    grains.exchange(archive);
    method->exchange(archive);
    if (archive.restoring()) method->restored(grains, team);
  }
  const PairList<2>& pairs() const { return dynamic_cast<const Soft<2, Law>&>(*method).pairs(); }
  MaterialTable<Law> laws{Law{Hooke{2e4, 0.3}, Cumulative{}}};
  std::unique_ptr<Method<2>> method;
  Team team;
  Grains<2> grains;
};

TEST_F(CheckpointTest, SoftContinuesToTheBit) {
  Crowd whole;
  whole.method->advance(whole.grains, 4.0, whole.team);
  for (const int steps : {0, 1, 777, 2500}) {
    Crowd first;
    first.method->advance(first.grains, 1e-3 * steps, first.team);
    keep(path("kept.h5"), first);
    Crowd second;
    bring_back(path("kept.h5"), second);
    second.method->advance(second.grains, 4.0, second.team);
    ASSERT_EQ(second.grains.id, whole.grains.id) << "memory order after " << steps;
    for (std::size_t k = 0; k < whole.grains.size(); ++k) {
      EXPECT_EQ(second.grains.line[k].position, whole.grains.line[k].position);
      EXPECT_EQ(second.grains.line[k].rim_velocity, whole.grains.line[k].rim_velocity);
    }
    EXPECT_EQ(second.pairs().slip, whole.pairs().slip);
    EXPECT_EQ(second.method->walls()[1].displacement, whole.method->walls()[1].displacement);
    EXPECT_EQ(second.pairs().builds(), whole.pairs().builds());
  }
}

TEST_F(CheckpointTest, StateOfAnotherShapeIsRefused) {
  Crowd crowd;
  keep(path("kept.h5"), crowd);
  struct Other {
    void exchange(Archive& archive) { archive.value("step", pair); }
    std::array<double, 2> pair{};
  } other;
  EXPECT_THROW(bring_back(path("kept.h5"), other), InputError);
  struct Missing {
    void exchange(Archive& archive) { archive.value("nowhere", x); }
    double x = 0.0;
  } missing;
  EXPECT_THROW(bring_back(path("kept.h5"), missing), InputError);
}

/// An object with one array of any type, stored under one name.
template <class T>
struct Kept {
  void exchange(Archive& archive) { archive.array("values", values); }
  std::vector<T> values;
};

// Twice as many items of half the size have the same number of bytes, but must be refused.
TEST_F(CheckpointTest, ItemsOfAnotherSizeAreRefused) {
  Kept<Vec<2>> vectors{{{{1.0, 2.0}}, {{3.0, 4.0}}}};
  keep(path("kept.h5"), vectors);
  Kept<double> numbers;
  EXPECT_THROW(bring_back(path("kept.h5"), numbers), InputError);
  Kept<Vec<2>> again;
  bring_back(path("kept.h5"), again);
  EXPECT_EQ(again.values, vectors.values);
  Kept<Vec<2>> none;
  keep(path("none.h5"), none);
  bring_back(path("none.h5"), again);
  EXPECT_TRUE(again.values.empty());
  EXPECT_THROW(bring_back(path("none.h5"), numbers), InputError);
}

TEST_F(CheckpointTest, ArraysThatDoNotFitEachOtherAreRefused) {
  Crowd crowd;
  crowd.grains.id.pop_back();
  keep(path("kept.h5"), crowd.grains);
  Grains<2> grains;
  try {
    bring_back(path("kept.h5"), grains);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("state/grains: does not fit the rest of the state"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace repose
