#include "fe/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace platen::fe {
namespace {

/// The residual may grow while zones and contacts settle, but not beyond this.
constexpr double diverged = 1e3;
/// Line search: the share of the work of the residual that a correction may leave, and how often it is
/// shortened.
constexpr double slope_left = 0.5;
constexpr int searches_max = 3;

double work(const std::vector<double>& correction, std::span<const double> force) {
  double sum = 0;
  for (std::size_t i = 0; i < correction.size(); ++i) sum += correction[i] * force[i];
  return sum;
}

} // namespace

double relative_residual(const material::Model& model, const NewtonSettings& settings, double free_square,
                         double reaction_square) {
  const double rounding = 20 * std::numeric_limits<double>::epsilon() * material::initial_E(model);
  const double least = rounding / settings.relative_residual_tolerance;
  return std::sqrt(free_square / std::max(reaction_square, least * least));
}

StepReport newton(Equilibrium& system, const NewtonSettings& settings, std::vector<double>& x) {
  StepReport report;
  const auto give_up = [&](const char* why) {
    report.why = why;
    return report;
  };
  std::vector<material::Zone> zones(system.updates().size());
  std::vector<char> touched;
  std::vector<double> correction(x.size());
  Equilibrium::Residual residual;
  double slope_0 = 0; // work of the residual on the correction, before it
  for (;; ++report.iterations) {
    Evaluation evaluation = system.evaluate(x, residual);
    double fraction = 1;
    for (int search = 0; report.iterations > 0 && search < searches_max; ++search) {
      const bool failed = evaluation != Evaluation::done;
      const double slope = failed ? 0 : -work(correction, residual.force);
      if (!failed && (std::abs(slope) <= slope_left * std::abs(slope_0) || slope > 0)) break;
      const double next = fraction * (failed ? 0.5 : std::clamp(slope_0 / (slope_0 - slope), 0.2, 0.8));
      for (std::size_t i = 0; i < x.size(); ++i) x[i] += (next - fraction) * correction[i];
      fraction = next;
      evaluation = system.evaluate(x, residual);
    }
    if (evaluation == Evaluation::inverted_element) return give_up("an element turned inside out");
    if (evaluation == Evaluation::refused_material) return give_up("the material found no admissible state");

    const auto updates = system.updates();
    for (std::size_t i = 0; i < updates.size(); ++i) {
      report.zone_changed |= report.iterations > 0 && zones[i] != updates[i].zone;
      zones[i] = updates[i].zone;
    }
    report.contact_changed |= report.iterations > 0 && residual.touching != touched;
    touched = residual.touching;
    report.residuals.push_back(residual.relative);
    if (residual.relative <= settings.relative_residual_tolerance) break;
    if (residual.relative > diverged && report.iterations > 3) return give_up("the iteration diverged");
    if (report.iterations == settings.iterations_max) return give_up("the iteration did not converge");

    if (!system.linearise(residual)) return give_up("the tangent is singular");
    for (std::size_t i = 0; i < correction.size(); ++i) correction[i] = -residual.force[i];
    if (!system.solve_linear(correction)) return give_up("the tangent is singular");
    slope_0 = -work(correction, residual.force);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
  }
  report.converged = true;
  return report;
}

} // namespace platen::fe
