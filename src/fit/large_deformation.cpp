#include "fit/large_deformation.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "fit/golden.hpp"
#include "fit/least_squares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace platen::fit {
namespace {

constexpr std::size_t fewest_points = 8;
constexpr double whole_from = 0.7; ///< of last_overlap()
constexpr double fit_from = 0.02, compare_from = 0.06, compare_to = 0.9;
constexpr double sides_to = 0.1; ///< (2.49) was calibrated up to here

/// y at which the polygon of rows first rises through `level`.
std::optional<double> crossing(const std::vector<std::pair<double, double>>& rows, double level) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto [x0, y0] = rows[i - 1];
    const auto [x1, y1] = rows[i];
    if (y0 < level && y1 >= level) return x0 + (level - y0) / (y1 - y0) * (x1 - x0);
  }
  return {};
}

} // namespace

law::LoadingCase loading_case(const press::Curve& curve, std::string_view law) {
  if (curve.experiment == "simple") return law::LoadingCase::simple;
  if (curve.experiment == "die") return law::LoadingCase::die;
  if (curve.experiment == "hydrostatic") return law::LoadingCase::hydrostatic;
  throw core::InvalidInput(fmt::format(
      "the experiment of the curve is '{}'; {} is fitted to simple, die or hydrostatic, which a line '# "
      "experiment = ...' says",
      curve.experiment, law));
}

double last_overlap(law::LoadingCase loading) {
  return loading == law::LoadingCase::simple ? 0.5 : law::x_of_filled_cell(loading);
}

std::vector<LoadedRow> loaded_rows(const press::Curve& curve, law::LoadingCase loading,
                                   std::string_view law) {
  std::vector<LoadedRow> rows;
  const double limit = last_overlap(loading);
  constexpr double last_digit = 1 + 1e-9; // the last row stands at the limit
  const double unit = std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa;
  for (const auto& p : curve.points) {
    if (p.branch != press::Branch::loading || !(p.contact_radius_m > 0) || !(p.force_N > 0) ||
        p.delta_bar < fit_from || p.delta_bar > limit * last_digit)
      continue;
    const double a = p.contact_radius_m / curve.radius_m, F = p.force_N / unit;
    rows.push_back({p.delta_bar, {F / (a * a), a, F}});
  }
  if (rows.size() < fewest_points)
    throw core::InvalidInput(
        fmt::format("the loading branch has {} rows with a contact radius and delta_bar from {} to "
                    "{:.4g}; a fit of {} needs at least {}",
                    rows.size(), fit_from, limit, law, fewest_points));
  return rows;
}

FittedRadius fit_radius(const std::vector<LoadedRow>& rows, law::LoadingCase loading,
                        const law::RadiusPolynomial<double>& published) {
  const bool whole = rows.back().x >= whole_from * last_overlap(loading);
  std::vector<std::vector<double>> terms(whole ? 3 : 1);
  std::vector<double> a;
  for (const auto& [x, point] : rows) {
    const double root = std::sqrt(x);
    terms[0].push_back(root);
    a.push_back(point.a);
    if (whole) terms[1].push_back(-root * x), terms[2].push_back(root * x * x);
    else a.back() -= root * x * (published.D5 * x - published.D3);
  }
  const auto D = least_squares(terms, a);
  if (whole) return {{D[0], D[1], D[2]}, true};
  return {{D[0], published.D3, published.D5}, false};
}

std::optional<double> side_onset(const press::Curve& curve) {
  if (curve.experiment != "die") return {};
  std::vector<std::pair<double, double>> products;
  for (const auto& p : curve.points)
    if (p.branch == press::Branch::loading)
      products.emplace_back(
          p.delta_bar, law::side_density_product(p.delta_bar, p.side[0].contact_radius_m / curve.radius_m));
  return crossing(products, law::shahin_minimum_density_product);
}

std::optional<SideMotion> side_motion(const press::Curve& curve) {
  if (curve.experiment != "simple") return {};
  std::vector<std::pair<double, double>> rows; // gamma/R and gamma_s/R
  double squares = 0;
  for (const auto& p : curve.points) {
    if (p.branch != press::Branch::loading || p.delta_bar <= 0 || p.delta_bar > sides_to) continue;
    rows.emplace_back(2 * p.delta_bar, 2 * p.equator_displacement_m / curve.radius_m);
    squares += rows.back().second * rows.back().second;
  }
  if (rows.size() < fewest_points || rows.back().first < 1.9 * sides_to || !(squares > 0)) return {};
  const auto tau_of = [&](double omega) {
    double product = 0, square = 0;
    for (const auto& [x, y] : rows) product += y * std::pow(x, omega), square += std::pow(x, 2 * omega);
    return product / square;
  };
  const auto misfit = [&](double omega) {
    double sum = 0;
    for (const auto& [x, y] : rows) sum += std::pow(tau_of(omega) * std::pow(x, omega) - y, 2);
    return sum;
  };
  const auto best = golden_section(misfit, 0.2, 20, 60);
  return SideMotion{tau_of(best.at), best.at, std::sqrt(best.value / squares)};
}

Deviations deviations(const LawOfOverlap& law, const std::vector<LoadedRow>& rows, law::LoadingCase loading) {
  Deviations d;
  d.from = compare_from, d.to = compare_to * last_overlap(loading);
  const auto add = [](RatioDeviation& deviation, double ratio) {
    deviation.largest = std::max(deviation.largest, std::abs(ratio - 1));
    deviation.rms += (ratio - 1) * (ratio - 1);
  };
  for (const auto& [x, curve] : rows) {
    if (x < d.from || x > d.to) continue;
    const LawPoint here = law(x);
    add(d.hardness, here.H / curve.H);
    add(d.radius, here.a / curve.a);
    add(d.force, here.F / curve.F);
    ++d.points;
  }
  for (RatioDeviation* deviation : {&d.hardness, &d.radius, &d.force})
    if (d.points) deviation->rms = std::sqrt(deviation->rms / static_cast<double>(d.points));
  return d;
}

LawCard fitted_card(std::string law, std::string variant,
                    const std::vector<std::pair<std::string_view, double>>& parameters,
                    const press::Curve& curve, const Deviations& d, std::string_view curve_text) {
  if (d.points == 0)
    throw core::InvalidInput(fmt::format(
        "the curve has no rows with delta_bar from {:.4g} to {:.4g}, so a card of {} could say no errors",
        d.from, d.to, law));
  LawCard card;
  card.law = std::move(law);
  card.variant = std::move(variant);
  for (const auto& [key, value] : parameters) card.parameters[std::string(key)] = core::number_text(value);
  card.parameters["loading"] = curve.experiment;
  card.delta_bar = {d.from, d.to};
  card.errors = {{"hardness_largest", d.hardness.largest}, {"hardness_rms", d.hardness.rms},
                 {"radius_largest", d.radius.largest},     {"radius_rms", d.radius.rms},
                 {"force_largest", d.force.largest},       {"force_rms", d.force.rms}};
  card.provenance = {
      {"material", curve.material}, {"curve_sha256", core::sha256(curve_text)}, {"engine", curve.engine}};
  make_law(card, {{"radius_m", core::number_text(curve.radius_m)}});
  return card;
}

} // namespace platen::fit
