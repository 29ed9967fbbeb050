// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/io/stl_file.hpp"

#include "repose/boundaries/make_walls.hpp"
#include "repose/core/errors.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace repose {
namespace {

using StlTriangle = std::array<Vec<3>, 3>;

/// The twelve triangles of a cube of side 1 with its lowest corner at 0, all facing outwards.
std::vector<StlTriangle> stl_cube() {
  std::vector<StlTriangle> all;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double place : {0.0, 1.0}) {
      const auto corner = [&](double a, double b) {
        Vec<3> at;
        at[axis] = place;
        at[(axis + 1) % 3] = a;
        at[(axis + 2) % 3] = b;
        return at;
      };
      const auto p = corner(0, 0), q = corner(1, 0), r = corner(1, 1), s = corner(0, 1);
      if (place > 0.0) {
        all.insert(all.end(), {{p, q, r}, {p, r, s}});
      } else {
        all.insert(all.end(), {{p, r, q}, {p, s, r}});
      }
    }
  }
  return all;
}

std::string stl_text(const std::vector<StlTriangle>& triangles) {
  std::string text = "solid a cube with facet in its name\n";
  for (const auto& triangle : triangles) {
    text += "  facet normal 0 0 7\n    outer loop\n";
    for (const auto& v : triangle) text += fmt::format("      vertex {} {:e} {}\r\n", v[0], v[1], v[2]);
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid a cube\n";
}

std::string stl_bytes(const std::vector<StlTriangle>& triangles) {
  std::string bytes = "solid: many binary files begin like a text";
  bytes.resize(80, ' ');
  const auto add = [&](std::uint32_t word, int count) {
    for (int k = 0; k < count; ++k) bytes.push_back(static_cast<char>(word >> (8 * k) & 255U));
  };
  add(static_cast<std::uint32_t>(triangles.size()), 4);
  for (const auto& triangle : triangles) {
    for (int k = 0; k < 3; ++k) add(0, 4);
    for (const auto& v : triangle) {
      for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint32_t>(static_cast<float>(v[k])), 4);
    }
    add(0, 2);
  }
  return bytes;
}

class StlFile : public ::testing::Test {
 protected:
  std::string path_ =
      (std::filesystem::temp_directory_path() /
       (std::string("repose_stl_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".stl"))
          .string();
  ~StlFile() override { std::filesystem::remove(path_); }

  Surface read(const std::string& bytes, const StlOptions& options = {}) const {
    std::ofstream(path_, std::ios::binary) << bytes;
    return read_stl(path_, options);
  }
  /// The message that refuses a file, without the path before it.
  std::string refused(const std::string& bytes) const {
    try {
      read(bytes);
    } catch (const InputError& error) {
      const auto& first = error.problems().front();
      EXPECT_EQ(first.substr(0, path_.size()), path_);
      return first.substr(path_.size());
    }
    return "not refused";
  }
};

/// Six times the volume that facets enclose, if they all face outwards.
double six_volumes(const Surface& surface) {
  double sum = 0.0;
  for (const auto& facet : surface.facets) {
    const auto& v = surface.vertices;
    sum += dot(v[facet[0]], cross(v[facet[1]], v[facet[2]]));
  }
  return sum;
}

TEST_F(StlFile, TextAndBinary) {
  for (const auto& bytes : {stl_text(stl_cube()), stl_bytes(stl_cube())}) {
    const auto surface = read(bytes);
    EXPECT_EQ(surface.facets.size(), 12u);
    EXPECT_EQ(surface.vertices.size(), 8u);  // each shared by four to six facets
    EXPECT_EQ(six_volumes(surface), 6.0);    // whole numbers: exact
    const auto walls = surface_walls(surface.vertices, surface.facets);
    Vec<3> sum{};
    double total = 0.0;
    for (const auto& wall : walls) {
      sum += wall.normal * area(wall);
      total += area(wall);
      // The normal is that of the vertices, not that of the file, and points away from the middle of the cube.
      EXPECT_GT(dot(wall.normal, Vec<3>(wall.point - Vec<3>{{0.5, 0.5, 0.5}})), 0.49);
    }
    EXPECT_NEAR(total, 6.0, 1e-14);
    EXPECT_NEAR(magnitude(sum), 0.0, 1e-14);  // a closed surface
  }
}

TEST_F(StlFile, SeveralSolidsInOneText) {
  const auto both = read(stl_text(stl_cube()) + stl_text({{{{{5, 0, 0}}, {{6, 0, 0}}, {{5, 1, 0}}}}}));
  EXPECT_EQ(both.facets.size(), 13u);
  EXPECT_EQ(both.vertices.size(), 11u);
}

TEST_F(StlFile, ScaleAndShift) {
  const auto surface = read(stl_text(stl_cube()), {.scale = 0.5, .shift = {{10.0, 20.0, -30.0}}});
  EXPECT_EQ(six_volumes(surface), 6.0 * 0.125);
  Vec<3> low = surface.vertices[0], high = low;
  for (const auto& v : surface.vertices) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v[k]);
      high[k] = std::max(high[k], v[k]);
    }
  }
  EXPECT_EQ(low, (Vec<3>{{10.0, 20.0, -30.0}}));
  EXPECT_EQ(high, (Vec<3>{{10.5, 20.5, -29.5}}));
}

