#pragma once
// Where the force curves of materials come from while a material is looked for, as laws of the form
// `pressed`.

#include "calibrate/free_material.hpp"
#include "platen/law/pressed.hpp"
#include "press/curve.hpp"
#include "surrogate/assess.hpp"

#include <functional>
#include <string>
#include <vector>

namespace platen::calibrate {

struct Curves {
  /// InvalidInput where nothing is known of the material.
  std::function<law::PressedMaterial(const material::Material&)> of;
  /// The same, off by one standard deviation in each of the ways in which it may be off.
  std::function<std::vector<law::PressedMaterial>(const material::Material&)> astray;
};

/// Of the surrogate that knows this material best, for all like it. InvalidInput where there is none.
Curves surrogate_curves(const material::Material& typical);
/// Its answer, and whether it may be believed.
surrogate::Answer surrogate_answer(const material::Material& typical, const material::Material&);

/// Logarithms of F/(pi R0^2 sigma_ref) and a/R0 at overlaps over R0, and of alpha and beta of unloadings.
struct LogCurve {
  std::vector<double> delta_bar, F, a, unload_delta_bar, alpha, beta;
};
/// Made to grow where it falls; unloading between overlaps as fit::refine_unloading() says it.
law::PressedMaterial curve_of(const LogCurve&, const material::Material&, double sigma_ref);

} // namespace platen::calibrate
