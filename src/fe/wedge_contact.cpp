#include "fe/wedge_contact.hpp"

#include "fe/stopwatch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace platen::fe {
namespace {

// Gauss-Legendre with 4 points on [-1, 1]: Abramowitz & Stegun, table 25.4.
constexpr std::array<double, 4> gauss_x{-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                        0.861136311594052575};
constexpr std::array<double, 4> gauss_w{0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                        0.347854845137453857};
/// Faces whose points all lie deeper than this under a pole never touch its plane (R0).
constexpr double deepest = 1;
constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

std::array<double, 4> shape(double xi, double eta) {
  std::array<double, 4> N;
  for (int a = 0; a < 4; ++a) N[a] = (1 + xi * corners[a][0]) * (1 + eta * corners[a][1]) / 4;
  return N;
}

/// A point of a face on the true sphere, and the area there per unit of xi and eta.
struct SpherePoint {
  Vector3 X;
  double area;
};
SpherePoint on_sphere(const WedgeMesh& mesh, const std::array<int, 4>& face, double xi, double eta) {
  Vector3 B{}, B_xi{}, B_eta{};
  for (int a = 0; a < 4; ++a) {
    const auto& node = mesh.nodes[face[a]];
    const auto [xa, ya] = corners[a];
    B = B + (1 + xi * xa) * (1 + eta * ya) / 4 * node;
    B_xi = B_xi + xa * (1 + eta * ya) / 4 * node;
    B_eta = B_eta + (1 + xi * xa) * ya / 4 * node;
  }
  // dX = (1 - X X)/|B| dB: the solid angle of the bilinear face.
  const double length = norm(B);
  return {1 / length * B, std::abs(dot(B, cross(B_xi, B_eta))) / (length * length * length)};
}

double depth_under(const Vector3& normal, const Vector3& X) {
  const Vector3 d = X - normal;
  return dot(d, d) / 2; // by itself, since near the pole 1 - X.n would be rounding
}

Vector3 of_node(const std::vector<double>& displacement, int node) {
  const std::size_t i = 3 * static_cast<std::size_t>(node);
  return {displacement[i], displacement[i + 1], displacement[i + 2]};
}

} // namespace

WedgeContact::WedgeContact(HexahedralSolid& solid_, const WedgeMesh& mesh_, std::vector<Vector3> normals,
                           NewtonSettings settings_, const ContactStiffness& rule)
    : solid(solid_), mesh(mesh_), settings(settings_), stiffness_rule(rule) {
  number_unknowns();
  // To begin with: Hertz's mean pressure at a contact radius of `pole`.
  const double E = material::initial_E(solid.model), nu = material::initial_nu(solid.model);
  pressure_scale = 4 / (3 * std::numbers::pi) * E / (1 - nu * nu) * stiffness_rule.pole;
  pressure_scale = std::min(pressure_scale, material::reference_stress(solid.model));

  const auto group = copies(mesh);
  for (const Vector3& normal : normals) {
    Plane& plane = planes.emplace_back();
    plane.normal = normal;
    for (const auto& g : group)
      plane.wedges += norm(Vector3{dot(g[0], normal), dot(g[1], normal), dot(g[2], normal)} - normal) < 1e-9;
    for (int f = 0; f < static_cast<int>(mesh.surface.size()); ++f) {
      std::vector<Point> points;
      double highest = deepest, bulge = 0, whole = 0;
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const auto [X, area] = on_sphere(mesh, mesh.surface[f], gauss_x[i], gauss_x[j]);
          Point& point = points.emplace_back();
          point.face = f;
          point.N = shape(gauss_x[i], gauss_x[j]);
          point.area = area * gauss_w[i] * gauss_w[j];
          point.depth = 0;
          for (int a = 0; a < 4; ++a)
            point.depth += point.N[a] * depth_under(normal, mesh.nodes[mesh.surface[f][a]]);
          const double depth = depth_under(normal, X),
                       distance = std::max(std::sqrt(2 * depth), stiffness_rule.pole);
          point.flexibility = stiffness_rule.relative_penetration * distance * distance;
          point.least_stiffness = stiffness_rule.elastic * E / distance;
          highest = std::min(highest, depth);
          bulge += point.area * (point.depth - depth);
          whole += point.area;
        }
      for (Point& point : points) {
        point.depth -= bulge / whole;
        point.misfit = bulge / whole;
      }
      if (highest < deepest) plane.points.insert(plane.points.end(), points.begin(), points.end());
    }
  }
  std::vector<std::vector<int>> touching_node(mesh.nodes.size());
  for (int e = 0; e < static_cast<int>(mesh.hexes.size()); ++e)
    for (const int node : mesh.hexes[e]) touching_node[node].push_back(e);
  for (const auto& face : mesh.surface) {
    FaceElement& at = face_elements.emplace_back();
    for (const int e : touching_node[face[0]]) {
      const auto& hex = mesh.hexes[e];
      bool all = true;
      for (int k = 0; k < 4; ++k) {
        const auto place = std::find(hex.begin(), hex.end(), face[k]);
        all = all && place != hex.end();
        at.corner[k] = static_cast<int>(place - hex.begin());
      }
      at.element = e;
      if (all) break;
    }
  }
}

