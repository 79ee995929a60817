#include "measure/input_curve.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "measure/stages.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace platen::measure {
namespace {

using core::InvalidInput;

/// Our own columns, as a press or a script writes them.
bool is_own(std::string_view text) {
  for (std::size_t start = 0; start < text.size();) {
    const auto end = std::min(text.find('\n', start), text.size());
    const auto line = text.substr(start, end - start);
    start = end + 1;
    if (line.empty() || line == "\r" || line.front() == '#') continue;
    return line.find("delta_m") != line.npos && line.find("force_N") != line.npos &&
           line.find_first_of("\";\t") == line.npos;
  }
  return false;
}

constexpr double drawn_together = 400; // points of a loading; more say nothing that their means do not

/// Many rows become as many means as a fit needs: the time of a fit grows with their square.
void average(press::Curve& curve) {
  const auto& rows = curve.points;
  if (static_cast<double>(rows.size()) < 2 * drawn_together) return;
  double largest = 0;
  for (const auto& row : rows) largest = std::max(largest, row.delta_m);
  std::vector<press::CurvePoint> means;
  for (std::size_t i = 0; i < rows.size();) {
    auto mean = rows[i];
    std::size_t end = i + 1;
    for (; end < rows.size() && rows[end].branch_id == mean.branch_id && rows[end].branch == mean.branch &&
           std::abs(rows[end].delta_m - rows[i].delta_m) < largest / drawn_together;
         ++end)
      mean.delta_m += rows[end].delta_m, mean.force_N += rows[end].force_N;
    mean.delta_m /= static_cast<double>(end - i), mean.force_N /= static_cast<double>(end - i);
    mean.delta_bar = mean.delta_m / curve.radius_m;
    means.push_back(mean);
    i = end;
  }
  curve.points = std::move(means);
  if (curve.sigma_ref_Pa > 0) press::set_reference_stress(curve, curve.sigma_ref_Pa);
}

/// Rows of one stage after another, averaged so that overlap grows or falls from point to point.
void add_points(press::Curve& curve, const Specimen& s, const Stages& stages, const Machine& machine) {
  std::vector<double> delta;
  for (std::size_t i = 0; i < s.travel_m.size(); ++i)
    delta.push_back(s.per_travel() * (s.travel_m[i] - machine.travel(s.force_N[i] - stages.baseline_N) -
                                      stages.contact_travel_m));
  const double step = *std::ranges::max_element(delta) / drawn_together;
  double largest = 0;
  int branch = 0;
  for (std::size_t i = 0; i < delta.size();) {
    const Stage stage = stages.of_row[i];
    std::size_t end = i;
    double sum = 0, force = 0;
    while (end < delta.size() && stages.of_row[end] == stage &&
           (end == i || std::abs(delta[end] - delta[i]) < step))
      sum += delta[end], force += s.force_N[end] - stages.baseline_N, ++end;
    if (i > 0 && stages.of_row[i - 1] != stage && (stage == Stage::unloading || stage == Stage::reloading))
      ++branch;
    press::CurvePoint point;
    point.delta_m = sum / static_cast<double>(end - i);
    point.force_N = force / static_cast<double>(end - i);
    point.delta_bar = point.delta_m / curve.radius_m;
    point.branch = stage == Stage::unloading   ? press::Branch::unloading
                   : stage == Stage::reloading ? press::Branch::reloading
                                               : press::Branch::loading;
    point.branch_id = point.branch == press::Branch::loading ? 0 : branch;
    i = end;
    if (stage == Stage::approach || stage == Stage::hold || stage == Stage::broken || point.delta_m <= 0)
      continue;
    if (point.branch == press::Branch::loading && point.delta_m <= largest) continue;
    if (point.branch == press::Branch::loading) largest = point.delta_m;
    curve.points.push_back(point);
  }
}

} // namespace

InputCurve read_curve(const std::string& file, std::string text, const CurveOptions& o) {
  InputCurve input{.file = file, .text = std::move(text), .curve = {}};
  const auto& diameter = o.read.diameter_m;
  input.curve = press::parse_curve(input.text, file, diameter ? std::optional(*diameter / 2) : std::nullopt);
  input.measured = input.curve.experiment.empty();
  if (input.measured) average(input.curve);
  return input;
}

InputCurve read_curve(const std::string& file, const CurveOptions& o) {
  if (!core::is_there(file)) throw InvalidInput(fmt::format("{}: there is no such file", file));
  InputCurve input{.file = file, .text = core::read_file(file), .curve = {}};
  if (o.read.force.empty() && o.read.displacement.empty() && is_own(input.text))
    return read_curve(file, std::move(input.text), o);
  const auto m = read_measurement(file, o.read);
  if (m.specimens.size() != 1)
    throw InvalidInput(fmt::format("{}: {} particles; fit takes one curve, platen calibrate takes all", file,
                                   m.specimens.size()));
  const auto& s = m.specimens.front();
  if (!s.diameter_m)
    throw InvalidInput(
        fmt::format("{}: the file does not say the diameter of the particle; give --radius_m", file));
  const auto stages = stages_of(s);
  if (stages.broke && !o.despite_doubts)
    throw InvalidInput(
        fmt::format("{}, line {}: the particle broke, the force fell by {:.0f} % while the platens "
                    "closed; --force fits what was before",
                    file, s.line[stages.broke->row], 100 * stages.broke->fell));
  input.measured = true;
  input.curve.radius_m = s.radius_m();
  add_points(input.curve, s, stages, o.machine);
  std::string found = m.read_as;
  for (const auto& sentence : m.said) found += "; " + sentence;
  input.provenance = {{"source", file},
                      {"found", found},
                      {"contact_fitted", fmt::format("{} +- {:.2g}, by the foot of the curve",
                                                     s.on_scale_of_file(stages.contact_travel_m),
                                                     stages.contact_uncertainty_m / s.travel_unit.in_SI)},
                      {"machine", o.machine.given()
                                      ? o.machine.said
                                      : "no compliance of the machine taken off: where it gives way the "
                                        "particle seems softer"},
                      {"rows", static_cast<int>(s.force_N.size())}};
  return input;
}

fit::Claim claim_of(const press::Curve& curve, const std::string& file) {
  fit::Claim claim;
  claim.name = file;
  claim.radius_m = curve.radius_m;
  for (const auto& point : curve.points)
    if (point.branch == press::Branch::loading) {
      claim.delta_m.push_back(point.delta_m);
      claim.force_N.push_back(point.force_N);
    }
  if (curve.E_Pa > 0) claim.E_Pa = curve.E_Pa, claim.nu = curve.nu;
  return claim;
}

} // namespace platen::measure
