// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bed.hpp"
#include "bed_method.hpp"
#include "measured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

// Moving grain-steps of the soft method in copies of a settled bed side by side, or new pair lists. Prints one line of
// JSON; the driver of ./dev bench runs it once for each measurement.

namespace repose::bench {
namespace {

struct Case {
  std::string law;
  std::string bed;
  int copies = 1;
  int threads = 1;
  double seconds = 1.0;
  bool lists = false;  ///< only new pair lists are measured
};

/// Steps, the pair lists that fall due among them included.
template <int D>
int time_steps(const Case& wanted) {
  auto bed = read_bed<D>(wanted.bed, wanted.copies);
  auto& grains = bed.grains;
  const auto method = bed_method<D>(wanted.law, bed.box);
  Team team(wanted.threads);
  method->grains_added(grains);
  const auto moving = static_cast<double>(moving_count(grains));
  constexpr double grain_steps = 5e5;  // of a piece, some hundredths of a second
  const long steps =
      std::max(20L, std::lround(grain_steps / moving));  // a run takes more between two rows of its series
  const auto advance = [&] {
    const auto until = method->time_steps().later(method->time(), method->time_steps().after(steps));
    const auto report = method->advance(grains, until, team);
    if (report.trouble) throw std::runtime_error("the bed has exploded");
    return static_cast<double>(report.steps) * moving;
  };
  constexpr double warming = 0.1;  // of the time measured
  measure(warming * wanted.seconds, advance);
  Profile profile;
  method->set_profile(&profile);
  const auto cost = measure(wanted.seconds, advance);
  double in_lists = 0.0;
  for (const auto& line : profile.lines()) {
    if (line.name == "pair lists" || line.name == "wall lists") in_lists += line.seconds;
  }
  print_cost(cost, fmt::format(R"("share_of_lists": {:.4f})", in_lists / cost.wall_seconds));
  return 0;
}

/// The whole cost of new pair lists (sorting, listing, slip displacements, distribution among threads), each after
/// every grain has moved by a skin. The work is the number of grains listed.
template <int D>
int time_lists(const Case& wanted) {
  auto bed = read_bed<D>(wanted.bed, wanted.copies);
  auto& grains = bed.grains;
  const auto method = bed_method<D>(wanted.law, bed.box);
  Team team(wanted.threads);
  method->grains_added(grains);
  method->refresh(grains, team);
  double displacement = 0.05;
  Cost all;
  while (all.cpu_seconds < wanted.seconds) {
    for (std::size_t i = 0; i < grains.size(); ++i) {
      const auto phase = static_cast<double>(grains.id[i]);
      grains.line[i].position[0] += displacement * std::cos(phase);
      grains.line[i].position[up<D>] += displacement * std::sin(phase);
    }
    displacement = -displacement;
    const auto once = measure(1e-9, [&] {
      method->refresh(grains, team);
      return static_cast<double>(grains.size());
    });
    all.work += once.work;
    all.cpu_seconds += once.cpu_seconds;
    all.wall_seconds += once.wall_seconds;
  }
  print_cost(all);
  return 0;
}

template <int D>
int carry_out(const Case& wanted) {
  return wanted.lists ? time_lists<D>(wanted) : time_steps<D>(wanted);
}

}  // namespace
}  // namespace repose::bench

int main(int argc, char** argv) {
  using namespace repose::bench;
  if (argc != 8) {
    fmt::print(stderr, "usage: repose_soft_bench steps|lists 2|3 LAW BED COPIES THREADS SECONDS\n");
    return 2;
  }
  try {
    const Case wanted{.law = argv[3],
                      .bed = argv[4],
                      .copies = std::stoi(argv[5]),
                      .threads = std::stoi(argv[6]),
                      .seconds = std::stod(argv[7]),
                      .lists = argv[1] == std::string("lists")};
    return argv[2] == std::string("3") ? carry_out<3>(wanted) : carry_out<2>(wanted);
  } catch (const std::exception& failure) {
    fmt::print(stderr, "repose_soft_bench: {}\n", failure.what());
    return 1;
  }
}
