#include "fit/agarwal.hpp"

#include "core/error.hpp"
#include "fit/hardness_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::fit {
namespace {

using Coefficients = law::AgarwalCoefficients<double>;

/// The law for H_max, x_h, q, r, x_min, H_min and -ln(1 - l); the radius has no part in its hardness.
struct Hardness {
  static constexpr int coefficients = 7;
  law::LoadingCase loading;
  double lambda, zeta;

  template <class Real> auto operator()(const Real* theta) const {
    law::AgarwalCoefficients<Real> c;
    using std::exp;
    c.D1 = Real(1), c.x_joined = Real(1);
    c.H_max = theta[0], c.x_h = theta[1], c.q = theta[2], c.r = theta[3], c.x_min = theta[4],
    c.H_min = theta[5];
    c.l = Real(1) - exp(-theta[6]);
    return law::AgarwalCurve<Real>::make(loading, law::AgarwalVariant::published, Real(lambda), Real(zeta),
                                         c);
  }
};

void check(const press::Curve& curve) {
  if (!(curve.E_Pa > 0)) throw core::InvalidInput("the curve says no E_Pa, which agarwal needs; give --E_Pa");
  if (!(curve.sigma_ref_Pa > 0))
    throw core::InvalidInput("the curve says no sigma_ref_Pa, the yield stress that agarwal needs; give "
                             "--sigma_ref_Pa");
}

LawOfOverlap law_of(const AgarwalFit& fit, law::AgarwalVariant variant, const Coefficients& coefficients) {
  return [curve = law::AgarwalCurve<double>::make(fit.loading, variant, fit.lambda, fit.zeta, coefficients)](
             double x) {
    const auto p = curve.at(x);
    return LawPoint{p.H, p.a, p.F};
  };
}

} // namespace

AgarwalFit fit_agarwal(const press::Curve& curve) {
  check(curve);
  AgarwalFit fit;
  fit.loading = loading_case(curve, "agarwal");
  fit.lambda = curve.E_Pa / ((1 - curve.nu * curve.nu) * curve.sigma_ref_Pa);
  fit.zeta = curve.E_Pa / (3 * (1 - 2 * curve.nu)) / curve.sigma_ref_Pa;
  if (!(fit.lambda >= 22.1))
    throw core::InvalidInput(
        fmt::format("lambda = E/((1 - nu^2) sigma_ref) is {:.4g}; agarwal holds from 22.1 on", fit.lambda));
  const auto rows = loaded_rows(curve, fit.loading, "agarwal");
  fit.points = rows.size();
  fit.x_from = rows.front().x, fit.x_to = rows.back().x;
  fit.published = Coefficients::published(fit.loading, fit.lambda, fit.zeta);
  fit.side_onset = side_onset(curve);
  fit.sides = side_motion(curve);

  Coefficients c = fit.published;
  const auto [radius, whole] = fit_radius(rows, fit.loading, {c.D1, c.D3, c.D5});
  c.D1 = radius.D1, c.D3 = radius.D3, c.D5 = radius.D5;
  if (!whole) fit.held = {"D_3", "D_5"};
  c.x_joined = std::min(c.x_joined, fit.x_from); // the fitted radius holds from the first row on
  const bool simple = fit.loading == law::LoadingCase::simple;
  const double limit = last_overlap(fit.loading), x_y = std::pow(3.3 * std::numbers::pi / 4 / fit.lambda, 2);
  const bool rises = !simple && fit.x_to > c.x_min;
  std::vector<SearchRange> ranges = {{"H_max", c.H_max, 1.2, 10, false},
                                     {"x_h", c.x_h, 1.01 * x_y, 0.25 * limit, c.x_h < fit.x_from},
                                     {"q", c.q, 0.5, 100, !simple},
                                     {"r", c.r, 1, 10, !simple},
                                     {"x_min", c.x_min, 0.3 * limit, 0.97 * limit, !rises},
                                     {"H_min", c.H_min, 0.1, 10, !rises},
                                     {"l", -std::log1p(-c.l), 0.1, 20, !rises}};
  const auto theta = search_hardness(Hardness{fit.loading, fit.lambda, fit.zeta}, rows, radius, ranges);
  c.H_max = theta[0], c.x_h = theta[1], c.q = theta[2], c.r = theta[3], c.x_min = theta[4],
  c.H_min = theta[5];
  c.l = -std::expm1(-theta[6]);
  for (const auto& range : ranges)
    if (range.held) fit.held.push_back(range.key);
  fit.on_bound = on_bounds(theta, ranges);
  fit.fitted = c;
  if (rises) fit.Gamma = law::density_product(fit.loading, c.x_min, radius.a_bar(c.x_min));
  fit.of_fitted = deviations(law_of(fit, law::AgarwalVariant::hertz_radius, fit.fitted), rows, fit.loading);
  fit.of_published =
      deviations(law_of(fit, law::AgarwalVariant::published, fit.published), rows, fit.loading);
  return fit;
}

LawCard law_card(const press::Curve& curve, const AgarwalFit& fit, std::string_view curve_text) {
  std::vector<std::pair<std::string_view, double>> parameters = {
      {"E_Pa", curve.E_Pa}, {"nu", curve.nu}, {"sigma_y_Pa", curve.sigma_ref_Pa}};
  append(parameters, fit.fitted, law::agarwal_coefficients);
  return fitted_card("agarwal", "hertz-radius", parameters, curve, fit.of_fitted, curve_text);
}

} // namespace platen::fit
