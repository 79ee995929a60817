#pragma once
// Fit of the loading law (6) of Edmans & Sinka, and of its variants, to the curve of a press.
//
// Minimised is the relative L2 error in delta_bar. k enters linearly and is projected out; delta_t is
// scanned, because the error has a kink in delta_t at every sample (which changes branch there) and several
// local minima; the best candidates are then polished within the stretch between two samples, where the error
// is smooth.

#include "fit/samples.hpp"
#include "platen/law/edmans_sinka_curve.hpp"
#include "press/curve.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace platen::fit {

/// Where a parameter may lie before the relative L2 error, the other parameters fitted anew, rises by 10 %.
struct Interval {
  double low = 0, high = 0;
};

struct EdmansSinkaFit {
  law::EdmansSinkaVariant variant = law::EdmansSinkaVariant::published;
  double k = 0;       ///< (6) [-]
  double delta_t = 0; ///< (6), in delta/R0 [-]
  double a = 0;       ///< (6) [-]
  Interval k_interval, delta_t_interval, a_interval;
  Errors errors;
  double r_squared = 0;
  double delta_bar_max = 0; ///< end of the fitted curve
  std::size_t points = 0;   ///< of the loading branch

  law::EdmansSinkaCurve<double> curve() const {
    law::EdmansSinkaCurve<double> result;
    result.k = k;
    result.delta_t = delta_t;
    result.a = a;
    result.variant = variant;
    return result;
  }
  std::vector<double> F_bar(const std::vector<double>& delta_bar) const;
  std::vector<std::string_view> on_bound() const; ///< keys that ended where the search does
};

/// The names under which cards and commands know the variants that differ in their curve.
std::vector<std::string_view> edmans_sinka_variants();
std::string_view name_of(law::EdmansSinkaVariant);

/// Throws core::InvalidInput for an unknown variant or a curve that loading_samples() refuses. Deterministic.
EdmansSinkaFit fit_edmans_sinka(const press::Curve&, std::string_view variant = "published");

struct EdmansSinkaComparison {
  std::vector<EdmansSinkaFit> fits; ///< all variants, the one with the smallest relative L2 error first
  std::string verdict;              ///< one sentence: which form fits best, and by how much
};

EdmansSinkaComparison fit_best(const press::Curve&);

} // namespace platen::fit
