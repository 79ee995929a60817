#include "press/tension.hpp"

#include <fmt/format.h>

namespace platen::press {
namespace {

Tension tension_at(const CurvePoint& point) {
  return {point.sigma_1_max_Pa, point.delta_bar, point.branch, point.branch_id};
}

std::string place(const Tension& tension) {
  return fmt::format("at delta_bar = {:.4g}{}", tension.delta_bar,
                     tension.branch == Branch::unloading   ? " while unloading"
                     : tension.branch == Branch::reloading ? " while reloading"
                                                           : "");
}

} // namespace

Tension largest_tension(const Curve& curve) {
  Tension largest;
  for (const auto& point : curve.points)
    if (point.sigma_1_max_Pa > largest.sigma_1_Pa) largest = tension_at(point);
  return largest;
}

std::optional<Tension> fracture(const Curve& curve, double tensile_strength_Pa) {
  CurvePoint before; // at rest
  for (const auto& point : curve.points) {
    if (point.branch_id != before.branch_id) before = point; // a branch starts from a state already looked at
    if (point.sigma_1_max_Pa >= tensile_strength_Pa) {
      Tension first = tension_at(point);
      const double rise = point.sigma_1_max_Pa - before.sigma_1_max_Pa;
      if (rise > 0)
        first.delta_bar -=
            (point.sigma_1_max_Pa - tensile_strength_Pa) / rise * (point.delta_bar - before.delta_bar);
      first.sigma_1_Pa = tensile_strength_Pa;
      return first;
    }
    before = point;
  }
  return {};
}

std::string tension_words(const Curve& curve, std::optional<double> tensile_strength_Pa) {
  const Tension largest = largest_tension(curve);
  std::string words = largest.sigma_1_Pa > 0
                          ? fmt::format("largest tension {:.4g} Pa {}", largest.sigma_1_Pa, place(largest))
                          : "no tension anywhere";
  if (!tensile_strength_Pa) return words;
  const auto first = fracture(curve, *tensile_strength_Pa);
  return words +
         (first
              ? fmt::format("; it reaches the tensile strength, {:.4g} Pa, {}: the particle may crack there",
                            *tensile_strength_Pa, place(*first))
              : fmt::format("; below the tensile strength, {:.4g} Pa", *tensile_strength_Pa));
}

} // namespace platen::press
