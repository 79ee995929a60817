#include "fit/contact_radius.hpp"

#include "fit/least_squares.hpp"
#include "fit/samples.hpp"
#include "platen/law/radius_points.hpp"

#include <algorithm>
#include <cmath>

namespace platen::fit {
namespace {

constexpr std::size_t fewest_rows = 8;
/// Of the largest overlap: the radius bends where a zone of plastic flow spreads, early, and evenly later.
constexpr double places[law::RadiusPoints<double>::most] = {0.01, 0.04, 0.1, 0.2, 0.4, 0.6, 0.8, 1};

struct Rows {
  std::vector<double> x, a;
};

Rows rows_of(const press::Curve& curve) {
  Rows rows;
  const double from = places[0] * press::loading_end(curve)->delta_bar * (1 - 1e-9);
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading || !(point.delta_bar >= from && point.delta_bar > 0)) continue;
    if (!(point.contact_radius_m > 0)) return {};
    if (!rows.x.empty() && !(point.delta_bar > rows.x.back() * (1 + 1e-9))) continue;
    rows.x.push_back(point.delta_bar);
    rows.a.push_back(point.contact_radius_m / curve.radius_m);
  }
  return rows;
}

/// Rows nearest to the places, so that each has one of its own.
std::vector<std::size_t> knots_of(const std::vector<double>& x) {
  std::vector<std::size_t> knots;
  for (const double place : places) {
    const double at = place * x.back();
    auto i = static_cast<std::size_t>(std::ranges::lower_bound(x, at) - x.begin());
    if (i > 0 && (i == x.size() || at - x[i - 1] < x[i] - at)) --i;
    if (knots.empty() || i > knots.back()) knots.push_back(i);
  }
  return knots;
}

} // namespace

ContactRadius fit_contact_radius(const press::Curve& curve) {
  if (!press::loading_end(curve)) return {};
  const Rows rows = rows_of(curve);
  if (rows.x.size() < fewest_rows) return {};
  std::vector<double> u, ln_a;
  for (const double x : rows.x) u.push_back(std::log(x));
  for (const double a : growing(rows.a, 0)) ln_a.push_back(std::log(a));
  const auto knots = knots_of(rows.x);
  const std::vector<double> weight = trapezoid_weights(u, u.front());
  std::vector<std::vector<double>> hats(knots.size(), std::vector<double>(u.size(), 0)); // ln a between knots
  for (std::size_t i = 0, k = 0; i < u.size(); ++i) {
    while (k + 2 < knots.size() && knots[k + 1] < i) ++k;
    const double t = (u[i] - u[knots[k]]) / (u[knots[k + 1]] - u[knots[k]]), root = std::sqrt(weight[i]);
    hats[k][i] = root * (1 - t), hats[k + 1][i] = root * t;
    ln_a[i] *= root;
  }
  ContactRadius fit;
  for (const std::size_t k : knots) fit.delta_bar.push_back(rows.x[k]);
  for (const double value : least_squares(hats, ln_a)) fit.a_bar.push_back(std::exp(value));
  fit.a_bar = growing(fit.a_bar, 0);
  const law::RadiusPoints<double> law(fit.delta_bar.data(), fit.a_bar.data(), static_cast<int>(knots.size()));
  const std::vector<double> length = trapezoid_weights(rows.x, rows.x.front());
  double squares = 0, all = 0;
  for (std::size_t i = 0; i < rows.x.size(); ++i) {
    const double miss = law.a_bar(rows.x[i]) - rows.a[i];
    squares += length[i] * miss * miss, all += length[i] * rows.a[i] * rows.a[i];
    fit.largest = std::max(fit.largest, std::abs(miss) / rows.a[i]);
  }
  fit.relative_l2 = std::sqrt(squares / all);
  return fit;
}

} // namespace platen::fit
