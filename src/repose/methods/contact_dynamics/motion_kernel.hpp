// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The loops over the velocities of the bodies in a search, for the instruction set that the including source is
// compiled for (see vectors.hpp).
#pragma once

#include "repose/methods/contact_dynamics/kernels.hpp"
#include "repose/methods/contact_dynamics/lanes.hpp"
#include "repose/methods/contact_dynamics/vectors.hpp"

#include <cstddef>

namespace repose::contact_dynamics {
namespace {

/// Eight partial sums, or the larger of numbers.
constexpr std::size_t sums = 8;
struct Sums {
  Lanes part[sums / width]{};
};

REPOSE_FN double sum_of(const Sums& of) {
  double sum[sums];
  for (std::size_t l = 0; l < sums; ++l) sum[l] = of.part[l / width][l % width];
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

REPOSE_FN double largest_of(const Sums& of) {
  double largest = 0.0;
  for (std::size_t l = 0; l < sums; ++l) largest = larger(largest, double(of.part[l / width][l % width]));
  return largest;
}

/// Calls visit(entry, part) for the vectors of a range.
template <class Visit>
REPOSE_FN void for_each_vector(Range range, const Visit& visit) {
  for (std::size_t k = range.begin; k < range.end; k += sums) {
    for (std::size_t part = 0; part < sums / width; ++part) visit(k + part * width, part);
  }
}

/// The velocities of some bodies, body by body. Some blocks at a time are copied, so that vectors are not read just
/// after single numbers of them are written, for which a processor must wait.
template <int D>
struct alignas(64) Copied {
  static constexpr std::size_t size = 8 * Motions<D>::block;
  double numbers[size];
};

template <int D>
REPOSE_FN void copy_in(const Motions<D>& from, Range range, Copied<D>& to) {
  constexpr auto each = Motions<D>::each;
  const std::size_t last = range.end / each;
  for (std::size_t k = range.begin / each, place = 0; k < last; ++k, place += each) {
    if (k >= from.count) {
      for (std::size_t l = 0; l < each; ++l) to.numbers[place + l] = 0.0;
      continue;
    }
    const double* body = reinterpret_cast<const double*>(from.bodies + k);
    for (std::size_t l = 0; l < each; ++l) to.numbers[place + l] = body[l];
  }
}

template <int D>
REPOSE_FN void copy_out(const Copied<D>& from, Range range, const Motions<D>& to) {
  constexpr auto each = Motions<D>::each;
  const std::size_t end = range.end / each;
  const std::size_t last = end < to.count ? end : to.count;
  for (std::size_t k = range.begin / each, place = 0; k < last; ++k, place += each) {
    double* body = reinterpret_cast<double*>(to.bodies + k);
    for (std::size_t l = 0; l < each; ++l) body[l] = from.numbers[place + l];
  }
}

/// Calls visit(range) for pieces that fit into a copy.
template <int D, class Visit>
REPOSE_FN void for_each_piece(Range range, const Visit& visit) {
  for (std::size_t k = range.begin; k < range.end; k += Copied<D>::size) {
    const std::size_t end = k + Copied<D>::size;
    visit(Range{k, end < range.end ? end : range.end});
  }
}

template <int D>
double start_motions(const Motions<D>& given, const Start& given_start, Range range) {
  const Motions<D> motions = given;
  const Start start = given_start;
  Sums square;
  with_kind(start, [&]<Start::Kind Kind, std::size_t Others>() {
    if constexpr (Kind != Start::Kind::here) {
      for_each_piece<D>(range, [&](Range piece) {
        Copied<D> now;
        for_each_vector(piece, [&](std::size_t k, std::size_t part) {
          lanes(now.numbers + (k - piece.begin)) = start_lanes<Kind, Others>(start, motions.history, k);
          const Lanes predicted = lanes(motions.history.predicted + k);
          square.part[part] += lanes(motions.weights + k) * (predicted * predicted);
        });
        copy_out(now, piece, motions);
      });
    }
  });
  return sum_of(square);
}

template <int D, bool Remembered>
Taken take_change(const Motions<D>& given, Range range) {
  const Motions<D> motions = given;
  const auto& of = motions.history;
  Sums square, along, fastest;
  for_each_piece<D>(range, [&](Range piece) {
    Copied<D> now;
    copy_in(motions, piece, now);
    for_each_vector(piece, [&](std::size_t k, std::size_t part) {
      const Lanes predicted = lanes(of.predicted + k);
      const Lanes weight = lanes(motions.weights + k);
      const Lanes change = lanes(now.numbers + (k - piece.begin)) - (lanes(of.base + k) + predicted);
      lanes(of.change + k) = change;
      square.part[part] += weight * (change * change);
      if constexpr (Remembered) along.part[part] += weight * ((predicted - change) * lanes(of.images[0] + k));
      fastest.part[part] = larger(fastest.part[part], larger(change, Lanes(-change)));
    });
  });
  return {sum_of(square), sum_of(along), largest_of(fastest)};
}

template <int D>
Taken take_motions(const Motions<D>& motions, bool remembered, Range range) {
  return remembered ? take_change<D, true>(motions, range) : take_change<D, false>(motions, range);
}

template <int D>
double follow_motions(const Motions<D>& given, Range range) {
  const Motions<D> motions = given;
  Sums fastest;
  for_each_piece<D>(range, [&](Range piece) {
    Copied<D> now;
    copy_in(motions, piece, now);
    for_each_vector(piece, [&](std::size_t k, std::size_t part) {
      auto& base = lanes(motions.history.base + k);
      const Lanes change = lanes(now.numbers + (k - piece.begin)) - base;
      base += change;
      fastest.part[part] = larger(fastest.part[part], larger(change, Lanes(-change)));
    });
  });
  return largest_of(fastest);
}

template <int D>
double motions_product(const Motions<D>& given, const Start& given_start, With with, Range range) {
  const Motions<D> motions = given;
  const Start start = given_start;
  const auto& of = motions.history;
  Sums sum;
  with_kind(start, [&]<Start::Kind, std::size_t Others>() {
    for_each_vector(range, [&](std::size_t k, std::size_t part) {
      const Lanes image = image_of<Others>(start, of, [&](const double* numbers) { return Lanes(lanes(numbers + k)); });
      const Lanes weight = lanes(motions.weights + k);
      if (with == With::itself) {
        sum.part[part] += weight * (image * image);
      } else if (with == With::predicted) {
        sum.part[part] += weight * (lanes(of.predicted + k) * (image * start.factor));
      } else if constexpr (Others < Start::most_others) {
        sum.part[part] += weight * (image * lanes(of.images[Others] + k));
      }
    });
  });
  return sum_of(sum);
}

template <int D>
constexpr MotionKernels<D> motion_kernels{start_motions<D>, take_motions<D>, follow_motions<D>, motions_product<D>};

/// Sets impulses that no pack holds to the start of a sweep.
void start_impulses(const Start& given, const History& of, double* impulses, std::size_t count) {
  const Start start = given;
  const History history = of;
  with_kind(start, [&]<Start::Kind Kind, std::size_t Others>() {
    if constexpr (Kind != Start::Kind::here) {
      for (std::size_t k = 0; k < count; k += width) {
        lanes(impulses + k) = start_lanes<Kind, Others>(start, history, k);
      }
    }
  });
}

}  // namespace
}  // namespace repose::contact_dynamics
