#include "fit/wang.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "fit/golden.hpp"
#include "fit/least_squares.hpp"
#include "fit/samples.hpp"
#include "fit/unloading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace platen::fit {
namespace {

void check(const press::Curve& curve) {
  const auto need = [](bool there, std::string_view key) {
    if (!there)
      throw core::InvalidInput(
          fmt::format("the curve says no {0}, which wang needs; give --{0}, or a line '# {0} = ...'", key));
  };
  need(curve.E_Pa > 0, "E_Pa");
  need(curve.sigma_c_Pa > 0, "sigma_c_Pa");
}

/// Beyond first yield, in units of it.
Samples plastic_samples(const press::Curve& curve, WangFit& fit) {
  Samples samples;
  for (const auto& point : curve.points) {
    const double omega = point.delta_m / fit.delta_y_m;
    if (point.branch != press::Branch::loading || !(omega >= 1)) continue;
    if (samples.size() && !(omega > samples.delta_bar.back()))
      throw core::InvalidInput("the loading branch does not ascend in delta");
    samples.delta_bar.push_back(omega);
    samples.F_bar.push_back(point.force_N / fit.F_y_N);
  }
  if (samples.size() < wang_fewest_points)
    throw core::InvalidInput(
        fmt::format("the loading branch has {} points beyond first yield, F_y = {:.4g} N; a fit of wang "
                    "needs at least {}",
                    samples.size(), fit.F_y_N, wang_fewest_points));
  fit.points = samples.size();
  if (samples.size() == wang_fewest_points) { // as many as parameters: first yield itself is the third
    samples.delta_bar.insert(samples.delta_bar.begin(), 1);
    samples.F_bar.insert(samples.F_bar.begin(), 1);
  }
  samples.weight = trapezoid_weights(samples.delta_bar, samples.delta_bar.front());
  return samples;
}

double squares(const Samples& s, const std::vector<double>& law) {
  double sum = 0;
  for (std::size_t i = 0; i < s.size(); ++i) sum += s.weight[i] * std::pow(law[i] - s.F_bar[i], 2);
  return sum;
}

double rmse(const Samples& s, const std::vector<double>& law) {
  return std::sqrt(squares(s, law) / (s.delta_bar.back() - s.delta_bar.front()));
}

/// c f(omega), with c projected out.
struct Scaled {
  double c;
  std::vector<double> values;
};
Scaled scaled(const Samples& s, const std::function<double(double)>& f) {
  double ff = 0, fy = 0;
  Scaled result;
  for (std::size_t i = 0; i < s.size(); ++i) {
    result.values.push_back(f(s.delta_bar[i]));
    ff += s.weight[i] * result.values[i] * result.values[i];
    fy += s.weight[i] * result.values[i] * s.F_bar[i];
  }
  result.c = fy / ff;
  for (double& value : result.values) value *= result.c;
  return result;
}

/// The exponent, or rate, for which c f(omega, x) is nearest.
template <class Form> double nearest(const Samples& s, const Form& form, double low, double high) {
  std::vector<double> candidates;
  for (int i = 0; i <= 32; ++i) candidates.push_back(low + (high - low) * i / 32);
  const auto error = [&](double x) {
    return squares(s, scaled(s, [&](double omega) { return form(omega, x); }).values);
  };
  return scanned_minimum(error, candidates, 60).at;
}

FormFit polynomial(const Samples& s, std::string name, int degree) {
  std::vector<std::vector<double>> powers(degree + 1);
  std::vector<double> y;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double root = std::sqrt(s.weight[i]);
    for (int k = 0; k <= degree; ++k)
      powers[k].push_back(root * std::pow(s.delta_bar[i] / s.delta_bar.back(), k));
    y.push_back(root * s.F_bar[i]);
  }
  const auto c = least_squares(powers, y);
  std::vector<double> law;
  for (const double omega : s.delta_bar) {
    double F = 0;
    for (int k = 0; k <= degree; ++k) F += c[k] * std::pow(omega / s.delta_bar.back(), k);
    law.push_back(F);
  }
  return {std::move(name), degree + 1, r_squared(s, law), rmse(s, law)};
}

