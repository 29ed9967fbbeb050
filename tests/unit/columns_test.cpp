// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/core/errors.hpp"
#include "repose/io/groups.hpp"
#include "repose/io/reference_table.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace repose {
namespace {

/// A row with every kind of entry.
struct Row {
  double number = 0.0;
  float single = 0.0F;
  std::int64_t whole = 0;
  std::size_t count = 0;
  std::uint16_t material = 0;
  bool flag = false;
  std::string text;
  Vec<2> place{};
  Vec<3> axis{};
  std::array<double, 3> three{};
  std::int64_t first = 0;
  std::int64_t second = 0;
};

const Group<std::vector<Row>>& every_kind() {
  static const Group<std::vector<Row>> group{
      "rows",
      "N",
      {},
      {
          column("number", &Row::number, "L", "a number"),
          column("single", &Row::single, "L", ""),
          column("whole", &Row::whole, "", ""),
          column("count", &Row::count, "", ""),
          column("material", &Row::material, "", ""),
          column("flag", &Row::flag, "", ""),
          column("text", &Row::text, "", ""),
          column("place", &Row::place, "", ""),
          column("axis", &Row::axis, "", ""),
          column("three", &Row::three, "", ""),
          column<Row>(
              "pair", [](auto& row) { return std::tie(row.first, row.second); }, "", ""),
          column<Row>(
              "double", [](const Row& row) { return 2.0 * row.number; }, "L", "follows from `number`"),
      }};
  return group;
}

class ColumnsTest : public ::testing::Test {
 protected:
  std::string path() const { return folder_.path("columns.h5"); }

  const testing::TemporaryFolder folder_;
};

std::vector<Row> some_rows(std::size_t count) {
  std::vector<Row> rows;
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<double>(k + 1);
    Row row{
        x / 3.0,    static_cast<float>(x),     -static_cast<std::int64_t>(k), k, static_cast<std::uint16_t>(60000 + k),
        k % 2 == 0, "row " + std::to_string(k)};
    row.place = {{x, -x}};
    row.axis = {{x, 2.0 * x, 3.0 * x}};
    row.three = {x, 0.1 * x, 0.01 * x};
    row.first = 10 + static_cast<std::int64_t>(k);
    row.second = -1;
    rows.push_back(row);
  }
  return rows;
}

TEST_F(ColumnsTest, RowsReadBackTheSame) {
  for (const std::size_t count : {0U, 1U, 5U}) {
    const auto rows = some_rows(count);
    {
      Hdf5File file(path());
      write_group(file, every_kind(), rows);
      file.commit();
    }
    const Hdf5Reader file(path());
    std::vector<Row> found;
    read_group(file, every_kind(), found);
    ASSERT_EQ(found.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto all = [](const Row& row) {
        return std::tie(row.number, row.single, row.whole, row.count, row.material, row.flag, row.text, row.place,
                        row.axis, row.three, row.first, row.second);
      };
      EXPECT_EQ(all(found[k]), all(rows[k])) << k;
    }
    EXPECT_EQ(file.shape("rows/pair"), (std::vector<std::size_t>{count, 2}));
    EXPECT_EQ(file.shape("rows/double"), (std::vector<std::size_t>{count}));
    EXPECT_EQ(file.text("rows/number", "unit"), "L");
    EXPECT_EQ(file.text("rows/number", "meaning"), "a number");
  }
}

TEST_F(ColumnsTest, LengthsThatDifferAreRefused) {
  {
    Hdf5File file(path());
    write_group(file, every_kind(), some_rows(3));
    file.group("short");
    auto rows = some_rows(3);
    every_kind().columns[0].write(file, "short/number", rows);
    rows.pop_back();
    every_kind().columns[1].write(file, "short/single", rows);
    file.commit();
  }
  const Hdf5Reader file(path());
  const Columns<std::vector<Row>> two(every_kind().columns.begin(), every_kind().columns.begin() + 2);
  const auto refused = [&](const std::string& group, std::optional<std::size_t> wanted) {
    std::vector<Row> rows;
    try {
      read_columns(file, group, two, rows, wanted);
      return std::string();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refused("rows", std::nullopt), "");
  EXPECT_EQ(refused("rows", 3), "");
  EXPECT_EQ(refused("rows", 4), path() + ": rows: the datasets differ in length");
  EXPECT_EQ(refused("short", std::nullopt), path() + ": short: the datasets differ in length");
  EXPECT_NE(refused("missing", std::nullopt).find("missing/number: no such dataset"), std::string::npos);
}

/// A part of a larger object, with attributes and a list of its own.
struct Part {
  double width = 0.0;
  std::int64_t steps = 0;
  std::string message;
  std::vector<std::size_t> counts;
};
struct Whole {
  Part part;
};

TEST_F(ColumnsTest, AttributesAndListsOfAPartReadBackTheSame) {
  const Group<Part> group{"part",
                          "N",
                          {attribute("width", &Part::width, "L", ""), attribute("steps", &Part::steps, "", ""),
                           attribute("message", &Part::message, "", ""),
                           attribute<Part>(
                               "twice", [](const Part& part) { return 2 * part.steps; }, "", "")},
                          {array("counts", &Part::counts, "", "")}};
  const auto columns = columns_of<Whole>(group.columns, &Whole::part);
  const Whole whole{{0.1, 7, "stopped", {3, 1, 2}}};
  {
    Hdf5File file(path());
    write_group(file, group, whole.part);
    file.group("whole");
    write_columns(file, "whole", columns, whole);
    file.commit();
  }
  const Hdf5Reader file(path());
  Part part;
  read_group(file, group, part);
  EXPECT_EQ(part.width, 0.1);
  EXPECT_EQ(part.steps, 7);
  EXPECT_EQ(part.message, "stopped");
  EXPECT_EQ(part.counts, whole.part.counts);
  EXPECT_EQ(file.integer("part", "twice"), 14);
  Whole again;
  read_columns(file, "whole", columns, again);
  EXPECT_EQ(again.part.counts, whole.part.counts);
}

TEST_F(ColumnsTest, TheListIsTheReference) {
  const auto table = reference_of("rows", "/rows/", every_kind().rows, every_kind().columns);
  const auto text = markdown_of(table);
  EXPECT_EQ(text.substr(0, text.find("| `/rows/single`")),
            "<!-- table: rows -->\n| dataset | shape | unit | meaning |\n|---|---|---|---|\n"
            "| `/rows/number` | (N) | L | a number |\n");
  EXPECT_NE(text.find("| `/rows/pair` | (N, 2) int64 | | |\n"), std::string::npos);
  EXPECT_NE(text.find("| `/rows/flag` | (N) uint8 | | |\n"), std::string::npos);
  EXPECT_TRUE(text.ends_with("<!-- end -->\n"));
}

}  // namespace
}  // namespace repose
