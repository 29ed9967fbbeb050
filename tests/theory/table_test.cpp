// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/tables/cells.hpp"
#include "repose/tables/number_table.hpp"
#include "repose/tables/text_lines.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <functional>

namespace repose {
namespace {

std::string complaint(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

struct TableTest : ::testing::Test {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("table.csv");

  void write(const std::string& text) const { std::ofstream{path, std::ios::binary} << text; }
  NumberTable read(const std::string& text, const std::vector<std::string>& needed = {"a"}) const {
    write(text);
    return {path, needed};
  }
  std::vector<std::string> lines(const std::string& text) const {
    write(text);
    TextLines file(path);
    std::vector<std::string> all;
    for (std::string line; file.next(line);) all.push_back(line);
    EXPECT_EQ(file.number(), all.size());
    file.rewind();
    std::string first;
    EXPECT_EQ(file.next(first), !all.empty());
    EXPECT_EQ(first, all.empty() ? "" : all.front());
    return all;
  }
};

using Lines = std::vector<std::string>;
using Numbers = std::vector<double>;

TEST_F(TableTest, LinesEndInAnyWay) {
  for (const auto* text : {"a\nb\n\nc", "a\r\nb\r\n\r\nc\r\n", "a\rb\r\rc\r",
                           "\xEF\xBB\xBF"
                           "a\nb\r\n\nc"}) {
    EXPECT_EQ(lines(text), (Lines{"a", "b", "", "c"})) << text;
  }
  EXPECT_EQ(lines(""), Lines{});
  // A CR at the end of one block of the file and its LF at the start of the next are one end of a line.
  const std::string block((1U << 16U) - 1, 'x');
  EXPECT_EQ(lines(block + "\r\nb\r\n"), (Lines{block, "b"}));
}

TEST_F(TableTest, LinesInUtf16) {
  std::string little = "\xFF\xFE";
  std::string big = "\xFE\xFF";
  for (const char c : std::string("x,y\n1,2\r\n")) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  const Lines expected{"x,y", "1,2"};
  EXPECT_EQ(lines(little), expected);
  EXPECT_EQ(lines(big), expected);
  EXPECT_EQ(lines(little.substr(2)), expected) << "without a byte order mark";
  // The sign for micro, and a character beyond the first plane, which takes a pair of units.
  const char units[] = "\xFF\xFE\xB5\x00m\x00\x3D\xD8\x00\xDE";
  EXPECT_EQ(lines(std::string(units, sizeof(units) - 1)), (Lines{"\u00b5m\U0001F600"}));
}

TEST_F(TableTest, LinesInLatin1) { EXPECT_EQ(lines("\xB5m\n\u00b5m \u20ac\n"), (Lines{"\u00b5m", "\u00b5m \u20ac"})); }

TEST_F(TableTest, PackedFiles) {
  std::string text;
  for (int k = 0; k < 20000; ++k) text += "line " + std::to_string(k) + "\n";
  const auto file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  TextLines all(path);
  std::string line;
  std::size_t count = 0;
  while (all.next(line)) EXPECT_EQ(line, "line " + std::to_string(count++));
  EXPECT_EQ(count, 20000U);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_EQ(complaint([&] {
              TextLines cut(path);
              while (cut.next(line)) continue;
            }),
            path + ": is packed by gzip, and its end is missing");
}

TEST_F(TableTest, OtherFilesAreNamed) {
  const auto refused = [&](const std::string& text) {
    write(text);
    return complaint([&] { TextLines{path}; }).substr(path.size() + 2);
  };
  EXPECT_EQ(refused("PK\x03\x04 and more"), "is a zip archive or a spreadsheet; unpack it, or save it as CSV");
  EXPECT_EQ(refused("BZh91AY"), "is packed by bzip2; unpack it, or pack it by gzip");
  EXPECT_TRUE(refused("\x89HDF\r\n\x1a\n").starts_with("is an HDF5 file"));
  EXPECT_TRUE(refused(std::string("x,y,radius\n\0", 12)).starts_with("is binary; must be text"));
  EXPECT_EQ(complaint([&] { TextLines{path + ".none"}; }), path + ".none: cannot be read");
  EXPECT_THROW(TextLines{std::filesystem::temp_directory_path().string()}, InputError);
}

TEST_F(TableTest, NumbersInCells) {
  EXPECT_EQ(number_of("-2.5e-3"), -2.5e-3);
  EXPECT_EQ(number_of("+3"), 3.0);
  EXPECT_EQ(number_of("1.5D+02"), 150.0);
  EXPECT_EQ(number_of("1,5d-1"), 0.15);
  EXPECT_EQ(number_of("0,1"), 0.1);
  for (const auto* text : {"", "nan", "inf", "1e999", "1,2,3", "4m", "D2", "0x1p3", "1 2"}) {
    EXPECT_FALSE(number_of(text)) << text;
  }
  EXPECT_EQ(integer_of("7"), 7);
  EXPECT_EQ(integer_of("1.0"), 1);
  EXPECT_EQ(integer_of("1.200000000000000000e+01"), 12);
  EXPECT_EQ(integer_of("9223372036854775807"), 9223372036854775807);
  for (const auto* text : {"1.5", "1e300", "9223372036854775808", "one"}) EXPECT_FALSE(integer_of(text)) << text;
  EXPECT_EQ(truth_of("True"), true);
  EXPECT_EQ(truth_of("0.0"), false);
  EXPECT_FALSE(truth_of("2"));
}

TEST_F(TableTest, NamesAndUnits) {
  const auto names = [](std::string_view line) {
    std::string all;
    for (const auto& name : column_names(line, separator_of_names(line))) all += name.name + "|" + name.unit + " ";
    return all;
  };
  EXPECT_EQ(names("x (mm), y[mm] ,\"radius (m)\",v / cm"), "x|mm y|mm radius|m v|cm ");
  EXPECT_EQ(names("x (mm) y [mm] omega (1 / s)"), "x|mm y|mm omega|1 / s ");
  EXPECT_EQ(names("x;y"), "x| y| ");
  EXPECT_EQ(plain_name("Position_X"), plain_name("position.x"));
  EXPECT_EQ(unit_of_length("mm"), 1e-3);
  EXPECT_EQ(unit_of_length("\u00b5m"), 1e-6);
  EXPECT_EQ(unit_of_mass("g"), 1e-3);
  EXPECT_EQ(unit_of_velocity("mm/s"), 1e-3);
  EXPECT_FALSE(unit_of_length("kg"));
}

TEST_F(TableTest, ColumnsOfNumbers) {
  const auto file = read(
      "\xef\xbb\xbf# a comment, with commas\r\n\r\na, \"mass, total\" ,note\r\n1,-2.5e-3,\"a, b\"\r\n"
      "  # another\r\n+3 , 4,\r\n");
  EXPECT_EQ(file.rows(), 2U);
  EXPECT_EQ(file.line(0), 4U);
  EXPECT_EQ(file.line(1), 6U);
  EXPECT_EQ(file.numbers("A"), (Numbers{1.0, 3.0}));
  EXPECT_EQ(file.numbers("mass, total"), (Numbers{-2.5e-3, 4.0}));
  EXPECT_TRUE(file.find({"none", "note"}));
  EXPECT_FALSE(file.find({"mass"}));
}

TEST_F(TableTest, AnySeparator) {
  for (const auto* text :
       {"a,b\n1,2\n3,4\n", "a;b\n1;2\n3;4\n", "a\tb\n1\t2\n3\t4\n", "  a   b\n 1  2\n3 4\n", "# a b\n1 2\n3 4\n",
        "% a, b\n1 2\n3 4\n", "a;b\n1,0;2,0\n3,0;4,0\n", "a b\n1, 2\n3, 4\n", "a,b,\n1,2,\n3,4,\n",
        "A simulation of mine\na,b\n1,2\n3,4\n", ",a,b\n0,1,2\n1,3,4\n", " a   b\n--- ---\n1 2\n3 4\n",
        "sep=;\na;b\n1;2\n3;4\n", "\"a\" \"b\"\n\"1\" 1 2\n\"2\" 3 4\n", "a,b\nm,kg\n1,2\n3,4\n"}) {
    const auto file = read(text, {"a", "b"});
    EXPECT_EQ(file.numbers("a"), (Numbers{1.0, 3.0})) << text;
    EXPECT_EQ(file.numbers("b"), (Numbers{2.0, 4.0})) << text;
  }
}

TEST_F(TableTest, ReportsWhereItIsWrong) {
  EXPECT_EQ(complaint([&] { read("a,b\n1,2\n3\n4,5,6\n"); }),
            path + ":3: has 1 value; must have 2\n" + path + ":4: has 3 values; must have 2");
  const auto file = read("a,b\n1,2\nx,3\n4m,nan\n");
  EXPECT_EQ(complaint([&] { file.numbers("a"); }),
            path + ":3: a = x: is not a finite number\n" + path + ":4: a = 4m: is not a finite number");
  EXPECT_EQ(complaint([&] { file.numbers("b"); }), path + ":4: b = nan: is not a finite number");
  EXPECT_EQ(complaint([&] { file.numbers("c"); }), path + ": has no column c; has a, b");
  EXPECT_EQ(complaint([&] { read("a,A\n1,2\n"); }), path + ":1: A: occurs twice");
  EXPECT_EQ(complaint([&] { read("# nothing\n"); }), path + ": is empty: no line with the names of the columns");
  EXPECT_EQ(complaint([&] { NumberTable(path + ".none", {}); }), path + ".none: no such file");
  const auto folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(complaint([&] { NumberTable(folder, {}); }), folder + ": is a folder");
}

TEST_F(TableTest, NamesTheFirstOfManyProblems) {
  std::string text = "a,b\n";
  for (int i = 0; i < 30; ++i) text += "x,1\n";
  const auto file = read(text);
  try {
    file.numbers("a");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 21U);
    EXPECT_EQ(error.problems().back(), path + ": and 10 more problems");
  }
}

}  // namespace
}  // namespace repose
