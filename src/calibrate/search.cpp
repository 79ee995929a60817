#include "calibrate/search.hpp"

#include "calibrate/problem.hpp"
#include "core/error.hpp"

#include <Eigen/Dense>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace platen::calibrate {
namespace {

using Numbers = std::vector<double>;

/// Every combination of starts, cheapest deviations first.
std::vector<Numbers> starts(Workshop& workshop, const Samples& s) {
  const Task& task = workshop.task();
  const Coordinates c{task};
  std::vector<Numbers> grid = {{}};
  for (std::size_t k = 0; k < task.free.size(); ++k) {
    std::vector<Numbers> longer;
    for (const auto& begun : grid)
      for (double start : task.free[k].starts) {
        longer.push_back(begun);
        longer.back().push_back(c.inside(k, start * c.unit(k)));
      }
    grid = std::move(longer);
  }
  std::vector<std::pair<double, std::size_t>> order;
  Numbers force;
  for (std::size_t g = 0; g < grid.size(); ++g) {
    if (!workshop.predicted(s, grid[g].data(), s.contact_guess_m, force)) continue;
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      sum += std::pow((s.force_N[i] - force[i]) / s.sigma_N[i], 2);
    order.emplace_back(sum, g);
  }
  std::ranges::sort(order);
  std::vector<Numbers> best;
  constexpr std::size_t tried = 3;
  for (const auto& [sum, g] : order)
    if (best.size() < tried) best.push_back(grid[g]);
  if (best.empty())
    throw core::InvalidInput(fmt::format(
        "the law has no material near these readings; are force, displacement and radius in the "
        "right units?{}",
        task.astray ? " Or the pools do not reach there: --press calibrates through presses" : ""));
  return best;
}

/// From the stiffness of a first fit.
void weigh(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  Numbers force, stiffness;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    const double contact = s.contact_guess_m + state.contact[p] * s.radius_m;
    if (!workshop.predicted(s, state.theta.data(), contact, force, &stiffness)) continue;
    const double floor = std::max(s.force_noise_N, 1e-4 * s.force_max_N);
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double k = s.per_travel * stiffness[i];
      s.sigma_N[i] = std::hypot(floor, k * s.travel_noise_m / (1 + k * s.compliance[i]));
    }
  }
}

/// Which rows are out of contact a first fit tells: those where the law has no force.
void find_apart(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  Numbers force;
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    if (!workshop.predicted(s, state.theta.data(), s.contact_guess_m + state.contact[p] * s.radius_m, force))
      continue;
    // Not where the machine does measure force: a poor first fit may think so.
    const auto apart = [&](std::size_t i) { return !(force[i] > 0) && s.force_N[i] < 0.1 * s.force_max_N; };
    s.apart_before = s.apart_after = 0;
    while (s.apart_before < force.size() && apart(s.apart_before)) ++s.apart_before;
    while (s.apart_after + s.apart_before < force.size() && apart(force.size() - 1 - s.apart_after))
      ++s.apart_after;
  }
}

/// Particles of one batch fit the law more or less well; each counts by how well it does.
void level(Workshop& workshop, std::vector<Samples>& samples, const State& state) {
  for (std::size_t p = 0; p < samples.size(); ++p) {
    auto& s = samples[p];
    Numbers force;
    if (!workshop.predicted(s, state.theta.data(), s.contact_guess_m + state.contact[p] * s.radius_m, force))
      continue;
    double sum = 0;
    for (std::size_t i = 0; i < force.size(); ++i)
      sum += std::pow(
          (s.force_N[i] - (state.zero[p][0] + state.zero[p][1] * s.progress[i]) * s.force_max_N - force[i]) /
              s.sigma_N[i],
          2);
    const double rms = std::sqrt(sum / static_cast<double>(force.size()));
    for (double& sigma : s.sigma_N) sigma *= std::max(rms, 1e-6);
  }
}

} // namespace

Solution search(const Task& task, std::vector<Samples> samples, const Numbers& given_start) {
  const std::size_t n = samples.size(), free = task.free.size();
  const Coordinates c{task};
  Workshop workshop(task);
  State state;
  const auto try_from = [&](const std::vector<Numbers>& begins) {
    for (const auto& begin : begins) {
      State found =
          Problem(workshop, samples, {begin, Numbers(n, 0.0), std::vector<std::array<double, 2>>(n, {0, 0})})
              .solve();
      if (found.cost < state.cost) state = std::move(found);
    }
  };
  std::size_t rows = 0;
  for (const auto& s : samples) rows += s.force_N.size();
  if (!given_start.empty()) {
    Numbers begin;
    for (std::size_t k = 0; k < free; ++k) begin.push_back(c.inside(k, given_start[k]));
    try_from({begin});
  }
  // A start that was given may lead into a minimum of its own: more than the noise is left then.
  constexpr double much = 1.5;
  if (given_start.empty() || !(2 * state.cost < much * static_cast<double>(rows)))
    try_from(starts(workshop, samples.front()));
  if (state.theta.empty())
    throw core::ConvergenceError("the law could not be fitted to these rows", 0, 100, 1);
  for (int again = 0; again < 2; ++again) {
    weigh(workshop, samples, state);
    find_apart(workshop, samples, state);
    if (n > 1) level(workshop, samples, state);
    state = Problem(workshop, samples, state).solve();
  }
  if (!std::isfinite(state.cost))
    throw core::ConvergenceError("the law could not be fitted to these rows", 0, 100, 1);

  for (std::size_t p = 0; p < n; ++p) { // what was fitted once and is not shown after all
    if (zero_parameters(samples[p]) < 2) state.zero[p][1] = 0;
    if (zero_parameters(samples[p]) < 1) state.zero[p][0] = 0;
  }
  return solution_of(workshop, std::move(samples), std::move(state));
}

Solution search_on(const Task& task, const Solution& before, State from) {
  Workshop workshop(task);
  State state = Problem(workshop, before.samples, std::move(from)).solve();
  return solution_of(workshop, before.samples, std::move(state));
}

} // namespace platen::calibrate
