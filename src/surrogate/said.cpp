#include "surrogate/said.hpp"

#include "fit/samples.hpp"
#include "surrogate/ripples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::surrogate {
namespace {

double relative_l2(const std::vector<double>& x, const std::vector<double>& truth,
                   const std::vector<double>& said) {
  return fit::errors({x, truth, fit::trapezoid_weights(x, 0)}, said).relative_l2;
}

/// Of the unloading (9)-(14) of Edmans & Sinka, one side: overlap given back, and work over pi R0^3
/// sigma_ref.
struct Unloading {
  double returned, work;
};
Unloading unloading(double F_bar, double alpha, double beta, double delta_bar, const Description& d) {
  const double returned = std::min(hertz_overlap(F_bar, d) / beta, delta_bar);
  return {returned, F_bar * returned / (alpha + 1)};
}

} // namespace

void add(std::vector<double>& sum, const std::vector<double>& more, double factor) {
  if (sum.empty()) sum.resize(more.size());
  for (std::size_t j = 0; j < more.size(); ++j) sum[j] += factor * more[j];
}

double scatter_of(const std::vector<double>& knots, const std::vector<double>& ln_F) {
  const std::size_t from = knot_of(knots, 0.3);
  if (from == knots.size()) return 1;
  const double growth = std::exp(ln_F.back() - ln_F[from]);
  return std::clamp(std::pow(growth / 1.6, 1.5), 1.0, 8.0);
}

double hertz_overlap(double F_bar, const Description& d) {
  return std::pow(0.75 * std::numbers::pi * F_bar / d.E_flat, 2.0 / 3);
}

std::vector<double> over_force(std::vector<double> returned, const std::vector<double>& unload_delta_bar,
                               const std::vector<double>& knots, const std::vector<double>& ln_F) {
  for (std::size_t b = 0; b < returned.size(); ++b)
    returned[b] -= 5.0 / 3 * at_overlap(unload_delta_bar[b], knots, ln_F);
  return returned;
}

double at_overlap(double delta_bar, const std::vector<double>& knots, const std::vector<double>& values) {
  const std::size_t i = std::min(knot_of(knots, delta_bar), knots.size() - 1);
  if (i == 0 || knots[i] <= delta_bar + 1e-9) return values[i];
  const double part = std::log(knots[i] / delta_bar) / std::log(knots[i] / knots[i - 1]);
  return values[i] + part * (values[i - 1] - values[i]);
}

std::size_t knot_of(const std::vector<double>& knots, double delta_bar) {
  return static_cast<std::size_t>(std::lower_bound(knots.begin(), knots.end(), delta_bar - 1e-9) -
                                  knots.begin());
}

AlphaBeta alpha_beta(const std::vector<double>& work, const std::vector<double>& exponent) {
  AlphaBeta both;
  for (std::size_t b = 0; b < work.size(); ++b) {
    both.alpha.push_back(std::exp(exponent[b]));
    both.beta.push_back(std::exp(-work[b]) / (1 + both.alpha[b]));
  }
  return both;
}

std::vector<double> logarithms(std::vector<double> values) {
  for (double& value : values) value = std::log(value);
  return values;
}

std::vector<double> exponentials(const std::vector<double>& values, std::size_t from, std::size_t count) {
  std::vector<double> result;
  for (std::size_t i = from; i < from + count; ++i) result.push_back(std::exp(values[i]));
  return result;
}

Said said_at(const Surrogate& s, const std::vector<double>& at, const CoarsePress* guide, Want want) {
  Said said;
  if (guide) {
    said.F = without_ripples(s.knots, logarithms(guide->F_bar));
    said.a = without_ripples(s.knots, logarithms(guide->a_bar));
    said.work = over_force(guide->returned, s.unload_delta_bar, s.knots, said.F);
    said.exponent = logarithms(guide->alpha);
  }
  const bool loaded = guide, unloaded = !said.work.empty();
  for (std::size_t l = 0; l < s.layers.size(); ++l) {
    const Layer& layer = s.layers[l];
    if (l > 0) said.scatter = scatter_of(s.knots, said.F);
    if (l > 0 || !loaded) {
      add(said.F, values_at(layer.force, layer.columns, at), said.scatter);
      if (want != Want::force_and_work) add(said.a, values_at(layer.radius, layer.columns, at));
      if (want == Want::variances)
        add(said.F_variance, variances_at(layer.force, layer.columns, at), said.scatter * said.scatter);
    }
    if (l > 0 || !unloaded) {
      add(said.work, values_at(layer.work, layer.columns, at), said.scatter);
      if (want != Want::force_and_work) add(said.exponent, values_at(layer.exponent, layer.columns, at));
    }
  }
  return said;
}

Said said_of(const Surrogate& s, const Description& d, const CoarsePress* guide) {
  return said_at(s, input_of(s, d.coordinates), guide, Want::variances);
}

Errors errors_of(const PoolData& data, const Pressed& run, const Said& said) {
  Errors e;
  const auto F_bar = exponentials(said.F, 0, said.F.size());
  e.force = relative_l2(data.knots, run.F_bar, F_bar);
  e.radius = relative_l2(data.knots, run.a_bar, exponentials(said.a, 0, said.a.size()));
  e.expected = expected_errors(data.knots, F_bar, said.F_variance).back();
  for (std::size_t j = 0; j < F_bar.size(); ++j)
    e.standardised.push_back(std::abs(said.F[j] - std::log(run.F_bar[j])) / std::sqrt(said.F_variance[j]));
  e.locks = grows(locked_growth, data.knots, F_bar);
  const std::size_t branches = data.unload_delta_bar.size();
  const auto [alpha, beta] = alpha_beta(said.work, said.exponent);
  for (std::size_t b = 0; b < branches; ++b) {
    const double at = data.unload_delta_bar[b];
    const double F = std::exp(at_overlap(at, data.knots, said.F));
    const auto back = unloading(F, alpha[b], beta[b], at, run.description);
    e.work.push_back(std::abs(back.work / work_along(run.branches[b]) - 1));
    e.residual.push_back(std::abs(at - back.returned - run.residual[b]) / at);
  }
  return e;
}

std::vector<double> expected_errors(const std::vector<double>& x, const std::vector<double>& F,
                                    const std::vector<double>& variance) {
  std::vector<double> errors;
  double squares = 0, all = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const auto add = [&](std::size_t i, double weight) {
      squares += weight * F[i] * F[i] * variance[i];
      all += weight * F[i] * F[i];
    };
    const double step = x[j] - (j > 0 ? x[j - 1] : 0);
    add(j, step / 2);
    if (j > 0) add(j - 1, step / 2);
    errors.push_back(std::sqrt(squares / all));
  }
  return errors;
}

} // namespace platen::surrogate