/// A node on mirrors keeps to the directions that lie in all of them.
void WedgeContact::number_unknowns() {
  std::vector<std::vector<Vector3>> held(mesh.nodes.size()); // orthonormal
  for (std::size_t m = 0; m < mesh.mirrors.size(); ++m)
    for (const int node : mesh.on_mirror[m]) {
      Vector3 n = mesh.mirrors[m];
      for (const auto& h : held[node]) n = n - dot(n, h) * h;
      if (norm(n) > 1e-6) held[node].push_back(unit(n));
    }
  int unknown = 0;
  for (auto basis : held) {
    Free& f = free_of.emplace_back();
    f.first = unknown;
    if (basis.size() == 2) f.along[f.count++] = unit(cross(basis[0], basis[1]));
    else
      for (int k = 0; k < 3 && basis.size() < 3; ++k) {
        Vector3 n{};
        n[k] = 1;
        for (const auto& h : basis) n = n - dot(n, h) * h;
        if (norm(n) < 0.5) continue;
        basis.push_back(f.along[f.count++] = unit(n));
      }
    unknown += f.count;
  }
  u.assign(unknown, 0.0);
  free_force.assign(unknown, 0.0);
  std::vector<std::vector<int>> lists;
  std::size_t entries = 0;
  for (const auto& hex : mesh.hexes) {
    auto& list = lists.emplace_back();
    bool all = true;
    for (const int node : hex) {
      for (int k = 0; k < free_of[node].count; ++k) list.push_back(free_of[node].first + k);
      all = all && held[node].empty();
    }
    plain.push_back(all);
    entries += list.size() * list.size();
  }
  matrices.assign(entries, 0.0);
  solver = std::make_unique<LaggedSolver>(unknown, std::move(lists));
}

std::vector<double> WedgeContact::expand(const std::vector<double>& x) const {
  std::vector<double> displacement(3 * mesh.nodes.size());
  for (std::size_t n = 0; n < free_of.size(); ++n)
    for (int k = 0; k < free_of[n].count; ++k)
      for (int i = 0; i < 3; ++i) displacement[3 * n + i] += x[free_of[n].first + k] * free_of[n].along[k][i];
  return displacement;
}

/// Force over penetration: that of fe/plane_contact.hpp, but no stiffer than lets a face take the place of
/// the sphere over it at the pressure scale.
double WedgeContact::stiffness_of(const Point& point) const {
  const double sphere = std::max(pressure_scale / point.flexibility, point.least_stiffness);
  return std::min(sphere, pressure_scale / point.misfit) * point.area;
}

double WedgeContact::gap(const Plane& plane, const Point& point,
                         const std::vector<double>& displacement) const {
  double distance = point.depth - (1 - plane.height);
  for (int k = 0; k < 4; ++k)
    distance -= point.N[k] * dot(of_node(displacement, mesh.surface[point.face][k]), plane.normal);
  return distance;
}

