#pragma once
// What the fits of `agarwal` and `shahin` share: rows of a curve over x = gamma/2R = delta/R0, contact
// radius, hardness and force without units, the radius of (2.13), side contacts, and how far a law is from a
// curve.

#include "fit/law_card.hpp"
#include "platen/law/agarwal_curve.hpp"
#include "press/curve.hpp"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platen::fit {

struct LawPoint {
  double H, a, F; ///< F/(pi a^2 sigma), a/R, F/(pi R^2 sigma)
};
using LawOfOverlap = std::function<LawPoint(double x)>;

struct LoadedRow {
  double x;
  LawPoint point;
};

/// The loading case of a curve. Throws core::InvalidInput for another experiment than simple, die or
/// hydrostatic.
law::LoadingCase loading_case(const press::Curve&, std::string_view law);

/// Where the cell is filled; 0.5 for simple loading.
double last_overlap(law::LoadingCase);

/// Rows of the loading branch with a contact radius and x from 0.02 to last_overlap(). Throws
/// core::InvalidInput where there are fewer than eight.
std::vector<LoadedRow> loaded_rows(const press::Curve&, law::LoadingCase, std::string_view law);

/// a/R = sqrt(x) (D_1 - D_3 x + D_5 x^2) (2.13) by linear least squares. From rows that end before 0.7 of
/// last_overlap() D_1 alone: the others would follow scallops, and lead astray beyond.
struct FittedRadius {
  law::RadiusPolynomial<double> polynomial;
  bool whole; ///< D_3 and D_5 are not those of `published`
};
FittedRadius fit_radius(const std::vector<LoadedRow>&, law::LoadingCase,
                        const law::RadiusPolynomial<double>& published);

/// Of the walls of a die: x of the primary contacts at which rho_V rho_S of the side contacts is 0.0593
/// (2.52), Table 2.4. Nothing where the curve does not reach it.
std::optional<double> side_onset(const press::Curve&);

/// Of a simple press: gamma_s/R = tau (gamma/R)^omega (2.49), without units, by least squares in gamma_s up
/// to x = 0.1.
struct SideMotion {
  double tau, omega;
  double relative_l2;
};
/// Nothing for other experiments, and where the curve does not reach 0.095.
std::optional<SideMotion> side_motion(const press::Curve&);

/// Of a law, relative to the curve, over the overlaps of the comparison.
struct RatioDeviation {
  double largest = 0; ///< of |law/curve - 1|
  double rms = 0;     ///< over the rows
};
struct Deviations {
  double from = 0, to = 0; ///< x, 0.06 to 0.9 of the limit
  std::size_t points = 0;
  RatioDeviation hardness, radius, force;
};
Deviations deviations(const LawOfOverlap&, const std::vector<LoadedRow>&, law::LoadingCase);

/// A card of this curve with these parameters, and the loading; with [validity], [error] and [provenance].
/// Throws core::InvalidInput where there was nothing to compare with, and where the coefficients make no law.
LawCard fitted_card(std::string law, std::string variant,
                    const std::vector<std::pair<std::string_view, double>>& parameters, const press::Curve&,
                    const Deviations&, std::string_view curve_text);

/// The coefficients as parameters of a card.
template <class Coefficients, class Table>
void append(std::vector<std::pair<std::string_view, double>>& parameters, const Coefficients& values,
            const Table& table) {
  for (const auto& c : table) parameters.emplace_back(c.key, values.*c.member);
}

} // namespace platen::fit
