#include "dem/device_law.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "dem/contacts.hpp"
#include "dem/damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <vector>

namespace platen::dem {
namespace {

constexpr int nodes = 9;      // of A R_e from 1 (a plane of that material) to 2 (equal spheres)
constexpr int six_to_one = 2; // s = 1.25: radii 6.1 to 1
constexpr int plane = nodes;  // the table of a rigid plane
constexpr int columns = 16;   // of a cell: left, end, F, w, a (4 each), alpha, its slope

using core::number_text;

/// Radii of a pair with A R_e = s, the mean of the two 1; the second may be infinite.
law::Law pair_with(const law::LawChoice& one, double s) {
  if (s == 1) return law::make_law(one, 1, one, law::infinity);
  const double t = std::sqrt((4 / (s * s) - 1) / 3);
  return law::make_law(one, 1 - t, one, 1 + t);
}

double s_of(int node) { return 1 + static_cast<double>(node) / (nodes - 1); }

std::string row(std::initializer_list<double> numbers) {
  std::string text;
  for (const double x : numbers)
    text += (text.empty() ? "" : ", ") + (std::isinf(x) ? "1e300" : number_text(x));
  return text;
}

/// Largest relative difference of the force between the nodes from `first` on, loading and at 0.9 of the
/// overlap.
double error_between(const law::LawChoice& one, const std::vector<law::Law>& laws, double x_end, int first) {
  double worst = 0;
  for (int k = first; k + 1 < nodes; ++k) {
    const auto exact = pair_with(one, (s_of(k) + s_of(k + 1)) / 2);
    const auto force = [](const law::Law& law, double x, double x_max) {
      const auto per = law.scale.x_per_gamma;
      return law::evaluate(law, {0, x_max / per}, x / per).force / law.scale.force;
    };
    for (double x = x_end; x > 1e-3 * x_end; x /= 2)
      for (const double back : {1.0, 0.9}) {
        const double F = force(exact, back * x, x), top = force(exact, x, x);
        const double ours = (force(laws[static_cast<std::size_t>(k)], back * x, x) +
                             force(laws[static_cast<std::size_t>(k + 1)], back * x, x)) /
                            2;
        if (top > 0) worst = std::max(worst, std::abs(ours - F) / top);
      }
  }
  return worst;
}

constexpr const char* head = R"(#ifdef __CUDACC__
#define PLATEN_DEVICE __device__
#else
#include <cmath>
#define PLATEN_DEVICE inline
#endif

)";

constexpr const char* functions = R"(
struct PlatenTop { double F, slope, a, w, alpha; };
struct PlatenResponse { double force, stiffness, contact_radius; };

/// Force, slope, contact radius and unloading at the largest overlap x, without units.
PLATEN_DEVICE PlatenTop platen_top(int table, double x) {
  const double* first = platen_first[table];
  if (x < first[0]) {
    const double part = pow(x / first[0], first[5]), F = first[1] * part;
    return {F, first[5] * F / x, first[2] * pow(x / first[0], first[6]), first[3] * x / first[0], first[4]};
  }
  int low = platen_begin[table], high = platen_begin[table + 1] - 1;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (platen_cells[middle][1] <= x) low = middle + 1;
    else high = middle;
  }
  const double *c = platen_cells[low], v = sqrt(x), t = v - c[0];
  return {c[2] + t * (c[3] + t * (c[4] + t * c[5])), (c[3] + t * (2 * c[4] + t * 3 * c[5])) / (2 * v),
          c[10] + t * (c[11] + t * (c[12] + t * c[13])), c[6] + t * (c[7] + t * (c[8] + t * c[9])), c[14] + t * c[15]};
}

/// Force, its slope over x, and contact radius at the overlap x after the largest x_max.
PLATEN_DEVICE PlatenResponse platen_table(int table, double x, double x_max) {
  if (x_max <= platen_first[table][7]) x_max = x; // unloading retraces the loading curve
  if (!(x > 0) || !(x_max > 0)) return {0, 0, 0};
  const PlatenTop top = platen_top(table, x_max);
  if (!(top.F > 0)) return {0, 0, 0};
  if (!(x < x_max)) return {top.F, top.slope, top.a};
  const double rate = 1 / top.w, xi = 1 - (x_max - x) * rate;
  if (!(xi > 0)) return {0, 0, 0};
  if (platen_shape == 0) {
    const double radius = pow(xi, top.alpha - 1);
    return {top.F * xi * radius, top.F * top.alpha * radius * rate, top.a * radius};
  }
  if (platen_shape == 1) {
    const double radius = sqrt(xi * (2 - xi)), pi = 3.14159265358979323846;
    const double area = xi < 1e-4 ? 4.0 / 3 * sqrt(2 * xi) * xi : acos(1 - xi) - (1 - xi) * radius;
    return {top.F * 2 / pi * area, top.F * 4 / pi * radius * rate, top.a * radius};
  }
  const double p = pow(x / x_max, platen_n), rest = 1 - platen_lambda_p, F = (p - platen_lambda_p) / rest;
  return {top.F * (F > 0 ? F : 0), top.F * platen_n * p / (rest * x), top.a * sqrt(x / x_max)};
}