Evaluation WedgeContact::evaluate(const std::vector<double>& x, Residual& residual) {
  const std::vector<double> displacement = expand(x);
  const Evaluation evaluation = solid.evaluate(displacement);
  if (evaluation != Evaluation::done) return evaluation;
  residual.touching.clear();
  for (const Plane& plane : planes)
    for (const Point& point : plane.points) {
      const double distance = gap(plane, point, displacement);
      residual.touching.push_back(distance < 0);
      if (!(distance < 0)) continue;
      const double force = -stiffness_of(point) * distance;
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i)
          solid.force[3 * mesh.surface[point.face][k] + i] += force * point.N[k] * plane.normal[i];
    }
  double all = 0, free = 0;
  for (const double f : solid.force) all += f * f;
  for (std::size_t n = 0; n < free_of.size(); ++n)
    for (int k = 0; k < free_of[n].count; ++k) {
      double& f = free_force[free_of[n].first + k];
      f = dot(of_node(solid.force, static_cast<int>(n)), free_of[n].along[k]);
      free += f * f;
    }
  residual.force = free_force;
  residual.relative = relative_residual(solid.model, settings, free, all - free);
  return std::isfinite(residual.relative) ? Evaluation::done : Evaluation::inverted_element;
}

bool WedgeContact::linearise(const Residual& residual) {
  solid.linearise();
  std::size_t index = 0;
  for (const Plane& plane : planes)
    for (const Point& point : plane.points) {
      if (!residual.touching[index++]) continue;
      const auto& [element, corner] = face_elements[point.face];
      double* K = &solid.tangent[576 * static_cast<std::size_t>(element)];
      const double stiffness = stiffness_of(point);
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l)
          for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
              K[24 * (3 * corner[l] + j) + 3 * corner[k] + i] +=
                  stiffness * point.N[k] * point.N[l] * plane.normal[i] * plane.normal[j];
    }
  {
    Stopwatch watch(solid.times.assembly_s);
    reduce();
  }
  const bool regular = solver->matrix(matrices);
  solid.times.factorisation_s = solver->factorisation_s;
  return regular;
}

/// The element matrices of the unknowns.
void WedgeContact::reduce() {
  double* into = matrices.data();
  for (std::size_t e = 0; e < mesh.hexes.size(); ++e) {
    const double* K = &solid.tangent[576 * e];
    if (plain[e]) {
      into = std::copy(K, K + 576, into);
      continue;
    }
    const auto& hex = mesh.hexes[e];
    for (int b = 0; b < 8; ++b)
      for (int l = 0; l < free_of[hex[b]].count; ++l) {
        const Vector3& d = free_of[hex[b]].along[l];
        double column[24];
        for (int i = 0; i < 24; ++i)
          column[i] =
              K[24 * (3 * b) + i] * d[0] + K[24 * (3 * b + 1) + i] * d[1] + K[24 * (3 * b + 2) + i] * d[2];
        for (int a = 0; a < 8; ++a)
          for (int k = 0; k < free_of[hex[a]].count; ++k) {
            const Vector3& c = free_of[hex[a]].along[k];
            *into++ = c[0] * column[3 * a] + c[1] * column[3 * a + 1] + c[2] * column[3 * a + 2];
          }
      }
  }
}

bool WedgeContact::solve_linear(std::span<double> x) {
  const double factorised_s = solver->factorisation_s;
  Stopwatch watch(solid.times.solve_s);
  const bool regular = solver->solve(x);
  solid.times.factorisation_s = solver->factorisation_s;
  solid.times.solve_s -= solver->factorisation_s - factorised_s;
  return regular;
}

StepReport WedgeContact::solve(const std::vector<double>& heights, std::vector<double> x) {
  std::vector<double> before;
  for (int k = 0; k < static_cast<int>(planes.size()); ++k) {
    // Contacts of few faces have no area to speak of; Hertz's is the least.
    const Contact c = contact(k);
    const double square = std::max(c.radius * c.radius, 1 - planes[k].height);
    if (square > 0) pressure_scale = std::max(pressure_scale, c.force / (std::numbers::pi * square));
    before.push_back(planes[k].height);
  }
  for (std::size_t k = 0; k < planes.size(); ++k) planes[k].height = heights[k];
  StepReport report = newton(*this, settings, x);
  if (report.converged) u = std::move(x);
  else
    for (std::size_t k = 0; k < planes.size(); ++k) planes[k].height = before[k];
  return report;
}

void WedgeContact::follow(const std::vector<double>& rise, std::vector<double>& guess) const {
  const std::vector<double> displacement = displacements();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    std::vector<char> moved(mesh.nodes.size(), 0);
    for (const Point& point : planes[k].points)
      if (gap(planes[k], point, displacement) < 0)
        for (const int node : mesh.surface[point.face])
          if (!std::exchange(moved[node], 1)) {
            const Free& f = free_of[node];
            for (int i = 0; i < f.count; ++i)
              guess[f.first + i] += rise[k] * dot(f.along[i], planes[k].normal);
          }
  }
}

