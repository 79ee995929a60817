#include "press/curve_csv.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "press/case.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <variant>

namespace platen::press {
namespace {

using P = CurvePoint;

/// One column; the order below is the order in the file. `plane`: along z, x, y.
struct Column {
  std::string_view name;
  std::variant<double P::*, int P::*, Branch P::*, double PlanePoint::*> member;
  int plane = 0;
};

constexpr std::array columns = {
    Column{"branch_id", &P::branch_id},
    Column{"branch", &P::branch},
    Column{"delta_m", &PlanePoint::delta_m},
    Column{"delta_bar", &P::delta_bar},
    Column{"force_N", &PlanePoint::force_N},
    Column{"F_bar", &P::F_bar},
    Column{"contact_radius_m", &PlanePoint::contact_radius_m},
    Column{"mean_pressure_Pa", &PlanePoint::mean_pressure_Pa},
    Column{"peak_pressure_Pa", &PlanePoint::peak_pressure_Pa},
    Column{"zone_elastic", &P::zone_elastic},
    Column{"zone_shear", &P::zone_shear},
    Column{"zone_compaction", &P::zone_compaction},
    Column{"zone_tension", &P::zone_tension},
    Column{"work_J", &P::work_J},
    Column{"stored_J", &P::stored_J},
    Column{"dissipated_J", &P::dissipated_J},
    Column{"rho_r_mean", &P::rho_r_mean},
    Column{"rho_r_min", &P::rho_r_min},
    Column{"rho_r_max", &P::rho_r_max},
    Column{"sigma_1_max_Pa", &P::sigma_1_max_Pa},
    Column{"equator_displacement_m", &P::equator_displacement_m},
    Column{"iterations", &P::iterations},
    Column{"hertz_delta_m", &P::hertz_delta_m},
    Column{"mises_max_Pa", &P::mises_max_Pa},
};
/// Of confined presses, behind the others.
constexpr std::array cell_columns = {
    Column{"cell_filling", &P::cell_filling},
    Column{"mesh_quality", &P::mesh_quality},
};
constexpr std::array x_columns = {
    Column{"delta_x_m", &PlanePoint::delta_m, 1},
    Column{"force_x_N", &PlanePoint::force_N, 1},
    Column{"contact_radius_x_m", &PlanePoint::contact_radius_m, 1},
    Column{"mean_pressure_x_Pa", &PlanePoint::mean_pressure_Pa, 1},
    Column{"peak_pressure_x_Pa", &PlanePoint::peak_pressure_Pa, 1},
};
constexpr std::array y_columns = {
    Column{"delta_y_m", &PlanePoint::delta_m, 2},
    Column{"force_y_N", &PlanePoint::force_N, 2},
    Column{"contact_radius_y_m", &PlanePoint::contact_radius_m, 2},
    Column{"mean_pressure_y_Pa", &PlanePoint::mean_pressure_Pa, 2},
    Column{"peak_pressure_y_Pa", &PlanePoint::peak_pressure_Pa, 2},
};

/// Hydrostatic planes are all alike, and those of the die's walls too.
std::vector<Column> columns_of(std::string_view experiment) {
  std::vector<Column> list(columns.begin(), columns.end());
  const auto append = [&](const auto& more) { list.insert(list.end(), more.begin(), more.end()); };
  const bool die = experiment == Die::name, triaxial = experiment == Triaxial::name;
  if (die || triaxial || experiment == Hydrostatic::name) append(cell_columns);
  if (die || triaxial) append(x_columns);
  if (triaxial) append(y_columns);
  return list;
}

constexpr std::array<std::string_view, 3> branches = {"loading", "unloading", "reloading"};

struct CellText {
  const P& point;
  int plane;
  std::string operator()(double PlanePoint::*x) const { return core::number_text(point.plane(plane).*x); }
  std::string operator()(double P::*x) const { return core::number_text(point.*x); }
  std::string operator()(int P::*i) const { return std::to_string(point.*i); }
  std::string operator()(Branch P::*b) const { return std::string(branches[static_cast<int>(point.*b)]); }
};

struct ReadCell {
  P& point;
  const core::Csv& csv;
  const core::Csv::Row& row;
  std::size_t column;