// Vertices that differ by less than 1e-9 of the size are one, also across the border of a cell of the search; those
// that differ by more are two.
TEST_F(StlFile, VerticesOfOnePlace) {
  for (const double apart : {0.5e-9, 3e-9}) {
    std::vector<StlTriangle> strip;
    for (int k = 0; k < 50; ++k) {
      const double x = 0.02 * k;
      const double off = k % 2 == 0 ? apart : -apart;
      // The corner at x is that of the triangle before, moved by `off` along x.
      strip.push_back(
          {Vec<3>{{x + (k > 0 ? off : 0.0), 0.0, 0.0}}, Vec<3>{{x + 0.02, 0.0, 0.0}}, Vec<3>{{x + 0.01, 1.0, 0.0}}});
    }
    const auto surface = read(stl_text(strip));
    EXPECT_EQ(surface.facets.size(), 50u);
    EXPECT_EQ(surface.vertices.size(), apart < 1e-9 ? 101u : 150u);
  }
}

TEST_F(StlFile, FacetsWithoutArea) {
  auto triangles = stl_cube();
  triangles[4][2] = triangles[4][0];  // two corners in one place
  EXPECT_EQ(refused(stl_bytes(triangles)), ": facet 5: is no triangle: its vertices lie on a line or in one place");
  triangles = stl_cube();
  triangles[7] = {Vec<3>{{0, 0, 0}}, Vec<3>{{0.3, 0.3, 0.3}}, Vec<3>{{1, 1, 1 + 0.5e-9}}};
  EXPECT_EQ(refused(stl_text(triangles)), ": facet 8: is no triangle: its vertices lie on a line or in one place");
  triangles[7][2][2] = 1.0 + 1e-8;  // thin, but a triangle
  EXPECT_EQ(read(stl_text(triangles)).facets.size(), 12u);
}

TEST_F(StlFile, BadFiles) {
  const std::string no_stl =
      ": is no STL file, or not a whole one: text begins with \"solid\", and a binary file has 84 bytes and 50 for "
      "each "
      "facet";
  EXPECT_EQ(refused(""), no_stl);
  EXPECT_EQ(refused("ply\n"), no_stl);
  EXPECT_EQ(refused(stl_bytes(stl_cube()).substr(0, 300)), no_stl);
  EXPECT_EQ(refused("solid\nface\n"), ":2: must be \"facet\" or \"endsolid\", not \"face\"");
  EXPECT_EQ(refused("solid empty\nendsolid\n"), ": has no facets");
  EXPECT_EQ(refused(stl_bytes({})), ": has no facets");
  auto text = stl_text(stl_cube());
  const auto at = text.find("vertex 0 ");
  EXPECT_EQ(refused(text.substr(0, at) + "vertex x " + text.substr(at + 9)), ":4: \"x\" must be a finite number");
  const auto loop = text.find("loop\n", text.find("loop\n", at) + 20);  // that of the second facet, on line 10
  EXPECT_EQ(refused(text.substr(0, loop + 4)), ":10: must be \"vertex\", not \"\"");
  auto triangles = stl_cube();
  triangles[2][1][0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused(stl_bytes(triangles)), ": facet 3: a vertex must have finite coordinates");
  EXPECT_EQ(refused(stl_bytes({{{{{1, 1, 1}}, {{1, 1, 1}}, {{1, 1, 1}}}}})), ": all vertices lie in one place");
  std::string many = stl_bytes({});
  many[80] = static_cast<char>(0xa1);  // 100 001
  many[81] = static_cast<char>(0x86);
  many[82] = 1;
  many.resize(84 + 50 * 100001);
  EXPECT_EQ(refused(many), ": has 100001 facets: surfaces may have 100000");
  EXPECT_THROW(read_stl(path_ + ".none"), InputError);
  EXPECT_THROW(read_stl(std::filesystem::temp_directory_path().string()), InputError);
}

}  // namespace
}  // namespace repose
