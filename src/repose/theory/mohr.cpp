// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#include "repose/theory/mohr.hpp"

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace repose::theory {

namespace {

constexpr double not_defined = std::numeric_limits<double>::quiet_NaN();
constexpr double at_limit = 1e-12;  // a ratio above 1 by less is rounding, not yield

double in_degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

/// The angle of a plane, brought into (-90, 90].
double folded(double degrees) {
  if (degrees > 90.0) return degrees - 180.0;
  return degrees <= -90.0 ? degrees + 180.0 : degrees;
}

/// a b - c d without cancellation (Kahan).
double difference_of_products(double a, double b, double c, double d) {
  const double second = c * d;
  return std::fma(a, b, -second) - std::fma(c, d, -second);
}

}  // namespace

PlaneStress stress_on_plane(const Mohr& place, double plane_deg) {
  // sin_pi and cos_pi are exactly 0 and 1 at multiples of 90 degrees.
  const double cosine = boost::math::cos_pi(plane_deg / 180.0);
  const double sine = boost::math::sin_pi(plane_deg / 180.0);
  const double cosine_2 = boost::math::cos_pi(plane_deg / 90.0);
  const double sine_2 = boost::math::sin_pi(plane_deg / 90.0);
  return {.normal = place.s_xx * sine * sine + place.s_zz * cosine * cosine - place.s_xz * sine_2 + 0.0,  // (11)
          .shear = 0.5 * (place.s_zz - place.s_xx) * sine_2 + place.s_xz * cosine_2 + 0.0};               // (13)
}

MohrCircle circle_of(const Mohr& place) {
  const double largest = std::max({std::abs(place.s_xx), std::abs(place.s_zz), std::abs(place.s_xz)});
  if (largest == 0.0) return {.principal_angle_deg = not_defined};
  const int exponent = std::ilogb(largest);
  const double xx = std::ldexp(place.s_xx, -exponent);
  const double zz = std::ldexp(place.s_zz, -exponent);
  const double xz = std::ldexp(place.s_xz, -exponent);
  const double centre = 0.5 * (zz + xx);
  const double half_difference = 0.5 * (zz - xx);
  const double radius = std::hypot(half_difference, xz);
  // The principal stress nearer to 0 follows from the determinant, the product of both.
  const double determinant = difference_of_products(zz, xx, xz, xz);
  const double major = centre >= 0.0 ? centre + radius : determinant / (centre - radius);
  const double minor = centre >= 0.0 ? determinant / (centre + radius) : centre - radius;
  return {
      .centre = std::ldexp(centre, exponent) + 0.0,
      .radius = std::ldexp(radius, exponent),
      .major = std::ldexp(major, exponent) + 0.0,
      .minor = std::ldexp(minor, exponent) + 0.0,
      .principal_angle_deg = radius == 0.0 ? not_defined : folded(0.5 * in_degrees(std::atan2(xz, half_difference)))};
}

double coulomb_ratio(const Mohr& place) {
  const auto circle = circle_of(place);
  const double held = circle.centre * boost::math::sin_pi(place.friction_deg / 180.0);
  if (held > 0.0) return circle.radius / held;
  return circle.radius == 0.0 && circle.centre >= 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
}

void parameters(Mohr& place, Parameters& to) {
  constexpr Bounds stress{.low = -1e100, .high = 1e100};
  to.number("s_xx", place.s_xx, stress, "stress", "horizontal normal stress, compression positive");
  to.number("s_zz", place.s_zz, stress, "stress", "vertical normal stress, compression positive");
  to.number("s_xz", place.s_xz, stress, "stress",
            "shear stress, positive if the upper side of a horizontal plane pushes the lower to the right");
  to.number("plane_deg", place.plane_deg, {.low = -90.0, .high = 90.0}, "deg",
            "angle of the chosen plane from the horizontal, positive if it descends to the right");
  to.number("friction_deg", place.friction_deg, {.low = 0.0, .high = 90.0, .high_allowed = false}, "deg",
            "angle of internal friction, phi");
  to.integer("points", place.points, {.low = 2, .high = 1'000'000}, "number of planes, -90 and 90 deg included");
}

Table evaluate(const Mohr& place) {
  Column planes{.name = "plane_deg",
                .unit = "deg",
                .about = "angle from the horizontal, positive if it descends to the right",
                .values = {},
                .words = {}};
  Column normals{.name = "normal",
                 .unit = "stress",
                 .about = "normal stress on the plane, compression positive",
                 .values = {},
                 .words = {}};
  Column shears{.name = "shear",
                .unit = "stress",
                .about = "shear stress on the lower side of the plane, positive down the plane and to the right",
                .values = {},
                .words = {}};
  for (std::int64_t i = 0; i < place.points; ++i) {
    const double degrees = -90.0 + 180.0 * (static_cast<double>(i) / static_cast<double>(place.points - 1));
    const auto stress = stress_on_plane(place, degrees);
    planes.values.push_back(degrees);
    normals.values.push_back(stress.normal);
    shears.values.push_back(stress.shear);
  }
  const auto circle = circle_of(place);
  const auto chosen = stress_on_plane(place, place.plane_deg);
  const double ratio = coulomb_ratio(place);
  // The major stress acts on a plane that dips by minus its own angle; slip planes are 45 + phi/2 from that plane.
  const double from_major = 45.0 + 0.5 * place.friction_deg;
  const std::string slip = "plane on which slip begins, 45 - friction_deg/2 from the major stress";
  return {{planes, normals, shears},
          {{"centre", circle.centre, "stress", "mean of the principal stresses, P"},
           {"radius", circle.radius, "stress", "largest shear, R"},
           {"major", circle.major, "stress", "larger principal stress"},
           {"minor", circle.minor, "stress", "smaller principal stress"},
           {"principal_angle_deg", circle.principal_angle_deg, "deg",
            "angle of the major stress from the vertical, positive if its lower end points to the right"},
           {"plane_normal", chosen.normal, "stress", "normal stress on the chosen plane"},
           {"plane_shear", chosen.shear, "stress", "shear stress on the chosen plane"},
           {"coulomb_ratio", ratio, "1", "R/(P sin phi); stable while <= 1"},
           {"slip_plane_1_deg", folded(from_major - circle.principal_angle_deg), "deg", slip + ", shear positive"},
           {"slip_plane_2_deg", folded(-from_major - circle.principal_angle_deg), "deg", slip + ", shear negative"},
           {"yields", ratio > 1.0 + at_limit ? 1.0 : 0.0, "1", "1 if the limit is exceeded by more than rounding"}}};
}

}  // namespace repose::theory