/// Two spheres, radii and overlaps (of the centres) in m; R2 above 1e6: a rigid plane. `overlap_max` is the largest so far.
/// Force [N], stiffness [N/m], contact radius [m].
PLATEN_DEVICE PlatenResponse platen_contact(double R1, double R2, double overlap, double overlap_max) {
  if (overlap_max < overlap) overlap_max = overlap;
  if (R1 > 1e6 || R2 > 1e6) {
    const double R = R1 < R2 ? R1 : R2, scale = pow(R, platen_power);
    const PlatenResponse r = platen_table(platen_plane, overlap / R, overlap_max / R);
    return {r.force * scale, r.stiffness * scale / R, r.contact_radius * R};
  }
  const double mean = (R1 + R2) / 2, t = (R1 - R2) / (R1 + R2), root = sqrt(1 + 3 * t * t);
  const double R = mean * (1 - t * t) / root, per = (1 + 3 * t * t) / (2 * (1 - t * t) * mean), scale = pow(R, platen_power);
  const double place = (2 / root - 1) * (platen_plane - 1);
  const int node = place < platen_plane - 1 ? static_cast<int>(place) : platen_plane - 2;
  const double part = place - node;
  PlatenResponse r = {0, 0, 0};
  for (int k = 0; k < 2; ++k) {
    const double weight = k == 0 ? 1 - part : part;
    if (weight == 0) continue;
    const PlatenResponse one = platen_table(node + k, overlap * per, overlap_max * per);
    r.force += weight * one.force * scale;
    r.stiffness += weight * one.stiffness * scale * per;
    r.contact_radius += weight * one.contact_radius * R;
  }
  return r;
}
)";

constexpr const char* engine =
    R"(// Force model of DEM-Engine. A contact remembers its largest overlap, in two numbers because they are float, and its tangential force.
if (overlapDepth > 0) {
  const double overlap = overlapDepth, before = (double)platen_max + (double)platen_max_rest;
  const double largest = before < overlap ? overlap : before;
  platen_max = (float)largest;
  platen_max_rest = (float)(largest - (double)platen_max);
  const PlatenResponse law = platen_contact(ARadius, BRadius, overlap, largest);

  float3 rotVelCPA = cross(ARotVel, locCPA);
  float3 rotVelCPB = cross(BRotVel, locCPB);
  applyOriQToVector3(rotVelCPA, AOriQ);
  applyOriQToVector3(rotVelCPB, BOriQ);
  const float3 velocity = (ALinVel + rotVelCPA) - (BLinVel + rotVelCPB); // of A, seen from B
  const float along = dot(velocity, B2A);
  const float3 sliding = velocity - along * B2A;
  const double mass = (double)AOwnerMass * BOwnerMass / ((double)AOwnerMass + BOwnerMass);

  const double normal = law.force > 0 ? fmax(law.force - platen_damping * sqrt(law.stiffness * mass) * along, 0.0) : 0.0;
  force += (float)normal * B2A;

  // Mindlin: stiffness 8 G* a; when a shrinks the force shrinks with it, and friction limits it
  const double k_t = platen_shear * law.contact_radius;
  const double wide = platen_k < k_t ? k_t : (double)platen_k, keep = wide > 0 ? k_t / wide : 0.0;
  float3 tangential = make_float3(platen_t_x, platen_t_y, platen_t_z);
  tangential = (float)keep * (tangential - dot(tangential, B2A) * B2A) - (float)(k_t * ts) * sliding;
  const double size = sqrt((double)dot(tangential, tangential)), limit = normal > 0 ? platen_friction * normal : 0.0;
  if (size > limit) tangential = (float)(limit / size) * tangential;
  force += tangential;
  platen_t_x = tangential.x, platen_t_y = tangential.y, platen_t_z = tangential.z, platen_k = (float)k_t;
} else {
  platen_max = platen_max_rest = platen_t_x = platen_t_y = platen_t_z = platen_k = 0;
}
)";

} // namespace

