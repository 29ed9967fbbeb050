// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/csv_file.hpp"

#include "repose/core/errors.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace repose::theory {
namespace {

struct CsvFileTest : testing::Test {
  std::string path = (std::filesystem::temp_directory_path() /
                      (std::string{"repose-"} + testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv"))
                         .string();

  void TearDown() override { std::filesystem::remove(path); }
  CsvFile read(const std::string& text) const {
    std::ofstream{path, std::ios::binary} << text;
    return CsvFile{path};
  }
  static std::string complaint(const std::function<void()>& act) {
    try {
      act();
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(CsvFileTest, ReadsNumbersPastComments) {
  const auto file = read(
      "\xef\xbb\xbf# a comment, with commas\r\n\r\nheight, \"mass, total\" ,note\r\n1,-2.5e-3,\"a \"\"b\"\"\"\r\n"
      "  # another\r\n+3 , 4,\r\n");
  EXPECT_EQ(file.rows(), 2u);
  EXPECT_EQ(file.line(0), 4u);
  EXPECT_EQ(file.line(1), 6u);
  EXPECT_EQ(file.numbers("height"), (std::vector<double>{1.0, 3.0}));
  EXPECT_EQ(file.numbers("mass, total"), (std::vector<double>{-2.5e-3, 4.0}));
  EXPECT_TRUE(file.has("note"));
  EXPECT_FALSE(file.has("mass"));
}

TEST_F(CsvFileTest, ReportsWhereItIsWrong) {
  EXPECT_EQ(complaint([&] { read("a,b\n1,2\n3\n4,5,6\n"); }),
            path + ":3: has 1 cell, the line of names has 2\n" + path + ":4: has 3 cells, the line of names has 2");
  const auto file = read("a,b\n1,2\nx,3\n4m,nan\n");
  EXPECT_EQ(complaint([&] { file.numbers("a"); }),
            path + ":3: a = x: is not a finite number\n" + path + ":4: a = 4m: is not a finite number");
  EXPECT_EQ(complaint([&] { file.numbers("b"); }), path + ":4: b = nan: is not a finite number");
  EXPECT_EQ(complaint([&] { file.numbers("c"); }), path + ": has no column c; has a, b");
  EXPECT_EQ(complaint([&] { read("a,a\n1,2\n"); }), path + ":1: two columns have the same name");
  EXPECT_EQ(complaint([&] { read("a,\n1,2\n"); }), path + ":1: a column has no name");
  EXPECT_EQ(complaint([&] { read("# nothing\n"); }), path + ": has no line of names");
  EXPECT_EQ(complaint([&] { CsvFile{path + ".none"}; }), path + ".none: no such file");
  const auto folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(complaint([&] { CsvFile{folder}; }), folder + ": is a folder");
}

TEST_F(CsvFileTest, NamesTheFirstOfManyProblems) {
  std::string text = "a\n";
  for (int i = 0; i < 30; ++i) text += "x\n";
  const auto file = read(text);
  try {
    file.numbers("a");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 21u);
    EXPECT_EQ(error.problems().back(), "and 10 more like these");
  }
}

}  // namespace
}  // namespace repose::theory
