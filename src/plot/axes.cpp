#include "plot/axes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace platen::plot {

Unit unit_for(double value, const std::vector<Unit>& units) {
  for (const Unit& unit : units)
    if (value >= unit.in_SI) return unit;
  return units.back();
}

double tick(double range, int wanted) {
  const double raw = range / wanted, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= raw * 0.999) return step * power;
  return 10 * power;
}

std::string second_axes(const press::Curve& curve, double x_max, double y_max) {
  if (!(curve.radius_m > 0)) return "";
  const Unit length = unit_for(x_max * curve.radius_m, {{"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}});
  const double x_scale = curve.radius_m / length.in_SI;
  std::string result =
      fmt::format("set x2range [0:{}]\nset x2tics {} out scale 0.5 offset 0,-0.3 tc rgb '{}'\n"
                  "set x2label 'overlap δ ({})' offset 0,-0.5 tc rgb '{}'\n",
                  x_max * x_scale, tick(x_max * x_scale, 8), ink, length.name, ink);
  const double F_ref = std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa;
  if (!(F_ref > 0)) return result;
  const Unit force =
      unit_for(y_max * F_ref, {{"MN", 1e6}, {"kN", 1e3}, {"N", 1}, {"mN", 1e-3}, {"µN", 1e-6}, {"nN", 1e-9}});
  const double y_scale = F_ref / force.in_SI;
  return result + fmt::format("set y2range [0:{}]\nset y2tics {} out scale 0.5 tc rgb '{}'\n"
                              "set y2label 'force F ({})' tc rgb '{}'\n",
                              y_max * y_scale, tick(y_max * y_scale, 8), ink, force.name, ink);
}

} // namespace platen::plot
