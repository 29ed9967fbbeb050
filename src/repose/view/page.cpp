// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/page.hpp"

#include "repose/core/errors.hpp"

// The file lies in the program as it is: a text of this length is more than compilers take as a literal.
asm(".pushsection .rodata, \"a\"\n"
    ".global repose_view_page\n"
    "repose_view_page: .incbin \"" REPOSE_VIEW_PAGE
    "\"\n"
    ".global repose_view_page_end\n"
    "repose_view_page_end: .byte 0\n"
    ".popsection\n");
extern "C" {
extern const char repose_view_page[];
extern const char repose_view_page_end[];
}

namespace repose {

namespace {

constexpr std::string_view place = "<!-- repose-data -->";

/// No text ends the element that it lies in.
std::string inside_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string_view view_page() {
  return {repose_view_page, static_cast<std::size_t>(repose_view_page_end - repose_view_page)};
}

std::string page_with(const std::string& data) {
  const auto page = view_page();
  const auto found = page.find(place);
  if (found == std::string_view::npos) throw RunError("the page has no place for data");
  std::string all(page.substr(0, found));
  all += "<script type=\"text/plain\" id=\"repose-data\">" + inside_script(data) + "</script>";
  all += page.substr(found + place.size());
  return all;
}

}  // namespace repose