  [[noreturn]] void refuse(std::string_view why) const {
    throw core::InvalidInput(fmt::format("{}, line {}, column {}: '{:.40}' {}", csv.file, row.line,
                                         csv.columns[column], row.cells[column], why));
  }
  int plane;
  void operator()(double PlanePoint::*x) const { point.plane(plane).*x = csv.number(row, column); }
  void operator()(double P::*x) const { point.*x = csv.number(row, column); }
  void operator()(int P::*i) const {
    const double value = csv.number(row, column);
    if (value != std::floor(value) || std::abs(value) > 1e9) refuse("is not a whole number");
    point.*i = static_cast<int>(value);
  }
  void operator()(Branch P::*b) const {
    for (std::size_t i = 0; i < branches.size(); ++i)
      if (row.cells[column] == branches[i]) {
        point.*b = static_cast<Branch>(i);
        return;
      }
    refuse("is not loading, unloading or reloading");
  }
};

double positive_radius(double radius_m, std::string_view file) {
  if (!(radius_m > 0) || !std::isfinite(radius_m))
    throw core::InvalidInput(fmt::format("{}: radius_m = {} must be > 0", file, core::number_text(radius_m)));
  return radius_m;
}

void read_notes(Curve& curve, const core::Csv& csv, std::optional<double> radius_m) {
  const bool noted = !csv.note("radius_m").empty();
  if (!radius_m && !noted)
    throw core::InvalidInput(
        fmt::format("{}: the radius of the particle is missing; give it with --radius_m, or as a "
                    "first line '# radius_m = 1e-3'",
                    csv.file));
  curve.radius_m = positive_radius(noted ? csv.number_note("radius_m") : *radius_m, csv.file);
  if (radius_m && !(std::abs(*radius_m - curve.radius_m) <= 1e-9 * curve.radius_m))
    throw core::InvalidInput(fmt::format("{} says radius_m = {}, and {} was given; leave one of them out",
                                         csv.file, core::number_text(curve.radius_m),
                                         core::number_text(*radius_m)));
  const auto number = [&](std::string_view key) { return csv.note(key).empty() ? 0 : csv.number_note(key); };
  curve.sigma_ref_Pa = number("sigma_ref_Pa");
  curve.E_Pa = number("E_Pa");
  curve.nu = number("nu");
  curve.phi_deg = number("phi_deg");
  curve.sigma_c_Pa = number("sigma_c_Pa");
  if (!csv.note("inverse_m").empty()) curve.inverse_m = csv.number_note("inverse_m");
  if (curve.sigma_ref_Pa < 0)
    throw core::InvalidInput(
        fmt::format("{}: # sigma_ref_Pa = {} must be > 0", csv.file, csv.note("sigma_ref_Pa")));
  const double engine = number("engine");
  if (engine != std::floor(engine) || std::abs(engine) > 1e9)
    throw core::InvalidInput(
        fmt::format("{}: # engine = {} is not a whole number", csv.file, csv.note("engine")));
  curve.engine = static_cast<int>(engine);
  curve.experiment = csv.note("experiment");
  curve.material = csv.note("material");
  curve.version = csv.note("version");
}

} // namespace

std::string curve_csv(const Curve& curve) {
  std::string text = fmt::format(
      "# radius_m = {}\n# sigma_ref_Pa = {}\n# E_Pa = {}\n# nu = {}\n# experiment = {}\n"
      "# material = {}\n# version = {}\n# engine = {}\n",
      core::number_text(curve.radius_m), core::number_text(curve.sigma_ref_Pa), core::number_text(curve.E_Pa),
      core::number_text(curve.nu), curve.experiment, curve.material, curve.version, curve.engine);
  if (curve.sigma_c_Pa > 0)
    text += fmt::format("# phi_deg = {}\n# sigma_c_Pa = {}\n", core::number_text(curve.phi_deg),
                        core::number_text(curve.sigma_c_Pa));
  if (curve.inverse_m) text += fmt::format("# inverse_m = {}\n", core::number_text(*curve.inverse_m));
  const auto written = columns_of(curve.experiment);
  for (const auto& column : written) {
    if (&column != written.data()) text += ',';
    text += column.name;
  }
  text += '\n';
  for (const auto& point : curve.points) {
    for (const auto& column : written) {
      if (&column != written.data()) text += ',';
      text += std::visit(CellText{point, column.plane}, column.member);
    }
    text += '\n';
  }
  return text;
}

void set_reference_stress(Curve& curve, double sigma_ref_Pa) {
  curve.sigma_ref_Pa = sigma_ref_Pa;
  const double unit = std::numbers::pi * curve.radius_m * curve.radius_m * sigma_ref_Pa;
  for (auto& point : curve.points) point.F_bar = point.force_N / unit;
}

void write_curve(const Curve& curve, const std::filesystem::path& path) {
  core::write_file(path, curve_csv(curve));
}

Curve parse_curve(const std::string& text, const std::string& file, std::optional<double> radius_m) {
  const core::Csv csv = core::parse_csv(text, file);
  const std::vector<std::string> needed = {"delta_m", "force_N"};
  for (const auto& name : needed) (void)csv.column(name);

  Curve curve;
  read_notes(curve, csv, radius_m);
  struct Found {
    Column column;
    std::size_t index;
  };
  std::vector<Found> found;
  for (const auto& column : columns_of(Triaxial::name))
    if (csv.has_column(column.name)) found.push_back({column, csv.column(column.name)});
  for (const auto& row : csv.rows) {
    CurvePoint point;
    for (const auto& [column, index] : found)
      std::visit(ReadCell{point, csv, row, index, column.plane}, column.member);
    point.delta_bar = point.delta_m / curve.radius_m;
    if (!std::isfinite(point.delta_bar))
      throw core::InvalidInput(fmt::format("{}, line {}: delta_m is not within reach of radius_m = {}", file,
                                           row.line, core::number_text(curve.radius_m)));
    curve.points.push_back(point);
  }
  if (curve.sigma_ref_Pa > 0) set_reference_stress(curve, curve.sigma_ref_Pa);
  if (curve.points.size() < 2)
    throw core::InvalidInput(fmt::format("{}: {} rows; a curve has at least 2", file, curve.points.size()));
  return curve;
}

Curve read_curve(const std::filesystem::path& path, std::optional<double> radius_m) {
  if (!core::is_there(path))
    throw core::InvalidInput(fmt::format("{}: there is no such file", path.string()));
  return parse_curve(core::read_file(path), path.string(), radius_m);
}

} // namespace platen::press
