#include "fe/contact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace platen::fe {
namespace {

/// Faces whose points all lie deeper than this under a pole never touch its plane (R0).
constexpr double deepest = 1;

template <std::size_t N> double depth_under(const Vector<N>& normal, const Vector<N>& X) {
  const Vector<N> d = X - normal;
  return dot(d, d) / 2; // by itself, since near the pole 1 - X.n would be rounding
}

template <std::size_t N> Vector<N> of_node(std::span<const double> u, int node) {
  Vector<N> x;
  for (std::size_t i = 0; i < N; ++i) x[i] = u[N * node + i];
  return x;
}

} // namespace

template <class Mesh>
Contact<Mesh>::Contact(const Mesh& mesh_, std::vector<Vector<dim>> normals, std::vector<int> copies,
                       const ContactRule& rule_, const material::Model& model)
    : mesh(mesh_), surface(mesh_), rule(rule_), E(material::initial_E(model)) {
  const double nu = material::initial_nu(model);
  first_pressure =
      std::min(4 / (3 * std::numbers::pi) * E / (1 - nu * nu) * rule.pole, material::reference_stress(model));
  for (std::size_t k = 0; k < normals.size(); ++k) {
    Plane& plane = list.emplace_back(Plane{normals[k], copies[k], {}, {}});
    for (int f = 0; f < static_cast<int>(surface.faces.size()); ++f) {
      const auto& face = surface.faces[f];
      std::array<Point, Surface<Mesh>::points> points;
      double highest = deepest, bulge = 0, whole = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double depth = depth_under(plane.normal, face.point[i].X),
                     distance = std::max(std::sqrt(2 * depth), rule.pole);
        points[i] = {depth, rule.relative_penetration * distance * distance, rule.elastic * E / distance, 0};
        highest = std::min(highest, depth);
        if (!rule.flat_faces) continue;
        points[i].depth = 0;
        for (int a = 0; a < Mesh::face_corners; ++a)
          points[i].depth += face.point[i].N[a] * depth_under(plane.normal, mesh.nodes[face.node[a]]);
        bulge += face.point[i].area * (points[i].depth - depth);
        whole += face.point[i].area;
      }
      if (highest >= deepest) continue;
      if (rule.flat_faces)
        for (Point& point : points) {
          point.depth -= bulge / whole;
          point.misfit = bulge / whole;
        }
      plane.faces.push_back(f);
      plane.points.insert(plane.points.end(), points.begin(), points.end());
    }
  }
}

/// Force over penetration of a point that stands for an area.
template <class Mesh>
double Contact<Mesh>::stiffness(const Point& point, double area, const ContactMemory& memory) const {
  if (rule.uniform) return rule.elastic * E / std::max(memory.largest_radius, rule.pole) * area;
  const double sphere = std::max(memory.pressure_scale / point.flexibility, point.least_stiffness);
  return (point.misfit > 0 ? std::min(sphere, memory.pressure_scale / point.misfit) : sphere) * area;
}

/// Negative where the point penetrates.
template <class Mesh>
double Contact<Mesh>::gap(const Plane& plane, const Point& point, int face, int i, std::span<const double> u,
                          double height) const {
  const auto& at = surface.faces[face];
  double distance = point.depth - (1 - height);
  for (int k = 0; k < Mesh::face_corners; ++k)
    distance -= at.point[i].N[k] * dot(of_node<dim>(u, at.node[k]), plane.normal);
  return distance;
}

template <class Mesh>
Vector<Contact<Mesh>::dim> Contact<Mesh>::now(int node, std::span<const double> u) const {
  return mesh.nodes[node] + of_node<dim>(u, node);
}

template <class Mesh>
ContactMemory Contact<Mesh>::extended(ContactMemory memory, std::span<const ContactPatch> patches,
                                      std::span<const double> heights) const {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const ContactPatch& c = patches[k];
    // Contacts of few faces have no area to speak of; Hertz's is the least.
    const double least = rule.flat_faces && !rule.uniform ? 1 - heights[k] : 0;
    const double square = std::max(c.radius * c.radius, least);
    if (!(square > 0)) continue;
    memory.pressure_scale = std::max(memory.pressure_scale, c.force / (std::numbers::pi * square));
    memory.largest_radius = std::max(memory.largest_radius, c.radius);
  }
  return memory;
}

