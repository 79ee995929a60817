#include "measure/as_measured.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace platen::measure {
namespace {

using press::Branch;

/// F_bar over delta/R0, ascending, linear between; 0 before the first point of a branch that separates.
struct Line {
  std::vector<double> x, F;

  double at(double where) const {
    if (where <= x.front()) return 0;
    if (where >= x.back()) return F.back();
    const auto i = static_cast<std::size_t>(std::ranges::upper_bound(x, where) - x.begin());
    return F[i - 1] + (F[i] - F[i - 1]) * (where - x[i - 1]) / (x[i] - x[i - 1]);
  }
};

Line line_of(const press::Curve& curve, Branch branch, int id) {
  std::vector<std::pair<double, double>> points;
  for (const auto& p : curve.points)
    if (p.branch == branch && p.branch_id == id) points.emplace_back(p.delta_bar, p.F_bar);
  if (branch == Branch::loading) points.emplace_back(0, 0);
  std::ranges::sort(points);
  Line line;
  for (const auto& [x, F] : points)
    if (line.x.empty() || x > line.x.back()) line.x.push_back(x), line.F.push_back(F);
  return line;
}

/// Those that unload, by where they turn.
std::vector<Line> unloadings(const press::Curve& curve) {
  std::vector<int> ids;
  for (const auto& p : curve.points)
    if (p.branch == Branch::unloading && std::ranges::find(ids, p.branch_id) == ids.end())
      ids.push_back(p.branch_id);
  std::vector<Line> lines;
  for (const int id : ids)
    if (auto line = line_of(curve, Branch::unloading, id); line.x.size() > 2)
      lines.push_back(std::move(line));
  std::ranges::sort(lines, {}, [](const Line& l) { return l.x.back(); });
  return lines;
}

} // namespace

Test test_of(const press::Curve& curve, double diameter_m, double gap_m, int rows) {
  const Line loading = line_of(curve, Branch::loading, 0);
  if (loading.x.size() < 3) throw core::InvalidInput("this curve has no loading to be measured");
  const double R = diameter_m / 2, to_end = loading.x.back(), step = to_end / rows;
  const double to_N = std::numbers::pi * R * R * curve.sigma_ref_Pa;
  Test test;
  double here = -gap_m / 2 / R;
  const auto row = [&](double x, const Line& line) {
    test.delta_m.push_back(x * R), test.force_N.push_back(to_N * line.at(x));
    here = x;
  };
  const auto go = [&](double to, double by, const Line& line) {
    for (double x = here; std::abs(to - x) > 1.5 * by;) row(x += to > x ? by : -by, line);
    row(to, line);
  };
  row(here, loading);
  bool ended = false;
  for (const Line& back : unloadings(curve)) {
    constexpr int of_a_way_back = 20;
    const double turn = back.x.back(), way = turn - back.x.front(), by = way / of_a_way_back;
    go(turn, step, loading);
    if (turn < to_end - 1e-9) {
      go(turn - way / 2, by, back);
      go(turn, by, back);
    } else {
      go(back.x.front() - way / 4, by, back);
      ended = true;
    }
  }
  if (!ended) go(to_end, step, loading);
  return test;
}

Specimen as_measured(const Test& test, double diameter_m, const Instrument& instrument,
                     std::mt19937_64& random) {
  Specimen s;
  s.diameter_m = diameter_m;
  s.travel_unit = {"um", Quantity::displacement, 1e-6};
  s.force_unit = {"N", Quantity::force, 1};
  std::normal_distribution<double> noise(0, 1);
  const double scatter = instrument.noise * *std::ranges::max_element(test.force_N);
  for (std::size_t i = 0; i < test.delta_m.size(); ++i) {
    const double F = test.force_N[i];
    s.travel_m.push_back(instrument.gap_m + 2 * test.delta_m[i] + instrument.compliance_m_per_N * F);
    s.force_N.push_back(F + instrument.zero_N + (scatter > 0 ? scatter * noise(random) : 0));
    s.time_s.push_back(instrument.row_s * static_cast<double>(i));
    s.line.push_back(static_cast<int>(i) + 2);
  }
  return s;
}

std::vector<Specimen> batch(const press::Curve& curve, int particles, double diameter_m,
                            const Instrument& instrument, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(0.6, 1.4), gap(0.5, 1.5);
  std::vector<Specimen> all;
  for (int p = 1; p <= particles; ++p) {
    Instrument own = instrument;
    double diameter = diameter_m;
    if (particles > 1) diameter *= size(random), own.gap_m *= gap(random);
    all.push_back(as_measured(test_of(curve, diameter, own.gap_m), diameter, own, random));
    all.back().name = fmt::format("{}", p);
  }
  return all;
}

std::string raw_text(const std::vector<Specimen>& specimens) {
  std::string text = "particle,diameter_mm,time_s,travel_um,force_N\n";
  for (const auto& s : specimens)
    for (std::size_t i = 0; i < s.force_N.size(); ++i)
      text += fmt::format("{},{:.6g},{:.6g},{:.7g},{:.6g}\n", s.name, *s.diameter_m * 1e3, s.time_s[i],
                          s.travel_m[i] * 1e6, s.force_N[i]);
  return text;
}

} // namespace platen::measure