DeviceLaw device_law(const fit::LawCard& card) {
  if (card.parameters.contains("radius_m"))
    throw core::InvalidInput(
        fmt::format("{}: the card is for radius_m = {} alone, and the text is for particles of any radius",
                    card.file, card.parameters.at("radius_m")));
  const auto one = fit::body_of(card, true);
  std::vector<law::Law> laws;
  for (int k = 0; k < nodes; ++k) laws.push_back(pair_with(one, s_of(k)));
  laws.push_back(law::make_law_on_plane(one, 1));
  const double x_end = card.delta_bar ? (*card.delta_bar)[1] : 0.1;
  DeviceLaw result;
  result.sizes_error = error_between(one, laws, x_end, six_to_one);
  result.wide_error = error_between(one, laws, x_end, 0);

  std::string& text = result.text;
  text = fmt::format(
      "// Law {}{} of {}, by Platen {}. Equal spheres, and a rigid plane: as tabulated.\n"
      "// Spheres of unlike radii: force within {:.2g} % of the law up to 6 to 1, {:.2g} % beyond.{}\n",
      card.law, card.variant.empty() ? "" : " (" + card.variant + ")",
      std::filesystem::path(card.file).filename().string(), core::version, 100 * result.sizes_error,
      100 * result.wide_error,
      card.delta_bar ? fmt::format(" Made for delta/R to {}.", number_text(x_end)) : "");
  text += head;
  std::string first, cells, begin;
  std::size_t count = 0;
  for (const auto& law : laws) {
    const law::Table& t = *law.table;
    first +=
        "  {" +
        row({t.x_first, t.first.F, t.first.a, t.first.w, t.first.alpha, t.n_first, t.m_first, t.x_elastic}) +
        "},\n";
    begin += fmt::format("{}, ", count);
    for (const law::Cell& c : t.cell_list) {
      cells += "  {" +
               row({c.left, c.end, c.F.c0, c.F.c1, c.F.c2, c.F.c3, c.w.c0, c.w.c1, c.w.c2, c.w.c3, c.a.c0,
                    c.a.c1, c.a.c2, c.a.c3, c.alpha, c.alpha_slope}) +
               "},\n";
      ++count;
    }
  }
  const law::Table& t = *laws[0].table;
  fmt::format_to(std::back_inserter(text),
                 "enum {{ platen_shape = {}, platen_plane = {} }};\n"
                 "#define platen_n {}\n#define platen_lambda_p {}\n#define platen_power {}\n",
                 static_cast<int>(t.shape), plane, number_text(t.n), number_text(t.lambda_p),
                 number_text(laws[0].force_power));
  fmt::format_to(std::back_inserter(text), "PLATEN_DEVICE const double platen_first[{}][8] = {{\n{}}};\n",
                 laws.size(), first);
  fmt::format_to(std::back_inserter(text), "PLATEN_DEVICE const int platen_begin[{}] = {{{}{}}};\n",
                 laws.size() + 1, begin, count);
  fmt::format_to(std::back_inserter(text), "PLATEN_DEVICE const double platen_cells[{}][{}] = {{\n{}}};\n",
                 count, columns, cells);
  text += functions;
  fmt::format_to(std::back_inserter(text),
                 "\n/// Of Hertz's contact that returns e, in (0, 1], under max(force - damping "
                 "sqrt(stiffness m) v, 0).\n"
                 "PLATEN_DEVICE {}\n",
                 damping_text);
  return result;
}

EngineModel engine_model(const fit::LawCard& card, double restitution, double friction) {
  Contact contact;
  contact.one = contact.two = card;
  contact.restitution = restitution;
  contact.friction = friction;
  check(contact);
  const Laws laws(contact, 0, {});
  EngineModel m;
  m.functions = device_law(card).text;
  fmt::format_to(std::back_inserter(m.functions),
                 "\n#define platen_damping {}\n#define platen_shear {}\n#define platen_friction {}\n",
                 number_text(laws.damping), number_text(laws.shear), number_text(friction));
  m.model = engine;
  m.use = R"(import pathlib

here = pathlib.Path(__file__).parent
FUNCTIONS, MODEL = (here / "functions.cu").read_text(), (here / "model.cu").read_text()
WILDCARDS = {"platen_max", "platen_max_rest", "platen_t_x", "platen_t_y", "platen_t_z", "platen_k"}


def use_platen(solver):
    """Gives a deme.DEMSolver the law; to be called before Initialize()."""
    model = solver.DefineContactForceModel(MODEL)
    model.DefineCustomModelPrerequisites(FUNCTIONS)
    model.SetPerContactWildcards(WILDCARDS)
    return model
)";
  return m;
}

} // namespace platen::dem