FormFit exponential(const Samples& s) {
  const auto form = [&](double omega, double rate) { return std::exp(rate * omega / s.delta_bar.back()); };
  const double rate = nearest(s, form, 0, 6);
  const auto law = scaled(s, [&](double omega) { return form(omega, rate); }).values;
  return {"exponential", 2, r_squared(s, law), rmse(s, law)};
}

void fit_branches(const press::Curve& curve, WangFit& fit) {
  const UnloadingFits branches = fit_unloading(curve);
  fit.branches = branches.fits;
  fit.notes.insert(fit.notes.end(), branches.skipped.begin(), branches.skipped.end());
  const double force_unit =
      fit.F_y_N / (std::numbers::pi * curve.radius_m * curve.radius_m * curve.sigma_ref_Pa);
  const double delta_y = fit.delta_y_m / curve.radius_m;
  for (const UnloadingFit& f : branches.fits) {
    const double range = (f.delta_bar_max - f.delta_bar_0) / delta_y;
    fit.unloading.push_back({f.delta_bar_max / delta_y, f.F_bar_max / force_unit / std::pow(range, f.alpha),
                             f.alpha, f.delta_bar_0 * curve.radius_m, f.r_squared});
  }
}

/// An unloading branch from separation to its turning point, in units of first yield, force over F_max.
struct Branch {
  double F_max = 0; ///< over F_y
  Samples samples;
};

std::vector<Branch> branches_of(const press::Curve& curve, const WangFit& fit) {
  std::vector<Branch> branches;
  for (const UnloadingFit& f : fit.branches) {
    Branch branch;
    for (const auto& point : curve.points)
      if (point.branch == press::Branch::unloading && point.branch_id == f.branch_id) {
        branch.samples.delta_bar.push_back(point.delta_m / fit.delta_y_m);
        branch.samples.F_bar.push_back(std::max(point.force_N, 0.0));
      }
    Samples& s = branch.samples;
    std::reverse(s.delta_bar.begin(), s.delta_bar.end());
    std::reverse(s.F_bar.begin(), s.F_bar.end());
    const double F_max = s.F_bar.back();
    for (double& F : s.F_bar) F /= F_max;
    branch.F_max = F_max / fit.F_y_N;
    s.weight = trapezoid_weights(s.delta_bar, s.delta_bar.front());
    for (double& w : s.weight) w /= s.delta_bar.back() - s.delta_bar.front();
    branches.push_back(std::move(branch));
  }
  return branches;
}

/// (17) with (18): through the turning point, so that omega_max - omega_res = (F_max/m)^(1/n).
std::vector<double> unloading_law(const Branch& branch, double m, double n) {
  const double range = std::pow(branch.F_max / m, 1 / n);
  std::vector<double> law;
  for (const double omega : branch.samples.delta_bar)
    law.push_back(std::pow(std::max(0.0, 1 - (branch.samples.delta_bar.back() - omega) / range), n));
  return law;
}

/// One m and n for all branches: the law has no more.
void fit_branches_together(const press::Curve& curve, WangFit& fit) {
  const std::vector<Branch> branches = branches_of(curve, fit);
  if (branches.empty()) return;
  const auto error = [&](double m, double n) {
    double sum = 0;
    for (const Branch& branch : branches) sum += squares(branch.samples, unloading_law(branch, m, n));
    return sum;
  };
  std::vector<double> exponents, logarithms;
  for (int i = 0; i <= 16; ++i) exponents.push_back(1 + 1.5 * i / 16);
  for (int i = 0; i <= 32; ++i) logarithms.push_back(std::log(0.1) + std::log(1e3) * i / 32);
  const auto best_m = [&](double n) {
    return scanned_minimum([&](double log_m) { return error(std::exp(log_m), n); }, logarithms, 40);
  };
  fit.n = scanned_minimum([&](double n) { return best_m(n).value; }, exponents, 40).at;
  fit.m = std::exp(best_m(fit.n).at);
  double spread = 0;
  for (const Branch& branch : branches) {
    double mean = 0;
    for (std::size_t i = 0; i < branch.samples.size(); ++i)
      mean += branch.samples.weight[i] * branch.samples.F_bar[i];
    for (std::size_t i = 0; i < branch.samples.size(); ++i)
      spread += branch.samples.weight[i] * std::pow(branch.samples.F_bar[i] - mean, 2);
  }
  fit.unloading_r_squared = 1 - error(fit.m, fit.n) / spread;
}

} // namespace