std::vector<FacePressure> WedgeContact::pressures(int k) const {
  const Plane& plane = planes[k];
  const std::vector<double> displacement = displacements();
  std::vector<FacePressure> list;
  for (std::size_t first = 0; first < plane.points.size(); first += points_per_face) {
    double force = 0, energy = 0;
    double touching = 0, whole = 0;
    for (std::size_t i = first; i < first + points_per_face; ++i) {
      const double distance = std::min(gap(plane, plane.points[i], displacement), 0.0);
      whole += plane.points[i].area;
      if (distance < 0) touching += plane.points[i].area;
      force -= stiffness_of(plane.points[i]) * distance;
      energy += stiffness_of(plane.points[i]) * distance * distance / 2;
    }
    if (!(force > 0)) continue;
    const int f = plane.points[first].face;
    Vector3 x[4];
    for (int a = 0; a < 4; ++a)
      x[a] = mesh.nodes[mesh.surface[f][a]] + of_node(displacement, mesh.surface[f][a]);
    const double area = std::abs(dot(cross(x[2] - x[0], x[3] - x[1]), plane.normal)) / 2;
    if (area > 0) list.push_back({f, force / area, area, energy, touching / whole});
  }
  return list;
}

// The area is not that of the faces in contact: a face across the contact edge is tilted, lies on the plane
// with its inner side alone, and the radius would be half a face too small. So the area is taken from the
// pressures, in two ways that are exact for different profiles and too small for others; the larger one
// holds.
Contact WedgeContact::contact(int k) const {
  Contact c;
  const auto faces = pressures(k);
  for (const FacePressure& f : faces) {
    c.force += f.pressure * f.area;
    c.energy += f.energy;
    c.peak_pressure = std::max(c.peak_pressure, f.pressure);
  }
  if (!(c.force > 0)) return c;
  const int wedges = planes[k].wedges;
  c.force *= wedges;
  c.energy *= wedges;
  c.radius = std::sqrt(wedges * std::max(spread_area(faces), edge_area(faces)) / std::numbers::pi);
  return c;
}

/// The area over which the force spreads, whatever its shape. With a profile p = p_0 (1 - s)^beta, s the
/// share of the area in which p is larger, int p^n dA = A p_0^n/(n beta + 1), so that
///   A = (int p)^2/int p^2 (beta + 1)^2/(2 beta + 1),
///   int p int p^3/(int p^2)^2 = (2 beta + 1)^2/((beta + 1)(3 beta + 1)).
/// beta is 0 for an even pressure and 1/2 for Hertz's, the most peaked.
double WedgeContact::spread_area(const std::vector<FacePressure>& faces) {
  double force = 0, square = 0, cube = 0;
  for (const auto& [face, p, area, energy, touching] : faces) {
    force += p * area;
    square += p * p * area;
    cube += p * p * p * area;
  }
  const double ratio = std::max(force * cube / (square * square), 1.0);
  const double a = 4 - 3 * ratio, b = 4 * (ratio - 1);
  const double beta = a > 0 ? std::min((b + std::sqrt(b * b + a * b)) / (2 * a), 0.5) : 0.5;
  return force * force / square * (beta + 1) * (beta + 1) / (2 * beta + 1);
}

/// The faces wholly in contact, and of the others the share that touches, or that would carry their force at
/// the pressure of whole neighbours: for a pressure that does not fall towards the contact edge, but may vary
/// inside.
double WedgeContact::edge_area(const std::vector<FacePressure>& faces) const {
  std::vector<double> whole_pressure(mesh.nodes.size(), 0.0), whole_faces(mesh.nodes.size(), 0.0);
  for (const auto& [face, p, area, energy, touching] : faces)
    if (touching == 1)
      for (const int node : mesh.surface[face]) {
        whole_pressure[node] += p;
        whole_faces[node] += 1;
      }
  double sum = 0;
  for (const auto& [face, p, area, energy, touching] : faces) {
    double beside = 0, count = 0;
    for (const int node : mesh.surface[face]) {
      beside += whole_pressure[node];
      count += whole_faces[node];
    }
    const double loaded = count > 0 ? std::min(1.0, p * count / beside) : 0;
    sum += area * std::max(touching, loaded);
  }
  return sum;
}

} // namespace platen::fe
