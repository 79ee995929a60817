#include "press/fields_vtu.hpp"

#include "core/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace platen::press {
namespace {

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

/// A point of a section lies in the plane x = r, y = z.
template <std::size_t N> std::string in_metres(const fe::Vector<N>& x, double radius_m) {
  return fmt::format("{:.9g} {:.9g} {:.9g}", x[0] * radius_m, x[1] * radius_m,
                     N == 3 ? x[N - 1] * radius_m : 0.0);
}

/// How files name an element and its stresses.
template <fe::Element E> struct Names;
template <> struct Names<fe::Quad> {
  static constexpr int vtk_cell = 9;
  static constexpr std::array stress{"sigma_rr_Pa", "sigma_zz_Pa", "sigma_rz_Pa", "sigma_tt_Pa"};
  static constexpr std::string_view shown = "zone";
};
template <> struct Names<fe::Hexahedron> {
  static constexpr int vtk_cell = 12;
  static constexpr std::array stress{"sigma_xx_Pa", "sigma_yy_Pa", "sigma_zz_Pa",
                                     "sigma_xy_Pa", "sigma_yz_Pa", "sigma_zx_Pa"};
  static constexpr std::string_view shown = "plastic_hencky_strain_q";
};

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

} // namespace

template <fe::Element E> std::string fields_vtu(const SnapshotOf<E>& s, double radius_m) {
  Writer out;
  begin(out, s.delta_bar, s.nodes.size(), s.elements.size());
  const auto place = [&](const auto& x) { return in_metres(x, radius_m); };
  out.open("PointData Vectors=\"displacement_m\"");
  out.array("Float64", "displacement_m", 3, s.displacement, place);
  out.close("PointData");
  out.open("Points");
  out.array("Float64", "Points", 3, s.nodes, place);
  out.close("Points");
  int end = 0;
  const int corners = E::Mesh::corners;
  out.open("Cells");
  out.array("Int32", "connectivity", 1, s.elements,
            [](const auto& element) { return fmt::format("{}", fmt::join(element, " ")); });
  out.array("Int32", "offsets", 1, s.elements, [&](const auto&) { return std::to_string(end += corners); });
  out.array("UInt8", "types", 1, s.elements, [](const auto&) { return std::to_string(Names<E>::vtk_cell); });
  out.close("Cells");
  out.open(fmt::format("CellData Scalars=\"{}\"", Names<E>::shown));
  out.array("Int32", "zone", 1, s.zones,
            [](const auto& zones) { return std::to_string(static_cast<int>(prevailing(zones))); });
  for (std::size_t i = 0; i < Names<E>::stress.size(); ++i)
    out.array("Float64", Names<E>::stress[i], 1, s.stress,
              [&](const auto& stress) { return fmt::format("{:.7g}", stress[i]); });
  out.scalars("p_Pa", s.p);
  out.scalars("q_Pa", s.q);
  out.scalars("rho_r", s.rho_r);
  out.scalars("phi", s.phi);
  out.scalars("plastic_hencky_strain_v", s.plastic_strain_v);
  out.scalars("plastic_hencky_strain_q", s.plastic_strain_q);
  out.close("CellData");
  return ended(out);
}

template <fe::Element E> std::string fields_series(const std::vector<SnapshotOf<E>>& snapshots) {
  Writer out;
  out.open("?xml version=\"1.0\"?");
  out.open("VTKFile type=\"Collection\" version=\"0.1\"");
  out.open("Collection");
  for (const auto& s : snapshots)
    out.line("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>", core::number_text(s.delta_bar),
             fields_name(s.delta_bar));
  out.close("Collection");
  out.close("VTKFile");
  return out.text;
}

template std::string fields_vtu(const Snapshot&, double);
template std::string fields_vtu(const SpatialSnapshot&, double);
template std::string fields_series(const std::vector<Snapshot>&);
template std::string fields_series(const std::vector<SpatialSnapshot>&);

std::string fields_name(double delta_bar) {
  return fmt::format("fields-{}.vtu", core::number_text(delta_bar));
}

} // namespace platen::press
