// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hdf5_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/io/hdf5_reader.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <vector>

namespace repose {
namespace {

namespace fs = std::filesystem;

class Hdf5FileTest : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator{}));
  }

  const testing::TemporaryFolder folder_;
};

TEST_F(Hdf5FileTest, NothingExistsUntilCommit) {
  {
    Hdf5File file(path("a.h5"));
    file.dataset("x", std::vector<double>{1.0, 2.0}, 1, "L", "test");
    EXPECT_FALSE(fs::exists(path("a.h5")));
  }
  EXPECT_EQ(entries(), 0U);
  Hdf5File file(path("a.h5"));
  file.dataset("x", std::vector<double>{1.0, 2.0}, 1, "L", "test");
  file.commit();
  EXPECT_TRUE(fs::exists(path("a.h5")));
  EXPECT_EQ(entries(), 1U);
}

TEST_F(Hdf5FileTest, SaysWhyItCannotWrite) {
  try {
    Hdf5File file(path("missing/a.h5"));
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
  }
  EXPECT_THROW(write_text_file(path("missing/a.txt"), "x"), RunError);
}

TEST_F(Hdf5FileTest, TextFileIsReplacedWhole) {
  write_text_file(path("t"), "first, longer");
  write_text_file(path("t"), "second");
  std::string text;
  std::getline(std::ifstream(path("t")), text);
  EXPECT_EQ(text, "second");
  EXPECT_EQ(entries(), 1U);
}

// A dataset that comes in blocks is the one that comes at once, in compressed chunks and without.
TEST_F(Hdf5FileTest, BlocksMakeOneDataset) {
  for (const std::size_t rows : {0U, 7U, 40000U}) {
    std::vector<double> values(2 * rows);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = 0.1 * static_cast<double>(k);
    Hdf5File file(path("a.h5"));
    file.dataset("whole", values, 2, "L", "test");
    file.expect_blocks(rows);
    constexpr std::size_t most = 6000;  // not a multiple of a chunk
    std::size_t first = 0;
    do {
      const auto end = std::min(values.size(), first + most);
      file.dataset("blocks",
                   std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(first),
                                       values.begin() + static_cast<std::ptrdiff_t>(end)),
                   2, "L", "test");
      first = end;
    } while (first < values.size());
    file.dataset("after", std::vector<double>{1.0}, 1, "L", "test");
    file.commit();
    const Hdf5Reader reader(path("a.h5"));
    EXPECT_EQ(reader.dataset<double>("whole", 2), values);
    EXPECT_EQ(reader.dataset<double>("blocks", 2), values);
    EXPECT_EQ(reader.dataset<double>("after"), std::vector<double>{1.0});
    EXPECT_EQ(reader.text("blocks", "unit"), "L");
  }
}

}  // namespace
}  // namespace repose
