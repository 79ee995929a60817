#include "measure/machine.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace platen::measure {
namespace {

constexpr int knots = 12;

struct Line {
  double slope = 0, intercept = 0, worst = 0; ///< worst mean deviation of a tenth of the rows
};

/// Travel over force by least squares.
Line line_through(const std::vector<double>& F, const std::vector<double>& x) {
  const double n = static_cast<double>(F.size());
  const double mF = std::accumulate(F.begin(), F.end(), 0.0) / n,
               mx = std::accumulate(x.begin(), x.end(), 0.0) / n;
  double sFF = 0, sFx = 0;
  for (std::size_t i = 0; i < F.size(); ++i)
    sFF += (F[i] - mF) * (F[i] - mF), sFx += (F[i] - mF) * (x[i] - mx);
  Line line;
  line.slope = sFx / sFF;
  line.intercept = mx - line.slope * mF;
  for (std::size_t tenth = 0; tenth < 10; ++tenth) {
    double sum = 0;
    const std::size_t from = F.size() * tenth / 10, to = F.size() * (tenth + 1) / 10;
    for (std::size_t i = from; i < to; ++i) sum += x[i] - line.intercept - line.slope * F[i];
    line.worst =
        std::max(line.worst, std::abs(sum / static_cast<double>(std::max<std::size_t>(to - from, 1))));
  }
  return line;
}

} // namespace

double Machine::travel(double force) const {
  if (force_N.size() < 2) return compliance_m_per_N * force;
  const auto above = std::upper_bound(force_N.begin() + 1, force_N.end() - 1, force);
  const auto k = static_cast<std::size_t>(above - force_N.begin());
  return travel_m[k - 1] + slope(force) * (force - force_N[k - 1]);
}

double Machine::slope(double force) const {
  if (force_N.size() < 2) return compliance_m_per_N;
  const auto above = std::upper_bound(force_N.begin() + 1, force_N.end() - 1, force);
  const auto k = static_cast<std::size_t>(above - force_N.begin());
  return (travel_m[k] - travel_m[k - 1]) / (force_N[k] - force_N[k - 1]);
}

Machine empty_machine(const Measurement& m) {
  if (m.specimens.size() != 1)
    throw core::InvalidInput(
        fmt::format("{}: {} particles; the empty machine is one curve", m.file, m.specimens.size()));
  const auto& s = m.specimens.front();
  const auto [least, most] = std::ranges::minmax(s.force_N);
  // Rows before the platens touch say nothing of the machine.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < s.force_N.size(); ++i)
    if (s.force_N[i] > 0.02 * most) order.push_back(i);
  if (order.size() < 10 || !(most > 0))
    throw core::InvalidInput(fmt::format("{}: the force does not grow; is this the empty machine?", m.file));
  std::ranges::sort(order, {}, [&](std::size_t i) { return s.travel_m[i]; });
  std::vector<double> F, x;
  for (auto i : order) F.push_back(s.force_N[i]), x.push_back(s.travel_m[i]);
  const Line line = line_through(F, x);
  if (!(line.slope > 0))
    throw core::InvalidInput(
        fmt::format("{}: the travel does not grow with the force; is this the empty machine?", m.file));
  Machine machine;
  machine.compliance_m_per_N = line.slope;
  const double range = line.slope * (most - std::max(0.0, least));
  machine.said = fmt::format("empty machine {}: {:.4g} um/N, straight within {:.2g} % of {:.3g} um", m.file,
                             line.slope * 1e6, 100 * line.worst / range, range * 1e6);
  if (line.worst < 0.01 * range) return machine;
  // It bends: means of equal counts of rows, from the touch of the platens on.
  for (int k = 0; k < knots; ++k) {
    const std::size_t from = F.size() * static_cast<std::size_t>(k) / knots,
                      to = F.size() * static_cast<std::size_t>(k + 1) / knots;
    const double n = static_cast<double>(to - from);
    const double mF =
        std::accumulate(F.begin() + static_cast<long>(from), F.begin() + static_cast<long>(to), 0.0) / n;
    const double mx =
        std::accumulate(x.begin() + static_cast<long>(from), x.begin() + static_cast<long>(to), 0.0) / n;
    if (machine.force_N.empty() || mF > machine.force_N.back()) {
      machine.force_N.push_back(mF);
      machine.travel_m.push_back(mx);
    }
  }
  const double at_zero = machine.travel(0);
  for (double& v : machine.travel_m) v -= at_zero;
  machine.said =
      fmt::format("empty machine {}: it bends, {:.4g} um/N at little force and {:.4g} um/N at {:.3g} N; "
                  "taken by {} points",
                  m.file, machine.slope(0) * 1e6, machine.slope(most) * 1e6, most, machine.force_N.size());
  return machine;
}

Machine machine_of(std::optional<double> compliance, const std::string& file, const ReadOptions& options) {
  if (compliance) {
    if (!(*compliance >= 0) || !std::isfinite(*compliance))
      throw core::InvalidInput(
          fmt::format("--compliance_m_per_N {}: it must be a number >= 0", core::number_text(*compliance)));
    return {*compliance, {}, {}, fmt::format("compliance given, {:.4g} um/N", *compliance * 1e6)};
  }
  return file.empty() ? Machine{} : empty_machine(read_measurement(file, options));
}

} // namespace platen::measure
