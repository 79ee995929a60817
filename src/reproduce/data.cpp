#include "reproduce/data.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "press/curve_csv.hpp"
#include "study/grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace platen::reproduce {

namespace fs = std::filesystem;

namespace {

double within(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (x.size() < 2 || at < x.front() || at > x.back() * (1 + 1e-9))
    return std::numeric_limits<double>::quiet_NaN();
  return study::interpolate(x, y, std::min(at, x.back()));
}

const core::Csv::Row& row_of(const core::Csv& csv, int run) {
  return csv.rows.at(static_cast<std::size_t>(run - 1));
}

Pool read_pool(const fs::path& folder, const std::string& name) {
  Pool pool{name, "", core::read_csv(folder / "runs.csv"), {}};
  pool.engine = pool.runs.note("engine");
  const core::Csv curves = core::read_csv(folder / "curves.csv");
  const auto run = curves.column("run"), branch = curves.column("branch_id"), x = curves.column("delta_bar"),
             F = curves.column("F_bar"), a = curves.column("a_bar");
  const bool sides = curves.has_column("F_bar_x");
  for (const auto& row : curves.rows) {
    if (curves.number(row, branch) != 0) continue;
    BranchCurve& curve = pool.loading[static_cast<int>(curves.number(row, run))];
    curve.x.push_back(curves.number(row, x));
    curve.F.push_back(curves.number(row, F));
    curve.a.push_back(curves.number(row, a));
    if (!sides || row.cells[curves.column("F_bar_x")].empty()) continue;
    curve.F_side.push_back(curves.number(row, curves.column("F_bar_x")));
    curve.a_side.push_back(curves.number(row, curves.column("a_bar_x")));
  }
  return pool;
}

} // namespace

double BranchCurve::F_at(double at) const { return within(x, F, at); }
double BranchCurve::a_at(double at) const { return within(x, a, at); }
double BranchCurve::H_at(double at) const { return F_at(at) / (a_at(at) * a_at(at)); }

bool Pool::done(int run) const { return text(run, "state") == "done"; }

std::string Pool::text(int run, std::string_view column) const {
  return row_of(runs, run).cells[runs.column(column)];
}

std::optional<double> Pool::value(int run, std::string_view column) const {
  if (!runs.has_column(column)) return {};
  return core::number_from(text(run, column));
}

double Pool::number(int run, std::string_view column) const {
  return runs.number(row_of(runs, run), runs.column(column));
}

int Pool::find(const std::map<std::string, double>& values) const {
  for (int run = 1; run <= static_cast<int>(size()); ++run) {
    bool here = done(run);
    for (const auto& [column, wanted] : values)
      here = here && std::abs(value(run, column).value_or(HUGE_VAL) - wanted) <= 1e-6 * std::abs(wanted);
    if (here) return run;
  }
  std::string words;
  for (const auto& [column, wanted] : values)
    words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", column, core::number_text(wanted));
  throw core::InvalidInput(fmt::format("{}: no run with {}", runs.file, words));
}

BranchCurve loading_of(const press::Curve& curve) {
  BranchCurve result;
  for (const auto& point : curve.points) {
    if (point.branch != press::Branch::loading) continue;
    result.x.push_back(point.delta_bar);
    result.F.push_back(point.F_bar);
    result.a.push_back(point.contact_radius_m / curve.radius_m);
  }
  return result;
}

press::Curve metal_curve(const BranchCurve& branch, std::string_view experiment, double E_Pa, double nu,
                         double sigma_y_Pa) {
  press::Curve curve;
  curve.radius_m = 1;
  curve.sigma_ref_Pa = sigma_y_Pa;
  curve.E_Pa = E_Pa;
  curve.nu = nu;
  curve.experiment = experiment;
  for (std::size_t i = 0; i < branch.x.size(); ++i) {
    press::CurvePoint point;
    point.delta_bar = point.delta_m = branch.x[i];
    point.F_bar = branch.F[i];
    point.force_N = branch.F[i] * std::numbers::pi * sigma_y_Pa;
    point.contact_radius_m = branch.a[i];
    point.mean_pressure_Pa = sigma_y_Pa * branch.F[i] / (branch.a[i] * branch.a[i]);
    curve.points.push_back(point);
  }
  return curve;
}

fs::path Data::file(const std::string& below) const {
  for (const auto& folder : folders_)
    if (fs::exists(folder / below)) return folder / below;
  throw core::InvalidInput(fmt::format("no catalogue has {}", below));
}

const Pool& Data::pool(const std::string& name) const {
  if (const auto found = pools_.find(name); found != pools_.end()) return found->second;
  return pools_.emplace(name, read_pool(file("pools/" + name + "/runs.csv").parent_path(), name))
      .first->second;
}

const press::Curve& Data::press(const std::string& name) const {
  if (const auto found = presses_.find(name); found != presses_.end()) return found->second;
  return presses_.emplace(name, press::read_curve(file("papers/presses/" + name + "/curve.csv")))
      .first->second;
}

double Data::printed(std::string_view paper, std::string_view key) const {
  auto found = printed_.find(paper);
  if (found == printed_.end()) {
    const core::Csv csv = core::read_csv(file(fmt::format("papers/{}.csv", paper)));
    std::map<std::string, double> numbers;
    for (const auto& row : csv.rows)
      numbers[row.cells[csv.column("key")]] = csv.number(row, csv.column("value"));
    found = printed_.emplace(std::string(paper), std::move(numbers)).first;
  }
  const auto number = found->second.find(std::string(key));
  if (number == found->second.end())
    throw core::InvalidInput(fmt::format("papers/{}.csv has no '{}'", paper, key));
  return number->second;
}

core::Csv Data::table(const std::string& name) const { return core::read_csv(file("tables/" + name)); }

std::vector<Data::Source> Data::sources() const {
  std::map<std::string, std::string> dates;
  const core::Csv csv = core::read_csv(file("papers/sources.csv"));
  for (const auto& row : csv.rows) dates[row.cells[csv.column("source")]] = row.cells[csv.column("date")];
  std::vector<Source> list;
  for (const auto& [name, pool] : pools_) {
    std::size_t done = 0;
    for (int run = 1; run <= static_cast<int>(pool.size()); ++run) done += pool.done(run);
    list.push_back({"pools/" + name, pool.engine, dates["pools/" + name], done});
  }
  for (const auto& [name, curve] : presses_)
    list.push_back({"papers/presses/" + name, std::to_string(curve.engine), dates["papers/presses"], 1});
  return list;
}

} // namespace platen::reproduce