template <class Mesh>
void Contact<Mesh>::add_forces(std::span<const double> u, std::span<const double> heights,
                               const ContactMemory& memory, std::span<double> force,
                               std::vector<char>& touching) const {
  touching.clear();
  for (std::size_t k = 0; k < list.size(); ++k) {
    const Plane& plane = list[k];
    const Point* point = plane.points.data();
    for (const int f : plane.faces) {
      const auto& face = surface.faces[f];
      for (int i = 0; i < Surface<Mesh>::points; ++i, ++point) {
        const double distance = gap(plane, *point, f, i, u, heights[k]);
        touching.push_back(distance < 0);
        if (!(distance < 0)) continue;
        const double push = -stiffness(*point, face.point[i].area, memory) * distance;
        for (int a = 0; a < Mesh::face_corners; ++a)
          for (int c = 0; c < dim; ++c)
            force[dim * face.node[a] + c] += push * face.point[i].N[a] * plane.normal[c];
      }
    }
  }
}

template <class Mesh>
void Contact<Mesh>::add_tangent(const std::vector<char>& touching, const ContactMemory& memory,
                                std::span<double> matrices) const {
  constexpr int size = dim * Mesh::corners;
  std::size_t index = 0;
  for (const Plane& plane : list) {
    const Point* point = plane.points.data();
    for (const int f : plane.faces) {
      const auto& face = surface.faces[f];
      double* K = &matrices[static_cast<std::size_t>(size * size) * face.element];
      for (int i = 0; i < Surface<Mesh>::points; ++i, ++point) {
        if (!touching[index++]) continue;
        const double k = stiffness(*point, face.point[i].area, memory);
        for (int a = 0; a < Mesh::face_corners; ++a)
          for (int b = 0; b < Mesh::face_corners; ++b)
            for (int c = 0; c < dim; ++c)
              for (int d = 0; d < dim; ++d)
                K[size * (dim * face.corner[b] + d) + dim * face.corner[a] + c] +=
                    k * face.point[i].N[a] * face.point[i].N[b] * plane.normal[c] * plane.normal[d];
      }
    }
  }
}

