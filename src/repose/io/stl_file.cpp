// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/stl_file.hpp"

#include "repose/core/errors.hpp"
#include "repose/tables/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

namespace repose {

namespace {

namespace fs = std::filesystem;

constexpr double same_vertex = 1e-9;     // of the size of the surface
constexpr std::size_t stl_header = 80;   // bytes before the number of facets of a binary file
constexpr std::size_t stl_record = 50;   // bytes of a facet: normal, three vertices, two more bytes
constexpr std::size_t most_text = 1000;  // bytes of a facet in a text file

using Corners = std::vector<Vec<3>>;  // three for each facet

[[noreturn]] void refuse_stl(const std::string& path, const std::string& what) {
  throw InputError(fmt::format("{}: {}", path, what));
}

std::string bytes_of(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) refuse_stl(path, "no such file");
  if (!fs::is_regular_file(path, error)) refuse_stl(path, "is not a regular file");
  const auto size = fs::file_size(path, error);
  if (error) refuse_stl(path, "cannot be read: " + error.message());
  if (size > most_text * most_stl_facets) {
    refuse_stl(path, fmt::format("is too large: surfaces may have {} facets", most_stl_facets));
  }
  std::ifstream file(path, std::ios::binary);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (!file || !file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) refuse_stl(path, "cannot be read");
  return bytes;
}

std::uint32_t whole_at(const std::string& bytes, std::size_t place) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[place + k]);
  return value;
}

bool is_binary(const std::string& bytes) {
  return bytes.size() >= stl_header + 4 &&
         bytes.size() == stl_header + 4 + stl_record * std::size_t{whole_at(bytes, stl_header)};
}

void check_count(const std::string& path, std::size_t facets) {
  if (facets == 0) refuse_stl(path, "has no facets");
  if (facets > most_stl_facets) {
    refuse_stl(path, fmt::format("has {} facets: surfaces may have {}", facets, most_stl_facets));
  }
}

Corners read_binary(const std::string& path, const std::string& bytes) {
  const std::size_t facets = whole_at(bytes, stl_header);
  check_count(path, facets);
  Corners corners;
  corners.reserve(3 * facets);
  for (std::size_t f = 0; f < facets; ++f) {
    const auto vertices = stl_header + 4 + stl_record * f + 12;  // after the normal
    for (std::size_t v = 0; v < 3; ++v) {
      Vec<3> corner;
      for (int k = 0; k < 3; ++k) {
        const auto place = vertices + 12 * v + 4 * static_cast<std::size_t>(k);
        corner[k] = static_cast<double>(std::bit_cast<float>(whole_at(bytes, place)));
      }
      corners.push_back(corner);
    }
  }
  return corners;
}

/// The words of a text file, with the line of each.
class Words {
 public:
  Words(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  /// The next word; "" at the end.
  std::string_view next() {
    skip_blanks();
    const auto begin = place_;
    while (place_ < text_.size() && !blank(text_[place_])) ++place_;
    return text_.substr(begin, place_ - begin);
  }
  void skip_line() {
    while (place_ < text_.size() && text_[place_] != '\n') ++place_;
  }
  void expect(std::string_view wanted) {
    const auto word = next();
    if (!same(word, wanted)) stop(fmt::format("must be \"{}\", not \"{}\"", wanted, shown(word)));
  }
  double number() {
    const auto word = next();
    const auto value = number_of(word);
    if (!value) stop(fmt::format("\"{}\" must be a finite number", shown(word)));
    return *value;
  }
  [[noreturn]] void stop(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", path_, line_, what));
  }

  /// Whether a word is another in any case.
  static bool same(std::string_view word, std::string_view lower) {
    return std::equal(word.begin(), word.end(), lower.begin(), lower.end(), [](char a, char b) {
      return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
  }

 private:
  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  void skip_blanks() {
    while (place_ < text_.size() && blank(text_[place_])) {
      if (text_[place_++] == '\n') ++line_;
    }
  }

  const std::string& path_;
  std::string_view text_;
  std::size_t place_ = 0;
  std::size_t line_ = 1;
};

Corners read_text(const std::string& path, const std::string& bytes) {
  Words words(path, bytes);
  Corners corners;
  words.expect("solid");
  words.skip_line();  // its name
  while (true) {
    const auto word = words.next();
    if (word.empty()) break;
    if (Words::same(word, "solid") || Words::same(word, "endsolid")) {
      words.skip_line();
      continue;
    }
    if (!Words::same(word, "facet"))
      words.stop(fmt::format("must be \"facet\" or \"endsolid\", not \"{}\"", shown(word)));
    words.skip_line();  // its normal
    words.expect("outer");
    words.expect("loop");
    for (int v = 0; v < 3; ++v) {
      words.expect("vertex");
      Vec<3> corner;
      for (int k = 0; k < 3; ++k) corner[k] = words.number();
      corners.push_back(corner);
    }
    words.expect("endloop");
    words.expect("endfacet");
  }
  check_count(path, corners.size() / 3);
  return corners;
}

/// The largest side of the box around all corners [L].
double size_of(const Corners& corners) {
  double size = 0.0;
  for (int k = 0; k < 3; ++k) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto& corner : corners) {
      low = std::min(low, corner[k]);
      high = std::max(high, corner[k]);
    }
    size = std::max(size, high - low);
  }
  return size;
}

/// Gives each place a number, the same to places closer than a distance.
class Vertices {
 public:
  /// `same` [L] is that distance. Cells are much larger, so that few places are near the border of one.
  explicit Vertices(double same) : same_(same), cell_(1e3 * same) {}

