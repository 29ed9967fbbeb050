// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "repose/core/size_distribution.hpp"
#include "repose/scene/kind.hpp"
#include "repose/scene/problems.hpp"

#include <string>
#include <vector>

namespace repose {

/// A distribution of diameters as a species chooses it.
class SizesKind : public AnyKind<SizesKind> {
 public:
  /// The keys below sizes, besides the kind; `diameter` [L] is that of the scene.
  virtual void keys(double diameter, Parameters& keys) = 0;
  /// `prefix` is that of the keys: "species[0].sizes.".
  virtual void check(const std::string& /*prefix*/, Problems& /*problems*/) const {}

  virtual double smallest() const = 0;                ///< [L]
  virtual double largest() const = 0;                 ///< [L]
  virtual SizeDistribution distribution() const = 0;  ///< of a sound scene

  virtual std::string describe() const { return std::string(name()); }
};

Kinds<SizesKind>& sizes_kinds();

struct FixedSizes final : KindOf<FixedSizes, SizesKind> {
  static constexpr std::string_view kind = "fixed";
  static constexpr std::string_view meaning = "all the same";

  double diameter = unset;  ///< [L]

  void keys(double d, Parameters& keys) override {
    keys.number("diameter", diameter, {d, "d"}, positive, "L", "diameter of all grains of the species");
  }
  double smallest() const override { return diameter; }
  double largest() const override { return diameter; }
  SizeDistribution distribution() const override { return SizeDistribution::fixed(diameter); }
};

struct UniformSizes final : KindOf<UniformSizes, SizesKind> {
  static constexpr std::string_view kind = "uniform";
  static constexpr std::string_view meaning = "uniform from low to high";

  double low = unset;   ///< [L]
  double high = unset;  ///< [L]

  void keys(double, Parameters& keys) override {
    keys.number("low", low, required, positive, "L", "smallest diameter");
    keys.number("high", high, required, positive, "L", "largest diameter");
  }
  void check(const std::string& prefix, Problems& problems) const override;
  double smallest() const override { return low; }
  double largest() const override { return high; }
  SizeDistribution distribution() const override { return SizeDistribution::uniform(low, high); }
};

/// A bell of some mean and standard deviation of the diameter, before it is cut to [low, high].
class BellSizes : public SizesKind {
 public:
  double mean = unset;       ///< [L]
  double deviation = unset;  ///< [L]
  double low = unset;        ///< [L]
  double high = unset;       ///< [L]

  void keys(double d, Parameters& keys) override;
  void check(const std::string& prefix, Problems& problems) const override;
  double smallest() const override { return low; }
  double largest() const override { return high; }
  std::string describe() const override;

 protected:
  struct Cut {
    double low;
    double high;
    std::string_view low_rule;
    std::string_view high_rule;
  };
  virtual Cut usual_cut() const = 0;
  virtual double part_left() const = 0;  ///< what the cuts leave of the distribution
};

struct NormalSizes final : KindOf<NormalSizes, BellSizes> {
  static constexpr std::string_view kind = "normal";
  static constexpr std::string_view meaning = "normal, cut at low and high";

  SizeDistribution distribution() const override { return SizeDistribution::normal(mean, deviation, low, high); }

 protected:
  Cut usual_cut() const override;
  double part_left() const override;
};

struct LogNormalSizes final : KindOf<LogNormalSizes, BellSizes> {
  static constexpr std::string_view kind = "log-normal";
  static constexpr std::string_view meaning = "log-normal, cut at low and high; mean and deviation are of the diameter";

  SizeDistribution distribution() const override { return SizeDistribution::log_normal(mean, deviation, low, high); }

 protected:
  Cut usual_cut() const override;
  double part_left() const override;
};

/// Sizes given by a list of diameters.
class ListedSizes : public SizesKind {
 public:
  std::vector<double> diameters;  ///< [L]

  double smallest() const override;
  double largest() const override;
};

struct TableSizes final : KindOf<TableSizes, ListedSizes> {
  static constexpr std::string_view kind = "table";
  static constexpr std::string_view meaning = "some diameters, each with a weight by number";

  std::vector<double> weights;

  void keys(double, Parameters& keys) override {
    keys.numbers("diameters", diameters, "L", "diameters of the grains");
    keys.numbers("weights", weights, "", "fraction by number of each diameter");
  }
  void check(const std::string& prefix, Problems& problems) const override;
  SizeDistribution distribution() const override { return SizeDistribution::table(diameters, weights); }
};

struct SieveSizes final : KindOf<SieveSizes, ListedSizes> {
  static constexpr std::string_view kind = "sieve";
  static constexpr std::string_view meaning = "a sieve curve; mass is spread evenly between two sieves";

  std::vector<double> passing;

  void keys(double, Parameters& keys) override {
    keys.numbers("diameters", diameters, "L", "openings of the sieves, rising");
    keys.numbers("passing", passing, "", "fraction by mass finer than each, rising from 0 to 1");
  }
  void check(const std::string& prefix, Problems& problems) const override;
  SizeDistribution distribution() const override { return SizeDistribution::sieve(diameters, passing); }
};

}  // namespace repose
