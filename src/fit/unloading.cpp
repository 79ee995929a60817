#include "fit/unloading.hpp"

#include "core/error.hpp"
#include "fit/golden.hpp"
#include "fit/samples.hpp"
#include "fit/solve.hpp"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace platen::fit {

namespace {

constexpr double alpha_least = 1, alpha_most = 10; ///< what the law accepts
constexpr std::size_t fewest_forces = 4;           ///< points with a force, the turning point included

/// (13) at one overlap.
template <class Real> Real law_13(double x, double x_max, double F_max, const Real& x_0, const Real& alpha) {
  using std::pow;
  if (!(x_0 < x)) return Real(0);
  return F_max * pow((x - x_0) / (x_max - x_0), alpha);
}

struct Residuals {
  const Samples& samples;

  template <class Real> bool operator()(const Real* x_0, const Real* alpha, Real* residual) const {
    const double x_max = samples.delta_bar.back(), F_max = samples.F_bar.back();
    for (std::size_t i = 0; i < samples.size(); ++i)
      residual[i] = std::sqrt(samples.weight[i]) *
                    (law_13(samples.delta_bar[i], x_max, F_max, *x_0, *alpha) - samples.F_bar[i]) / F_max;
    return true;
  }
};

struct Found {
  double x_0 = 0, alpha = 1.5, cost = INFINITY;
};

double cost(const Samples& samples, double x_0, double alpha) {
  const double x_max = samples.delta_bar.back(), F_max = samples.F_bar.back();
  double squares = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double residual = law_13(samples.delta_bar[i], x_max, F_max, x_0, alpha) - samples.F_bar[i];
    squares += samples.weight[i] * residual * residual;
  }
  return squares / (2 * F_max * F_max);
}

Found polished(const Samples& samples, Found start, double x_0_most) {
  ceres::Problem problem;
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residuals, ceres::DYNAMIC, 1, 1>(
                               new Residuals{samples}, static_cast<int>(samples.size())),
                           nullptr, &start.x_0, &start.alpha);
  problem.SetParameterLowerBound(&start.x_0, 0, 0);
  problem.SetParameterUpperBound(&start.x_0, 0, x_0_most);
  problem.SetParameterLowerBound(&start.alpha, 0, alpha_least);
  problem.SetParameterUpperBound(&start.alpha, 0, alpha_most);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.gradient_tolerance = 1e-16;
  const auto summary = solve(problem, options);
  start.cost = summary.IsSolutionUsable() ? summary.final_cost : INFINITY;
  return start;
}

/// alpha is minimised for each delta_0, delta_0 is scanned and refined, then both are polished: the error has
/// a valley along which the two trade, and for alpha near 1 a kink in delta_0 at every sample.
Found minimum(const Samples& samples) {
  constexpr int cells = 32, refinements = 30;
  const std::array<double, 9> exponents = {1, 1.15, 1.35, 1.6, 2, 2.5, 3.5, 5, alpha_most};
  double x_0_most = samples.delta_bar.front(); // no further than where half the force is left
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples.F_bar[i] < 0.5 * samples.F_bar.back()) x_0_most = std::max(x_0_most, samples.delta_bar[i]);
  const auto best_alpha = [&](double x_0) {
    return scanned_minimum([&](double alpha) { return cost(samples, x_0, alpha); }, exponents, refinements);
  };
  std::vector<double> separations;
  for (int i = 0; i <= cells; ++i) separations.push_back(x_0_most * i / cells);
  const Minimum best =
      scanned_minimum([&](double x_0) { return best_alpha(x_0).value; }, separations, refinements);
  const Found scanned{best.at, best_alpha(best.at).at, best.value};
  const Found found = polished(samples, scanned, x_0_most);
  return found.cost < scanned.cost ? found : scanned;
}

/// Points of one branch in their order, the turning point first: where the branch starts below the loading
/// curve, the next point of that curve is put before it.
std::vector<press::CurvePoint> with_turning_point(const press::Curve& curve,
                                                  std::vector<press::CurvePoint> branch) {
  constexpr double on_the_curve = 1e-3; // of the force; interpolation between loading points is no better
  const press::CurvePoint first = branch.front();
  const press::CurvePoint *before = nullptr,
                          *after = nullptr; // on the loading branch, around the first point
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading) continue;
    if (point.delta_bar <= first.delta_bar && (!before || point.delta_bar > before->delta_bar))
      before = &point;
    if (point.delta_bar >= first.delta_bar && (!after || point.delta_bar < after->delta_bar)) after = &point;
  }
  if (!before || !after || before->delta_bar == after->delta_bar) return branch;
  const double share = (first.delta_bar - before->delta_bar) / (after->delta_bar - before->delta_bar);
  const double F_loading = before->F_bar + share * (after->F_bar - before->F_bar);
  if (first.F_bar < (1 - on_the_curve) * F_loading) branch.insert(branch.begin(), *after);
  return branch;
}