press::Curve hertz_consistent(const press::Curve& curve) {
  press::Curve shifted = curve;
  const double nu = curve.nu, R = curve.radius_m; // Tatara's far field for a small contact
  const double far_field = ((1 + nu) / 4 + (1 - nu * nu) / 2) / (std::numbers::pi * curve.E_Pa * R);
  for (auto& point : shifted.points) {
    point.delta_m = point.hertz_delta_m > 0 ? point.hertz_delta_m : point.delta_m + point.force_N * far_field;
    point.delta_bar = point.delta_m / R;
  }
  return shifted;
}

double WangFit::F_over_F_y(double omega) const {
  return omega < 1 ? std::pow(omega, 1.5) : a * std::pow(omega, b);
}

std::size_t points_beyond(const press::Curve& curve, const FirstYield& yield) {
  const press::Curve shifted = hertz_consistent(curve);
  return static_cast<std::size_t>(std::ranges::count_if(shifted.points, [&](const auto& point) {
    return point.branch == press::Branch::loading && point.delta_m >= yield.delta_m;
  }));
}

WangFit fit_wang(const press::Curve& pressed) {
  check(pressed);
  const press::Curve curve = hertz_consistent(pressed);
  WangFit fit;
  const FirstYield yield = first_yield(curve.E_Pa, curve.nu, curve.phi_deg, curve.sigma_c_Pa, curve.radius_m);
  fit.F_y_N = yield.F_N;
  fit.delta_y_m = yield.delta_m;

  const Samples samples = plastic_samples(curve, fit);
  const auto power = [](double omega, double b) { return std::pow(omega, b); };
  fit.b = nearest(samples, power, 1, 3);
  const Scaled law = scaled(samples, [&](double omega) { return power(omega, fit.b); });
  fit.a = law.c;
  fit.r_squared = r_squared(samples, law.values);
  fit.rmse = rmse(samples, law.values);
  fit.omega_max = samples.delta_bar.back();
  if (fit.points < wang_enough_points) {
    fit.caveat = fmt::format(
        "{} points of the loading lie beyond first yield, F_y = {:.4g} N, and the last at {:.3g} F_y: "
        "a and b say what is between{}, and little of what follows",
        fit.points, yield.F_N, samples.F_bar.back(),
        fit.points < samples.size() ? " (first yield itself is the third)" : "");
    fit.notes.push_back(fit.caveat);
  }
  fit.others = {exponential(samples)};
  if (samples.size() > 3) fit.others.push_back(polynomial(samples, "parabola", 2));
  if (samples.size() > 4) fit.others.push_back(polynomial(samples, "cubic", 3));
  fit_branches(curve, fit);
  fit_branches_together(curve, fit);
  return fit;
}

LawCard law_card(const press::Curve& curve, const WangFit& fit, std::string_view curve_text) {
  LawCard card;
  card.law = "wang";
  card.variant = fit.unloading.empty() ? "generic" : "fitted";
  const auto put = [&](const char* key, double value) { card.parameters[key] = core::number_text(value); };
  put("E_Pa", curve.E_Pa);
  put("nu", curve.nu);
  put("phi_deg", curve.phi_deg);
  put("sigma_c_Pa", curve.sigma_c_Pa);
  put("a", fit.a);
  put("b", fit.b);
  card.errors = {{"R2", fit.r_squared}, {"rmse_over_F_y", fit.rmse}};
  if (!fit.unloading.empty()) {
    put("m", fit.m);
    put("n", fit.n);
    card.errors.emplace_back("unload_R2", fit.unloading_r_squared);
  }
  const double delta_y_bar = fit.delta_y_m / curve.radius_m;
  card.delta_bar = {delta_y_bar, fit.omega_max * delta_y_bar};
  card.provenance = {{"material", curve.material},
                     {"approach", std::string("Hertz-consistent, far field of the sphere taken out")},
                     {"curve_sha256", core::sha256(curve_text)},
                     {"engine", curve.engine}};
  if (!fit.caveat.empty()) card.provenance.emplace_back("caveat", fit.caveat);
  return card;
}

} // namespace platen::fit
