// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/simulation/sources/draw.hpp"

namespace repose {

namespace {

/// The mean mass of grains of these sizes over that of one of diameter d.
template <int D>
double mean_mass(const SizeDistribution& sizes, double mass, double d) {
  return D == 2 ? mass * sizes.mean_square() / (d * d) : mass * sizes.mean_cube() / (d * d * d);
}

}  // namespace

template <int D>
GrainDraw<D>::GrainDraw(const Scene& scene, Purpose species, Purpose size)
    : seed_(static_cast<std::uint64_t>(scene.seed)),
      species_(species),
      size_(size),
      diameter_(scene.grains.diameter),
      polydispersity_(scene.grains.polydispersity) {
  const double d = diameter_;
  if (scene.species.empty()) {
    kinds_.push_back({SizeDistribution::fixed(d), 0, scene.mass_of(d, "")});
    return;
  }
  double sum = 0.0;
  for (const auto& one : scene.species) {
    const auto sizes = one.sizes->distribution();
    const double mass = scene.mass_of(d, one.material);
    // The share by number is the share by mass over the mean mass.
    sum += scene.grains.fractions_by == "mass" ? one.fraction / mean_mass<D>(sizes, mass, d) : one.fraction;
    kinds_.push_back({sizes, scene.material_number(one.material), mass, sum});
  }
  for (auto& kind : kinds_) kind.below /= sum;
}

template <int D>
DrawnGrain<D> GrainDraw<D>::operator()(std::uint64_t index) const {
  std::size_t k = 0;
  if (kinds_.size() > 1) {
    const double u = uniform(seed_, species_, index);
    while (k + 1 < kinds_.size() && u >= kinds_[k].below) ++k;
  }
  const auto& kind = kinds_[k];
  double diameter = kind.sizes.quantile(uniform(seed_, size_, index));
  if (polydispersity_ > 0.0) diameter = diameter_ * (1.0 - polydispersity_ * uniform(seed_, size_, index));
  DrawnGrain<D> drawn;
  drawn.material = kind.material;
  drawn.grain.radius = 0.5 * diameter;
  const double size = diameter / diameter_;
  const double discs = size * size;
  drawn.grain.mass = kind.mass * (D == 3 ? discs * size : discs);
  drawn.grain.inverse_mass = 1.0 / drawn.grain.mass;
  return drawn;
}

template class GrainDraw<2>;
template class GrainDraw<3>;

}  // namespace repose
