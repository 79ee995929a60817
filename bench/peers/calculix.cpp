#include "peers/calculix.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fmt/format.h>

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numbers>
#include <sstream>

namespace platen::bench {
namespace {

/// Pressure per penetration of the contact (sigma_y/R0): a mean pressure penetrates by 0.00006 R0, 0.3 % of
/// the smallest overlap compared. At 100,000 CalculiX finds no set of faces in contact on the small elements.
constexpr double contact_stiffness = 5e4;
/// CalculiX makes a sector of 2 degrees of an axisymmetric model, and reports its force.
constexpr double sectors = 180;

std::string id_list(const std::vector<int>& nodes) {
  std::string text;
  for (const int node : nodes) text += fmt::format("{},\n", node + 1);
  return text;
}

double children_cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * t.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Total reactions of the equator by time, from the .dat file:
/// " total force (fx,fy,fz) for set EQUATOR and time  0.4000000E-01", a blank line, three numbers.
std::map<double, double> reactions(const std::string& dat) {
  std::map<double, double> by_time;
  std::istringstream lines(dat);
  for (std::string line; std::getline(lines, line);) {
    const auto at = line.find("and time");
    if (line.find("total force") == std::string::npos || at == std::string::npos) continue;
    const double time = std::stod(line.substr(at + 8));
    double x = 0, y = 0, z = 0;
    lines >> x >> y >> z;
    by_time[time] = y;
  }
  return by_time;
}

} // namespace

std::string calculix_deck(const fe::SectionMesh& mesh, const PressOfPeer& press) {
  const int n = static_cast<int>(mesh.nodes.size()), quads = static_cast<int>(mesh.elements.size());
  const double end = press.delta_bar.back();
  std::string deck = "*HEADING\nquarter section of a sphere under a rigid plane\n*NODE, NSET=ALL\n";
  for (int i = 0; i < n; ++i)
    deck += fmt::format("{}, {:.12g}, {:.12g}\n", i + 1, mesh.nodes[i][0], mesh.nodes[i][1]);
  // The plane: one element above z = 1, all of whose nodes are held. It begins beside the axis, where its
  // sector would end in an edge, and CalculiX would find no contact with it.
  const std::array<std::array<double, 2>, 4> plane{{{1e-3, 1}, {2, 1}, {2, 1.2}, {1e-3, 1.2}}};
  deck += "*NODE, NSET=PLANE\n";
  for (int i = 0; i < 4; ++i) deck += fmt::format("{}, {}, {}\n", n + 1 + i, plane[i][0], plane[i][1]);

  deck += "*ELEMENT, TYPE=CAX4, ELSET=SPHERE\n";
  for (int e = 0; e < quads; ++e) {
    const auto& q = mesh.elements[e];
    deck += fmt::format("{}, {}, {}, {}, {}\n", e + 1, q[0] + 1, q[1] + 1, q[2] + 1, q[3] + 1);
  }
  deck += fmt::format("*ELEMENT, TYPE=CAX4, ELSET=TOOL\n{}, {}, {}, {}, {}\n", quads + 1, n + 1, n + 2, n + 3,
                      n + 4);
  deck += "*NSET, NSET=AXIS\n" + id_list(mesh.mirrors[0].nodes) + "*NSET, NSET=EQUATOR\n" +
          id_list(mesh.mirrors[1].nodes);

  // The element edges on the sphere: S1 joins the first and second node, S2 the second and third, ...
  std::vector<char> on_sphere(n, 0);
  for (const auto& edge : mesh.surface) on_sphere[edge[0]] = on_sphere[edge[1]] = 1;
  deck += "*SURFACE, NAME=OUTSIDE, TYPE=ELEMENT\n";
  for (int e = 0; e < quads; ++e)
    for (int side = 0; side < 4; ++side)
      if (on_sphere[mesh.elements[e][side]] && on_sphere[mesh.elements[e][(side + 1) % 4]])
        deck += fmt::format("{}, S{}\n", e + 1, side + 1);
  deck += fmt::format("*SURFACE, NAME=FLAT, TYPE=ELEMENT\n{}, S1\n", quads + 1);

  deck += fmt::format("*MATERIAL, NAME=PLASTIC\n*ELASTIC\n{}, {}\n*PLASTIC\n1., 0.\n", press.E_bar, press.nu);
  deck += fmt::format("*MATERIAL, NAME=STEEL\n*ELASTIC\n{}, 0.3\n", 1000 * press.E_bar);
  deck += "*SOLID SECTION, ELSET=SPHERE, MATERIAL=PLASTIC\n*SOLID SECTION, ELSET=TOOL, MATERIAL=STEEL\n";
  deck +=
      fmt::format("*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{}\n",
                  contact_stiffness);
  deck += "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nOUTSIDE, FLAT\n";
  deck += "*BOUNDARY\nAXIS, 1, 1\nPLANE, 1, 2\n*TIME POINTS, NAME=COMPARED\n";
  for (const double d : press.delta_bar) deck += fmt::format("{:.10g},\n", d / end);
  deck += fmt::format("*STEP, NLGEOM, INC=100000\n*STATIC\n{:.6g}, 1., 1e-6, {:.6g}\n",
                      press.step_max / end / 5, press.step_max / end);
  deck += fmt::format("*BOUNDARY\nEQUATOR, 2, 2, {}\n", end);
  deck += "*NODE PRINT, NSET=EQUATOR, TOTALS=ONLY, TIME POINTS=COMPARED\nRF\n*END STEP\n";
  return deck;
}

PeerCurve run_calculix(const fe::SectionMesh& mesh, const PressOfPeer& press,
                       const std::filesystem::path& folder) {
  core::prepare_folder(folder);
  core::write_file(folder / "press.inp", calculix_deck(mesh, press));
  const std::string command =
      fmt::format("cd '{}' && OMP_NUM_THREADS=1 ccx -i press >ccx.log 2>&1 </dev/null", folder.string());
  const double before = children_cpu_s();
  const int status = std::system(command.c_str());
  PeerCurve curve;
  curve.cpu_s = children_cpu_s() - before;
  if (status != 0)
    throw core::IoError(fmt::format("ccx ended with status {}; see {}/ccx.log", status, folder.string()));

  const auto by_time = reactions(core::read_file(folder / "press.dat"));
  for (const double d : press.delta_bar) {
    const double time = d / press.delta_bar.back();
    const auto found = std::find_if(by_time.begin(), by_time.end(),
                                    [&](const auto& entry) { return std::abs(entry.first - time) < 1e-5; });
    if (found == by_time.end())
      throw core::IoError(
          fmt::format("ccx printed no force at delta_bar = {}; see {}/ccx.log", d, folder.string()));
    curve.F_bar.push_back(sectors * found->second / std::numbers::pi);
  }
  // press.sta: a line for each increment, step, increment, attempts, iterations, times.
  std::istringstream lines(core::read_file(folder / "press.sta"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream numbers(line);
    int step = 0, increment = 0, attempt = 0, iterations = 0;
    if (numbers >> step >> increment >> attempt >> iterations) {
      ++curve.increments;
      curve.iterations += iterations;
    }
  }
  return curve;
}

} // namespace platen::bench