template <class Mesh>
std::vector<int> Contact<Mesh>::nodes_touching(int k, std::span<const double> u, double height) const {
  const Plane& plane = list[k];
  std::vector<int> nodes;
  const Point* point = plane.points.data();
  for (const int f : plane.faces) {
    bool touches = false;
    for (int i = 0; i < Surface<Mesh>::points; ++i, ++point)
      touches = touches || gap(plane, *point, f, i, u, height) < 0;
    if (touches) nodes.insert(nodes.end(), surface.faces[f].node.begin(), surface.faces[f].node.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

template <class Mesh>
std::vector<FacePressure> Contact<Mesh>::pressures(int k, std::span<const double> u, double height,
                                                   const ContactMemory& memory) const {
  const Plane& plane = list[k];
  std::vector<FacePressure> pressed;
  const Point* point = plane.points.data();
  for (const int f : plane.faces) {
    const auto& face = surface.faces[f];
    FacePressure p{f, 0, 0, 0, 0};
    double force = 0, whole = 0, inner_gap = 0, inner_r = 0;
    for (int i = 0; i < Surface<Mesh>::points; ++i, ++point) {
      const double distance = gap(plane, *point, f, i, u, height), area = face.point[i].area;
      whole += area;
      if constexpr (dim == 2) {
        double r = face.point[i].X[0];
        for (int a = 0; a < 2; ++a) r += face.point[i].N[a] * u[dim * face.node[a]];
        if (distance < 0) p.reach = r;
        else if (i > 0 && inner_gap < 0)
          p.reach = inner_r + (r - inner_r) * inner_gap / (inner_gap - distance);
        inner_gap = distance;
        inner_r = r;
      }
      if (!(distance < 0)) continue;
      p.touching += area;
      const double stiff = stiffness(*point, area, memory);
      force -= stiff * distance;
      p.energy += stiff * distance * distance / 2;
    }
    p.touching /= whole;
    if constexpr (dim == 2) {
      p.inner = now(face.node[0], u)[0];
      p.outer = now(face.node[1], u)[0];
      p.area = std::numbers::pi * (p.outer * p.outer - p.inner * p.inner);
    } else {
      Vector3 x[4];
      for (int a = 0; a < 4; ++a) x[a] = now(face.node[a], u);
      p.area = std::abs(dot(cross(x[2] - x[0], x[3] - x[1]), plane.normal)) / 2;
    }
    if (!(force > 0 && p.area > 0)) continue;
    p.pressure = force / p.area;
    pressed.push_back(p);
  }
  return pressed;
}

template <class Mesh>
ContactPatch Contact<Mesh>::patch(int k, std::span<const double> u, double height,
                                  const ContactMemory& memory) const {
  ContactPatch c;
  const auto faces = pressures(k, u, height, memory);
  for (const FacePressure& f : faces) {
    c.force += f.pressure * f.area;
    c.energy += f.energy;
    c.peak_pressure = std::max(c.peak_pressure, f.pressure);
  }
  if (!(c.force > 0)) return c;
  c.force *= list[k].copies;
  c.energy *= list[k].copies;
  c.radius = std::sqrt(list[k].copies * area_of(faces) / std::numbers::pi);
  return c;
}

/// Of rings: where the surface leaves the plane. (To extrapolate the pressure to zero instead takes for
/// granted that it falls as Hertz's; under a plastic contact it ends abruptly.)
template <> double Contact<SectionMesh>::area_of(const std::vector<FacePressure>& rings) const {
  const int n = static_cast<int>(rings.size());
  const FacePressure& last = rings.back();
  double square = last.reach * last.reach;
  // Of small, nearly elastic contacts: towards the edge p falls as sqrt(a^2 - r^2), so the force outside r as
  // (a^2 - r^2)^{3/2}, and a follows from the forces outside two radii. Single edges near the contact edge
  // will not do: their pressure depends on how it cuts them.
  constexpr int outer = 4, inner = 9; // edges
  if (rule.uniform && n >= inner) {
    double force = 0, outer_force = 0;
    for (int i = n - 1; i >= n - inner; --i) {
      force += rings[i].pressure * rings[i].area;
      if (i == n - outer) outer_force = force;
    }
    const double ratio = std::pow(force / outer_force, 2.0 / 3);
    square =
        (ratio * std::pow(rings[n - outer].inner, 2) - std::pow(rings[n - inner].inner, 2)) / (ratio - 1);
    const double least = rings[n - 2].inner, most = std::max(2 * last.outer - last.inner, least);
    square = std::clamp(square, least * least, most * most);
  }
  return std::numbers::pi * square;
}

// Of faces. The area is not that of the faces in contact: a face across the contact edge is tilted, lies on
// the plane with its inner side alone, and the radius would be half a face too small. So the area is taken
// from the pressures, in two ways that are exact for different profiles and too small for others; the larger
// one holds.
template <> double Contact<WedgeMesh>::area_of(const std::vector<FacePressure>& faces) const {
  return std::max(spread_area(faces), edge_area(faces));
}

/// The area over which the force spreads, whatever its shape. With a profile p = p_0 (1 - s)^beta, s the
/// share of the area in which p is larger, int p^n dA = A p_0^n/(n beta + 1), so that
///   A = (int p)^2/int p^2 (beta + 1)^2/(2 beta + 1),
///   int p int p^3/(int p^2)^2 = (2 beta + 1)^2/((beta + 1)(3 beta + 1)).
/// beta is 0 for an even pressure and 1/2 for Hertz's, the most peaked.
template <class Mesh> double Contact<Mesh>::spread_area(const std::vector<FacePressure>& faces) const {
  double force = 0, square = 0, cube = 0;
  for (const FacePressure& f : faces) {
    force += f.pressure * f.area;
    square += f.pressure * f.pressure * f.area;
    cube += f.pressure * f.pressure * f.pressure * f.area;
  }
  const double ratio = std::max(force * cube / (square * square), 1.0);
  const double a = 4 - 3 * ratio, b = 4 * (ratio - 1);
  const double beta = a > 0 ? std::min((b + std::sqrt(b * b + a * b)) / (2 * a), 0.5) : 0.5;
  return force * force / square * (beta + 1) * (beta + 1) / (2 * beta + 1);
}

/// The faces wholly in contact, and of the others the share that touches, or that would carry their force at
/// the pressure of whole neighbours: for a pressure that does not fall towards the contact edge, but may vary
/// inside.
template <class Mesh> double Contact<Mesh>::edge_area(const std::vector<FacePressure>& faces) const {
  std::vector<double> whole_pressure(mesh.nodes.size(), 0.0), whole_faces(mesh.nodes.size(), 0.0);
  for (const FacePressure& f : faces)
    if (f.touching == 1)
      for (const int node : mesh.surface[f.face]) {
        whole_pressure[node] += f.pressure;
        whole_faces[node] += 1;
      }
  double sum = 0;
  for (const FacePressure& f : faces) {
    double beside = 0, count = 0;
    for (const int node : mesh.surface[f.face]) {
      beside += whole_pressure[node];
      count += whole_faces[node];
    }
    const double loaded = count > 0 ? std::min(1.0, f.pressure * count / beside) : 0;
    sum += f.area * std::max(f.touching, loaded);
  }
  return sum;
}

template class Contact<SectionMesh>;
template class Contact<WedgeMesh>;

} // namespace platen::fe
