#include "press/fields_vtu.hpp"

#include "core/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace platen::press {
namespace {

constexpr int vtk_quad = 9, vtk_hexahedron = 12;

/// Seven digits show more than a mesh resolves; text is read by every reader, whatever its byte order.
class Writer {
 public:
  void open(std::string_view tag) { line("<{}>", tag); }
  void close(std::string_view tag) { line("</{}>", tag); }

  template <class... Arguments> void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
  }

  /// One row of numbers an item.
  template <class Items, class Row>
  void array(std::string_view type, std::string_view name, int components, const Items& items, Row row) {
    line("<DataArray type=\"{}\" Name=\"{}\"{} format=\"ascii\">", type, name,
         components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "");
    for (const auto& item : items) line("{}", row(item));
    close("DataArray");
  }
  void scalars(std::string_view name, const std::vector<double>& values) {
    array("Float64", name, 1, values, [](double value) { return fmt::format("{:.7g}", value); });
  }

  std::string text;
};

int zone_of(const std::array<Zone, 4>& points) {
  std::array<int, 4> count{};
  for (const Zone zone : points) ++count[static_cast<int>(zone)];
  // of equally many the later: rather plastic than elastic
  return static_cast<int>(count.rend() - std::max_element(count.rbegin(), count.rend())) - 1;
}

void points(Writer& out, const Snapshot& s, double radius_m) {
  const auto in_metres = [&](const std::array<double, 2>& x) {
    return fmt::format("{:.9g} {:.9g} 0", x[0] * radius_m, x[1] * radius_m);
  };
  out.open("PointData Vectors=\"displacement_m\"");
  out.array("Float64", "displacement_m", 3, s.displacement, in_metres);
  out.close("PointData");
  out.open("Points");
  out.array("Float64", "Points", 3, s.nodes, in_metres);
  out.close("Points");
}

void cells(Writer& out, const Snapshot& s) {
  int end = 0;
  out.open("Cells");
  out.array("Int32", "connectivity", 1, s.quads,
            [](const auto& quad) { return fmt::format("{} {} {} {}", quad[0], quad[1], quad[2], quad[3]); });
  out.array("Int32", "offsets", 1, s.quads, [&](const auto&) { return std::to_string(end += 4); });
  out.array("UInt8", "types", 1, s.quads, [](const auto&) { return std::to_string(vtk_quad); });
  out.close("Cells");
}

/// Cauchy stresses under their names, and what has the same name in all presses.
template <class Snapshot, std::size_t N>
void cell_values(Writer& out, const Snapshot& s, const std::array<const char*, N>& stresses) {
  for (std::size_t i = 0; i < N; ++i)
    out.array("Float64", stresses[i], 1, s.stress,
              [&](const auto& stress) { return fmt::format("{:.7g}", stress[i]); });
  out.scalars("p_Pa", s.p);
  out.scalars("q_Pa", s.q);
  out.scalars("rho_r", s.rho_r);
  out.scalars("phi", s.phi);
  out.scalars("plastic_hencky_strain_v", s.plastic_strain_v);
  out.scalars("plastic_hencky_strain_q", s.plastic_strain_q);
}

void cell_data(Writer& out, const Snapshot& s) {
  out.open("CellData Scalars=\"zone\"");
  out.array("Int32", "zone", 1, s.zones, [](const auto& zones) { return std::to_string(zone_of(zones)); });
  cell_values(out, s, std::array{"sigma_rr_Pa", "sigma_zz_Pa", "sigma_rz_Pa", "sigma_tt_Pa"});
  out.close("CellData");
}

void begin(Writer& out, double delta_bar, std::size_t points, std::size_t cells) {
  out.open("?xml version=\"1.0\"?");
  out.open("VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"");
  out.open("UnstructuredGrid");
  out.line("<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
           "format=\"ascii\">{}</DataArray>\n</FieldData>",
           core::number_text(delta_bar));
  out.line("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">", points, cells);
}

std::string ended(Writer& out) {
  out.close("Piece");
  out.close("UnstructuredGrid");
  out.close("VTKFile");
  return std::move(out.text);
}

std::string series(const std::vector<double>& delta_bars) {
  Writer out;
  out.open("?xml version=\"1.0\"?");
  out.open("VTKFile type=\"Collection\" version=\"0.1\"");
  out.open("Collection");
  for (const double delta_bar : delta_bars)
    out.line("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>", core::number_text(delta_bar),
             fields_name(delta_bar));
  out.close("Collection");
  out.close("VTKFile");
  return out.text;
}

template <class Snapshots> std::string series_of(const Snapshots& snapshots) {
  std::vector<double> delta_bars;
  for (const auto& s : snapshots) delta_bars.push_back(s.delta_bar);
  return series(delta_bars);
}

} // namespace

std::string fields_vtu(const Snapshot& s, double radius_m) {
  Writer out;
  begin(out, s.delta_bar, s.nodes.size(), s.quads.size());
  points(out, s, radius_m);
  cells(out, s);
  cell_data(out, s);
  return ended(out);
}

std::string fields_vtu(const SpatialSnapshot& s, double radius_m) {
  Writer out;
  begin(out, s.delta_bar, s.nodes.size(), s.hexes.size());
  const auto in_metres = [&](const fe::Vector3& x) {
    return fmt::format("{:.9g} {:.9g} {:.9g}", x[0] * radius_m, x[1] * radius_m, x[2] * radius_m);
  };
  out.open("PointData Vectors=\"displacement_m\"");
  out.array("Float64", "displacement_m", 3, s.displacement, in_metres);
  out.close("PointData");
  out.open("Points");
  out.array("Float64", "Points", 3, s.nodes, in_metres);
  out.close("Points");
  int end = 0;
  out.open("Cells");
  out.array("Int32", "connectivity", 1, s.hexes,
            [](const auto& hex) { return fmt::format("{}", fmt::join(hex, " ")); });
  out.array("Int32", "offsets", 1, s.hexes, [&](const auto&) { return std::to_string(end += 8); });
  out.array("UInt8", "types", 1, s.hexes, [](const auto&) { return std::to_string(vtk_hexahedron); });
  out.close("Cells");
  out.open("CellData Scalars=\"plastic_hencky_strain_q\"");
  out.array("Int32", "zone", 1, s.zone, [](Zone zone) { return std::to_string(static_cast<int>(zone)); });
  cell_values(
      out, s,
      std::array{"sigma_xx_Pa", "sigma_yy_Pa", "sigma_zz_Pa", "sigma_xy_Pa", "sigma_yz_Pa", "sigma_zx_Pa"});
  out.close("CellData");
  return ended(out);
}

std::string fields_name(double delta_bar) {
  return fmt::format("fields-{}.vtu", core::number_text(delta_bar));
}

std::string fields_series(const std::vector<Snapshot>& snapshots) { return series_of(snapshots); }
std::string fields_series(const std::vector<SpatialSnapshot>& snapshots) { return series_of(snapshots); }

} // namespace platen::press
