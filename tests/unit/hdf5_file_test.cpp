// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/hdf5_file.hpp"

#include "repose/core/errors.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

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

}  // namespace
}  // namespace repose
