// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/view/base_arrays.hpp"

#include "repose/comparison/base_comparison.hpp"
#include "repose/comparison/base_overlay.hpp"
#include "repose/core/errors.hpp"
#include "repose/io/folders.hpp"
#include "repose/record/record_file.hpp"
#include "repose/view/arrays.hpp"

#include <algorithm>

namespace repose {

namespace {

constexpr std::size_t curve_points = 201;
/// Drawn without being asked for: a continuum with a free surface at the angle of repose, and fixed principal axes.
constexpr const char* usual_models[] = {"pile-continuum", "osl:model=fpa"};

/// The column of a model at u = x_over_b, on straight lines between its rows; 0 beyond them.
double at(const theory::Table& table, const char* column, double u) {
  const auto& x = table.column("x_over_b").values;
  const auto& y = table.column(column).values;
  if (u < x.front() || u > x.back()) return 0.0;
  const auto next = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), u) - x.begin());
  if (next == x.size()) return y.back();
  return y[next - 1] + (y[next] - y[next - 1]) * (u - x[next - 1]) / (x[next] - x[next - 1]);
}

/// The models that suit a heap, matched to its base without a free parameter. A run without a heap has none.
void add_theories(ArrayMessage& message, const std::string& folder) {
  MeasuredBase base;
  try {
    base = measured_base(folder);
  } catch (const InputError&) {
    return;
  }
  std::vector<double> places;
  for (std::size_t k = 0; k < curve_points; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(curve_points - 1);
    places.push_back(base.centre + 1.2 * base.half_width * (2.0 * part - 1.0));
  }
  message.add("theory_x", places);
  for (const auto* written : usual_models) {
    std::vector<std::string> problems;
    try {
      const auto comparison = compare(read_choice(written, problems), base);
      const auto table = theory::predict(comparison.model);
      std::vector<double> normal;
      for (const double x : places) {
        normal.push_back(comparison.scale * at(table, "normal", (x - comparison.left) / comparison.width));
      }
      message.add("theory:" + comparison.label(), normal);
    } catch (const InputError&) {  // the heap does not suit this model
    }
  }
}

bool has_walls(const std::string& folder) {
  const auto path = folder + "/analysis.h5";
  return path_exists(path) && Hdf5Reader(path).has("walls/pressure");
}

void add_walls(ArrayMessage& message, const std::string& folder) {
  if (!has_walls(folder)) return;
  const Hdf5Reader file(folder + "/analysis.h5");
  message.add("wall_middle", file.dataset<double>("walls/middle", 2), 2);
  message.add("wall_pressure", file.dataset<double>("walls/pressure"));
  message.add("wall_shear", file.dataset<double>("walls/shear"));
}

}  // namespace

std::string base_arrays(const std::string& folder, const Scene& scene) {
  const auto base = read_base(Hdf5Reader(folder + "/run.h5"));
  if (base.x.empty() && !has_walls(folder)) throw InputError("the run has neither base grains nor walls");
  ArrayMessage message(nlohmann::ordered_json{{"unit", scene.gravity > 0.0 ? "grain weights" : "M L/T²"},
                                              {"from", base.window_start},
                                              {"until", base.window_end}});
  message.add("x", base.x);
  message.add("normal", base.normal);
  message.add("shear", base.shear);
  add_walls(message, folder);
  add_theories(message, folder);
  return message.bytes();
}

}  // namespace repose
