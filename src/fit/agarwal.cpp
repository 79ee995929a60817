#include "fit/agarwal.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace platen::fit {
namespace {

constexpr std::size_t fewest_points = 8;
constexpr double fit_from = 0.02, compare_from = 0.06, compare_to = 0.9;

law::LoadingCase loading_of(const press::Curve& curve) {
  if (curve.experiment == "simple") return law::LoadingCase::simple;
  if (curve.experiment == "die") return law::LoadingCase::die;
  if (curve.experiment == "hydrostatic") return law::LoadingCase::hydrostatic;
  throw core::InvalidInput(
      fmt::format("the experiment of the curve is '{}'; agarwal is fitted to simple, die or "
                  "hydrostatic, which a line '# experiment = ...' says",
                  curve.experiment));
}

void check(const press::Curve& curve) {
  if (!(curve.E_Pa > 0)) throw core::InvalidInput("the curve says no E_Pa, which agarwal needs; give --E_Pa");
  if (!(curve.sigma_ref_Pa > 0))
    throw core::InvalidInput("the curve says no sigma_ref_Pa, the yield stress that agarwal needs; give "
                             "--sigma_ref_Pa");
}

} // namespace

AgarwalFit fit_agarwal(const press::Curve& curve) {
  check(curve);
  AgarwalFit fit;
  fit.loading = loading_of(curve);
  fit.lambda = curve.E_Pa / ((1 - curve.nu * curve.nu) * curve.sigma_ref_Pa);
  fit.zeta = curve.E_Pa / (3 * (1 - 2 * curve.nu)) / curve.sigma_ref_Pa;
  if (!(fit.lambda >= 22.1))
    throw core::InvalidInput(
        fmt::format("lambda = E/((1 - nu^2) sigma_ref) is {:.4g}; agarwal holds from 22.1 on", fit.lambda));
  fit.delta_bar_limit = fit.loading == law::LoadingCase::simple ? 0.5 : law::x_of_filled_cell(fit.loading);
  const auto law =
      law::AgarwalCurve<double>::make(fit.loading, law::AgarwalVariant::published, fit.lambda, fit.zeta);
  fit.published = law.radius;

  std::vector<const press::CurvePoint*> rows;
  constexpr double last_digit = 1 + 1e-9; // the last row stands at the limit
  for (const auto& p : curve.points)
    if (p.branch == press::Branch::loading && p.contact_radius_m > 0 && p.force_N > 0 &&
        p.delta_bar >= fit_from && p.delta_bar <= fit.delta_bar_limit * last_digit)
      rows.push_back(&p);
  fit.points = rows.size();
  if (rows.size() < fewest_points)
    throw core::InvalidInput(
        fmt::format("the loading branch has {} rows with a contact radius and delta_bar from "
                    "{} to {:.4g}; a fit of agarwal needs at least {}",
                    rows.size(), fit_from, fit.delta_bar_limit, fewest_points));
  fit.delta_bar_from = rows.front()->delta_bar;
  fit.delta_bar_to = rows.back()->delta_bar;

  Eigen::MatrixX3d A(rows.size(), 3);
  Eigen::VectorXd b(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double x = rows[i]->delta_bar, root = std::sqrt(x);
    const auto row = static_cast<Eigen::Index>(i);
    A.row(row) << root, -root * x, root * x * x;
    b(row) = rows[i]->contact_radius_m / curve.radius_m;
  }
  const Eigen::Vector3d D = A.colPivHouseholderQr().solve(b);
  fit.fitted = {D(0), D(1), D(2)};

  double squares = 0;
  std::size_t compared = 0;
  const auto add = [](Deviation& deviation, double ratio) {
    deviation.largest = std::max(deviation.largest, std::abs(ratio - 1));
    deviation.rms += (ratio - 1) * (ratio - 1);
  };
  fit.compared_from = compare_from;
  fit.compared_to = compare_to * fit.delta_bar_limit;
  const double R = curve.radius_m;
  for (const auto* p : rows) {
    const double x = p->delta_bar, a = p->contact_radius_m / R;
    squares += std::pow(fit.fitted.a_bar(x) / a - 1, 2);
    if (x < fit.compared_from || x > fit.compared_to) continue;
    const auto point = law.at(x);
    const double F_bar = p->force_N / (std::numbers::pi * R * R * curve.sigma_ref_Pa);
    add(fit.hardness, point.H / (F_bar / (a * a)));
    add(fit.radius, point.a / a);
    add(fit.fitted_radius, fit.fitted.a_bar(x) / a);
    add(fit.force, point.F / F_bar);
    ++compared;
  }
  fit.compared = compared;
  fit.radius_rms = std::sqrt(squares / static_cast<double>(rows.size()));
  for (Deviation* deviation : {&fit.hardness, &fit.radius, &fit.force, &fit.fitted_radius})
    if (compared) deviation->rms = std::sqrt(deviation->rms / static_cast<double>(compared));
  return fit;
}

LawCard law_card(const press::Curve& curve, const AgarwalFit& fit, std::string_view curve_text) {
  if (fit.compared == 0)
    throw core::InvalidInput(
        fmt::format("the curve has no rows with delta_bar from {:.4g} to {:.4g}, so a card of "
                    "agarwal could say no errors",
                    fit.compared_from, fit.compared_to));
  LawCard card;
  card.law = "agarwal";
  card.variant = "published";
  const auto put = [&](const char* key, double value) { card.parameters[key] = core::number_text(value); };
  put("E_Pa", curve.E_Pa);
  put("nu", curve.nu);
  put("sigma_y_Pa", curve.sigma_ref_Pa);
  card.parameters["loading"] = curve.experiment;
  card.delta_bar = {fit.compared_from, fit.compared_to};
  card.errors = {{"hardness_largest", fit.hardness.largest}, {"hardness_rms", fit.hardness.rms},
                 {"radius_largest", fit.radius.largest},     {"radius_rms", fit.radius.rms},
                 {"force_largest", fit.force.largest},       {"force_rms", fit.force.rms}};
  card.provenance = {
      {"material", curve.material}, {"curve_sha256", core::sha256(curve_text)}, {"engine", curve.engine}};
  return card;
}

} // namespace platen::fit