/// Ascending, from the first point without force to the turning point.
Samples unloading_samples(const std::vector<press::CurvePoint>& branch) {
  Samples samples;
  for (std::size_t i = 0; i < branch.size(); ++i) {
    const auto& point = branch[i];
    if (!std::isfinite(point.delta_bar) || !std::isfinite(point.F_bar))
      throw core::InvalidInput(fmt::format("unloading branch {} is not finite", point.branch_id));
    if (i > 0 && !(point.delta_bar < branch[i - 1].delta_bar))
      throw core::InvalidInput(
          fmt::format("unloading branch {} does not descend in delta_bar: {:g} comes after {:g}",
                      point.branch_id, point.delta_bar, branch[i - 1].delta_bar));
    samples.delta_bar.push_back(point.delta_bar);
    samples.F_bar.push_back(std::max(point.F_bar, 0.0));
    if (point.F_bar <= 0) break;
  }
  std::reverse(samples.delta_bar.begin(), samples.delta_bar.end());
  std::reverse(samples.F_bar.begin(), samples.F_bar.end());
  samples.weight = trapezoid_weights(samples.delta_bar, samples.delta_bar.front());
  return samples;
}

UnloadingFit fit_branch(const Samples& samples, int branch_id, double E_bar, double nu) {
  UnloadingFit fit;
  fit.branch_id = branch_id;
  fit.delta_bar_max = samples.delta_bar.back();
  fit.F_bar_max = samples.F_bar.back();
  const Found found = minimum(samples);
  fit.alpha = found.alpha;
  fit.delta_bar_0 = found.x_0;
  const double k_H = 4 / (3 * std::numbers::pi) * E_bar / (1 - nu * nu); // (10)
  const double delta_H = std::cbrt(std::pow(fit.F_bar_max / k_H, 2));    // (12): delta_max - delta_H0
  fit.beta = delta_H / (fit.delta_bar_max - fit.delta_bar_0);            // (11)
  fit.k = fit.F_bar_max / std::pow(fit.delta_bar_max - fit.delta_bar_0, fit.alpha); // (14)
  std::vector<double> law;
  for (const double x : samples.delta_bar) law.push_back(fit.F_bar(x));
  fit.r_squared = r_squared(samples, law);
  fit.rmse = fit.F_bar_max * std::sqrt(2 * cost(samples, found.x_0, found.alpha) /
                                       (samples.delta_bar.back() - samples.delta_bar.front()));
  fit.points = samples.size();
  return fit;
}

} // namespace

double UnloadingFit::F_bar(double delta_bar) const {
  return law_13(delta_bar, delta_bar_max, F_bar_max, delta_bar_0, alpha);
}

UnloadingFits fit_unloading(const press::Curve& curve) {
  std::map<int, std::vector<press::CurvePoint>> branches;
  for (const auto& point : curve.points)
    if (point.branch == press::Branch::unloading) branches[point.branch_id].push_back(point);
  UnloadingFits result;
  if (branches.empty()) return result;
  if (!(curve.E_Pa > 0) || !(curve.sigma_ref_Pa > 0) || !(curve.nu >= 0 && curve.nu < 0.5))
    throw core::InvalidInput(fmt::format(
        "the unloading fit compares with Hertz and needs E_Pa > 0, sigma_ref_Pa > 0 and nu in [0, 0.5); "
        "the curve says {:g}, {:g} and {:g}",
        curve.E_Pa, curve.sigma_ref_Pa, curve.nu));
  for (const auto& [branch_id, points] : branches) {
    const Samples samples = unloading_samples(with_turning_point(curve, points));
    const auto forces =
        std::count_if(samples.F_bar.begin(), samples.F_bar.end(), [](double F) { return F > 0; });
    if (forces < static_cast<std::ptrdiff_t>(fewest_forces)) {
      result.skipped.push_back(fmt::format("unloading branch {} has {} points with a force; its fit needs {}",
                                           branch_id, forces, fewest_forces));
      continue;
    }
    result.fits.push_back(fit_branch(samples, branch_id, curve.E_Pa / curve.sigma_ref_Pa, curve.nu));
  }
  std::stable_sort(result.fits.begin(), result.fits.end(), [](const auto& one, const auto& other) {
    return one.delta_bar_max < other.delta_bar_max;
  });
  return result;
}

} // namespace platen::fit
