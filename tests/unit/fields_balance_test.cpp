// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/analysis/fields.hpp"
#include "repose/core/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace repose {
namespace {

/// The integral of the standard normal distribution function up to z.
double integrated_normal(double z) {
  return 0.5 * z * std::erfc(-z / std::numbers::sqrt2) + std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

// The branch integral telescopes: d_b stress_ab = -sum_i F_ia W(r - r_i) + support_a for any contact forces, with F_i
// their sum on grain i. Integrated over x, and averaged exactly over the rows of cells, a cut carries
//   sum_i F_ia above(y_i) - sum_c support_ca above(y_c),
// where above(y) is the fraction of a Gaussian above y, averaged over the row. The grains need not be in equilibrium.
// Upright planes change nothing in that, however near: the Gaussian that they cut off has the same sum in every row.
// Tolerance: that of the quadrature along branches of 2.5 widths.
TEST(Fields, EveryRowCarriesTheForcesAboveIt) {
  constexpr int side = 12;
  const std::vector<FlatWall> upright{{{{-0.5, 0.0}}, {{1.0, 0.0}}}, {{{side - 0.4, 0.0}}, {{-1.0, 0.0}}}};
  enum class Sides { open, periodic, walls };
  for (const auto sides : {Sides::open, Sides::periodic, Sides::walls}) {
    const bool wraps = sides == Sides::periodic;
    for (const double width : {0.4, 1.5}) {
      Box<2> box;
      if (wraps) box = {.periodic = true, .x_min = 0.0, .x_max = side};
      Grains<2> grains;
      for (int k = 0; k < side * side; ++k) {
        const auto draw = [k](std::uint32_t n) {
          return uniform(1, Purpose::grain_size, static_cast<std::uint64_t>(k), n);
        };
        Grain<2> grain;
        grain.position = {{k % side + 0.1 * draw(0), k / side + 0.1 * draw(1)}};
        grain.radius = 0.4 + 0.1 * draw(2);
        grain.mass = 1.0;
        grain.inverse_mass = k < side ? 0.0 : 1.0;
        grains.add(grain, k);
      }
      std::vector<bool> heap(grains.size());
      for (std::size_t k = 0; k < heap.size(); ++k) heap[k] = !grains.line[k].fixed();

      Contacts<2> contacts;
      const auto touch = [&](int a, int b) {
        const auto between = separation(grains.line[static_cast<std::size_t>(a)].position,
                                        grains.line[static_cast<std::size_t>(b)].position, box);
        const auto index = static_cast<std::uint64_t>(a * side * side + b);
        Contact<2> contact;
        contact.first = a;
        contact.second = b;
        contact.normal = between * (1.0 / magnitude(between));
        contact.first_lever = 0.45 * magnitude(between);
        contact.normal_force = uniform(2, Purpose::grain_size, index);
        contact.tangential_force = uniform(3, Purpose::grain_size, index) - 0.5;
        contacts.list.push_back(contact);
      };
      for (int k = 0; k < side * side; ++k) {
        const bool last = k % side == side - 1;
        if (k + side < side * side) touch(k, k + side);  // the fixed row comes first in its contacts
        if (k >= side && (wraps || !last)) touch(k, last ? k + 1 - side : k + 1);
      }

      std::vector<Vec<2>> place;
      std::vector<Vec<2>> force;
      for (const auto& contact : contacts.list) {
        const auto first = static_cast<std::size_t>(contact.first);
        const auto second = static_cast<std::size_t>(contact.second);
        place.push_back(heap[first] ? grains.line[first].position
                                    : grains.line[first].position - contact.normal * contact.first_lever);
        force.push_back(force_of(contact));  // force on the first grain; for a support, minus its force on the heap
        place.push_back(grains.line[second].position);
        force.push_back(-force_of(contact));
      }
      const auto fields = coarse_grained({grains, box}, contacts, heap, box,
                                         {width, 0.0, sides == Sides::walls ? upright : std::vector<FlatWall>{}});
      const auto columns = fields.x.size();
      for (std::size_t row = 0; row < fields.y.size(); ++row) {
        for (int a = 0; a < 2; ++a) {
          double carried = 0.0;
          for (std::size_t k = 0; k < columns; ++k)
            carried += fields.stress[static_cast<std::size_t>(2 * a + 1)][row * columns + k] * fields.cell;
          const double low = fields.y[row] - 0.5 * fields.cell;
          double expected = 0.0;
          for (std::size_t k = 0; k < place.size(); ++k) {
            const double z = (place[k][1] - low) / width;
            const double above = integrated_normal(z) - integrated_normal(z - fields.cell / width);
            expected += force[k][a] * above * width / fields.cell;
          }
          EXPECT_NEAR(carried, expected, 1e-8) << "row " << row << ", axis " << a << ", width " << width;
        }
      }
    }
  }
}

}  // namespace
}  // namespace repose