  std::uint32_t number(const Vec<3>& place) {
    std::array<std::int64_t, 3> low{};
    std::array<std::int64_t, 3> high{};
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = cell_of(place[static_cast<int>(k)] - same_);
      high[k] = cell_of(place[static_cast<int>(k)] + same_);
    }
    for (auto x = low[0]; x <= high[0]; ++x) {
      for (auto y = low[1]; y <= high[1]; ++y) {
        for (auto z = low[2]; z <= high[2]; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const auto known : found->second) {
            if (magnitude(Vec<3>(places[known] - place)) <= same_) return known;
          }
        }
      }
    }
    const auto number = static_cast<std::uint32_t>(places.size());
    cells_[{cell_of(place[0]), cell_of(place[1]), cell_of(place[2])}].push_back(number);
    places.push_back(place);
    return number;
  }

  std::vector<Vec<3>> places;

 private:
  std::int64_t cell_of(double place) const { return static_cast<std::int64_t>(std::floor(place / cell_)); }

  double same_;
  double cell_;
  std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells_;
};

/// The height [L] of a triangle over its longest side.
double least_height(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double longest = std::max({magnitude(Vec<3>(b - a)), magnitude(Vec<3>(c - b)), magnitude(Vec<3>(a - c))});
  return longest > 0.0 ? magnitude(cross(Vec<3>(b - a), Vec<3>(c - a))) / longest : 0.0;
}

/// The problems of facets: the first 20 by line, then the number of the rest.
class FacetProblems {
 public:
  void add(const std::string& path, std::size_t facet, std::string_view what) {
    constexpr std::size_t most = 20;
    if (++count_ <= most) lines_.push_back(fmt::format("{}: facet {}: {}", path, facet + 1, what));
  }
  void check(const std::string& path) {
    if (count_ == 0) return;
    if (count_ > lines_.size()) lines_.push_back(fmt::format("{}: and {} more facets", path, count_ - lines_.size()));
    throw InputError(lines_);
  }

 private:
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

}  // namespace

Surface read_stl(const std::string& path, const StlOptions& options) {
  const auto bytes = bytes_of(path);
  const bool text = !is_binary(bytes);
  const auto begin = bytes.find_first_not_of(" \t\r\n");
  if (text && (begin == std::string::npos || bytes.find('\0') != std::string::npos ||
               !Words::same(std::string_view(bytes).substr(begin, 5), "solid"))) {
    refuse_stl(path,
               "is no STL file, or not a whole one: text begins with \"solid\", and a binary file has 84 bytes and 50 "
               "for each facet");
  }
  auto corners = text ? read_text(path, bytes) : read_binary(path, bytes);
  constexpr double most = 1e15;
  FacetProblems problems;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = corners[k] * options.scale + options.shift;
    const auto& place = corners[k];
    const bool finite = std::fabs(place[0]) < most && std::fabs(place[1]) < most && std::fabs(place[2]) < most;
    if (!finite) problems.add(path, k / 3, "a vertex must have finite coordinates");
  }
  problems.check(path);
  const double same = same_vertex * size_of(corners);
  if (!(same > 0.0)) refuse_stl(path, "all vertices lie in one place");
  Vertices vertices(same);
  Surface surface;
  for (std::size_t f = 0; f < corners.size() / 3; ++f) {
    auto& facet = surface.facets.emplace_back();
    for (std::size_t v = 0; v < 3; ++v) facet[v] = vertices.number(corners[3 * f + v]);
    const auto& places = vertices.places;
    if (least_height(places[facet[0]], places[facet[1]], places[facet[2]]) <= same) {
      problems.add(path, f, "is no triangle: its vertices lie on a line or in one place");
    }
  }
  problems.check(path);
  surface.vertices = std::move(vertices.places);
  return surface;
}

}  // namespace repose
