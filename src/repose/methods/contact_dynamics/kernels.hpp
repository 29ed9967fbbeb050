// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/instruction_set.hpp"
#include "repose/core/team.hpp"
#include "repose/methods/contact_dynamics/packs.hpp"
#include "repose/methods/contact_dynamics/start.hpp"

#include <cstddef>

namespace repose::contact_dynamics {

/// A sweep over packs. The forward direction sets the impulses of a pack to the start just before it relaxes them,
/// while they are at hand.
struct PackSweep {
  const ContactPack* packs = nullptr;
  double* impulses = nullptr;  ///< `pack_numbers(rolling)` for each pack, as in `history`
  Body<2>* bodies = nullptr;
  const double* fractions = nullptr;  ///< of the change of friction that is applied; nullptr: all of it
  bool rolling = true;
  Start start{};
  History history{};  ///< of the impulses; without a change, changes are not recorded
};

/// The velocities of the bodies in the search: velocities and rim velocities, body by body, padded with zeros.
template <int D>
struct Motions {
  static constexpr std::size_t each = D == 2 ? 3 : 6;  ///< numbers of a body
  static constexpr std::size_t block = 24;  ///< a whole number of bodies and of cache lines: ranges consist of blocks

  Body<D>* bodies = nullptr;
  std::size_t count = 0;            ///< of bodies
  const double* weights = nullptr;  ///< in twice the kinetic energy
  History history{};
};

/// What a sweep has changed.
struct Taken {
  double square = 0.0;   ///< of the change
  double along = 0.0;    ///< product of the decrease of the change and the newest remembered image
  double fastest = 0.0;  ///< largest change of a velocity
};

/// The other factor in a product with the new image: the next remembered image, the image itself, or the predicted
/// change, with the scaled image.
enum class With { next, itself, predicted };

/// Loops over a range of motions. Scalar products are those of twice the kinetic energy. They have eight partial sums,
/// because a single sum would wait for itself.
template <int D>
struct MotionKernels {
  /// Sets the velocities of the bodies to the start of a sweep. Returns the square of the predicted change.
  double (*start)(const Motions<D>& motions, const Start& start, Range range);
  /// Takes the change of a sweep that began at the base plus the predicted change.
  Taken (*take)(const Motions<D>& motions, bool remembered, Range range);
  /// Moves the base to where a plain sweep has ended. Returns the largest change of a velocity.
  double (*follow)(const Motions<D>& motions, Range range);
  double (*product)(const Motions<D>& motions, const Start& start, With with, Range range);
};

/// The inner loops of the solver for one set of instructions.
struct Kernels {
  void (*sweep_forward)(const PackSweep& sweep, Range packs);
  void (*sweep_back)(const PackSweep& sweep, Range packs);
  double (*separate_energy)(const ContactPack* packs, const double* changes, bool rolling, std::size_t count);
  /// Sets impulses to the start of a sweep; their number is a multiple of 8.
  void (*start_impulses)(const Start& start, const History& history, double* impulses, std::size_t count);
  MotionKernels<2> motions_2d;
  MotionKernels<3> motions_3d;

  template <int D>
  const MotionKernels<D>& motions() const {
    if constexpr (D == 2) {
      return motions_2d;
    } else {
      return motions_3d;
    }
  }
};

// The same sources, pack_kernel.hpp and motion_kernel.hpp, compiled for each instruction set.
const Kernels& kernels_baseline();
const Kernels& kernels_avx2();
const Kernels& kernels_avx512();

const Kernels& kernels_of(InstructionSet set);

}  // namespace repose::contact_dynamics
