// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/reference_table.hpp"

namespace repose {

namespace {

/// Markdown takes < for the start of a tag and | for the end of a cell.
std::string escaped(const std::string& cell) {
  std::string text;
  for (const char c : cell) text += c == '<' || c == '|' ? std::string{'\\', c} : std::string(1, c);
  return text;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const auto& cell : cells) line += (cell.empty() ? "" : " " + escaped(cell)) + " |";
  return line + "\n";
}

}  // namespace

std::string markdown_of(const ReferenceTable& table) {
  std::string text = "<!-- table: " + table.name + " -->\n" + line_of(table.head) + "|";
  for (std::size_t k = 0; k < table.head.size(); ++k) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) text += line_of(row);
  return text + "<!-- end -->\n";
}

std::string markdown_of(const std::vector<ReferenceTable>& tables) {
  std::string text;
  for (const auto& table : tables) text += markdown_of(table);
  return text;
}

std::string shape_text(const std::string& rows, const std::string& columns, std::string_view type) {
  auto text = "(" + rows + (columns.empty() ? "" : ", " + columns) + ")";
  if (!type.empty()) text += " " + std::string(type);
  return text;
}

}  // namespace repose
