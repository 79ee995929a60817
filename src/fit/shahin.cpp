#include "fit/shahin.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/hardness_search.hpp"

#include <fmt/format.h>

namespace platen::fit {
namespace {

using Coefficients = law::ShahinCoefficients<double>;

/// The law for H_max, q, x_min, H_min and L; the radius has no part in its hardness.
struct Hardness {
  static constexpr int coefficients = 5;
  law::LoadingCase loading;
  double inverse_m;

  template <class Real> auto operator()(const Real* theta) const {
    law::ShahinCoefficients<Real> c;
    c.D1 = Real(1);
    c.H_max = theta[0], c.q = theta[1], c.x_min = theta[2], c.H_min = theta[3], c.L = theta[4];
    return law::ShahinCurve<Real>::make(loading, Real(inverse_m), c);
  }
};

void check(const press::Curve& curve) {
  if (!(curve.E_Pa > 0)) throw core::InvalidInput("the curve says no E_Pa, which shahin needs; give --E_Pa");
  if (!(curve.sigma_ref_Pa > 0))
    throw core::InvalidInput("the curve says no sigma_ref_Pa, which is kappa in shahin; give --sigma_ref_Pa");
  if (!curve.inverse_m)
    throw core::InvalidInput(
        "the curve says no inverse_m, the hardening exponent 1/m of shahin, which a press of a "
        "material with hardening 'hollomon' does; give --inverse_m");
  if (!(*curve.inverse_m >= 0 && *curve.inverse_m <= 1))
    throw core::InvalidInput(
        fmt::format("inverse_m is {}; shahin holds from 0 to 1", core::number_text(*curve.inverse_m)));
}

LawOfOverlap law_of(const ShahinFit& fit, const Coefficients& coefficients) {
  return [curve = law::ShahinCurve<double>::make(fit.loading, fit.inverse_m, coefficients)](double x) {
    const auto p = curve.at(x);
    return LawPoint{p.H, p.a, p.F};
  };
}

} // namespace

ShahinFit fit_shahin(const press::Curve& curve) {
  check(curve);
  ShahinFit fit;
  fit.loading = loading_case(curve, "shahin");
  fit.inverse_m = *curve.inverse_m;
  fit.E_over_kappa = curve.E_Pa / curve.sigma_ref_Pa;
  auto rows = loaded_rows(curve, fit.loading, "shahin");
  const bool simple = fit.loading == law::LoadingCase::simple;
  if (!simple) // (3.58) goes to infinity at the limit
    std::erase_if(rows, [&](const LoadedRow& row) { return row.x > 0.98 * last_overlap(fit.loading); });
  fit.points = rows.size();
  fit.x_from = rows.front().x, fit.x_to = rows.back().x;
  fit.published = Coefficients::published(fit.loading, fit.inverse_m, law::ShahinVariant::hardening_minimum);
  Coefficients c = fit.published;
  const auto [radius, whole] = fit_radius(rows, fit.loading, {c.D1, c.D3, c.D5});
  c.D1 = radius.D1, c.D3 = radius.D3, c.D5 = radius.D5;
  if (!whole) fit.held = {"D_3", "D_5"};

  const double limit = last_overlap(fit.loading);
  const bool rises = !simple && fit.x_to > c.x_min;
  std::vector<SearchRange> ranges = {{"H_max", c.H_max, 0.1, 10, false},
                                     {"q", c.q, 0.5, 100, !simple},
                                     {"x_min", c.x_min, 0.3 * limit, 0.95 * limit, !rises},
                                     {"H_min", c.H_min, 0.05, 10, !rises},
                                     {"L", c.L, 0.01, 10, !rises}};
  const auto theta = search_hardness(Hardness{fit.loading, fit.inverse_m}, rows, radius, ranges);
  c.H_max = theta[0], c.q = theta[1], c.x_min = theta[2], c.H_min = theta[3], c.L = theta[4];
  for (const auto& range : ranges)
    if (range.held) fit.held.push_back(range.key);
  fit.on_bound = on_bounds(theta, ranges);
  fit.fitted = c;
  fit.of_fitted = deviations(law_of(fit, fit.fitted), rows, fit.loading);
  fit.of_published = deviations(law_of(fit, fit.published), rows, fit.loading);
  return fit;
}

LawCard law_card(const press::Curve& curve, const ShahinFit& fit, std::string_view curve_text) {
  std::vector<std::pair<std::string_view, double>> parameters = {
      {"E_Pa", curve.E_Pa}, {"nu", curve.nu}, {"kappa_Pa", curve.sigma_ref_Pa}, {"inverse_m", fit.inverse_m}};
  append(parameters, fit.fitted, law::shahin_coefficients);
  return fitted_card("shahin", "hardening-minimum", parameters, curve, fit.of_fitted, curve_text);
}

} // namespace platen::fit
