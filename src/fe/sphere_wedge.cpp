#include "fe/sphere_wedge.hpp"

#include <algorithm>
#include <map>
#include <numbers>

namespace platen::fe {
namespace {

/// Corners of the curved tetrahedron: 0 the centre, 1 to 3 on the sphere.
constexpr int corners = 4;
using Key = std::array<int, corners>; // lattice place of a node, see blocks()

struct Plan {
  std::array<Vector3, corners> corner;
  double radial[corners];          ///< where the edge from the centre to a corner is cut
  double arc[corners][corners];    ///< where the arc from i to j is cut, from i (i < j)
  Vector3 face_through_centre[3];  ///< middles of the faces 0-1-2, 0-1-3, 0-2-3
  Vector3 face_on_sphere, middle;  ///< of 1-2-3 and of all
  Key cells;                       ///< towards each corner
  double growth[corners][corners]; ///< last cell over first on the way from i towards j, up to the cut
};

constexpr double root2 = std::numbers::sqrt2, root3 = std::numbers::sqrt3;
constexpr double shell = 4; // growth from the sphere towards the centre

// Split points of the smaller wedges: moved by an optimiser until the least and the mean scaled Jacobian were
// largest; of the octant: by eye.
Plan plan_of(Wedge wedge) {
  Plan p{};
  for (auto& row : p.growth) std::fill(std::begin(row), std::end(row), 1.0);
  for (int i = 1; i < corners; ++i) p.growth[i][0] = shell;
  switch (wedge) {
  case Wedge::forty_eighth: // A on the axis of the press, B and C between two and three of them
    p.corner = {{{0, 0, 0}, {0, 0, 1}, {0, 1 / root2, 1 / root2}, {1 / root3, 1 / root3, 1 / root3}}};
    p.radial[1] = 0.534, p.radial[2] = 0.527, p.radial[3] = 0.535;
    p.arc[1][2] = 0.572, p.arc[1][3] = 0.511, p.arc[2][3] = 0.424;
    p.face_through_centre[0] = {0, 0.260, 0.501};
    p.face_through_centre[1] = {0.200, 0.200, 0.501};
    p.face_through_centre[2] = {0.152, 0.384, 0.384};
    p.face_on_sphere = {0.217, 0.449, 0.867};
    p.middle = {0.137, 0.280, 0.512};
    p.cells = {10, 8, 14, 14};
    p.growth[1][2] = p.growth[1][3] = 4;
    break;
  case Wedge::sixteenth: // Z, X, and D between X and Y
    p.corner = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1 / root2, 1 / root2, 0}}};
    p.radial[1] = 0.412, p.radial[2] = 0.354, p.radial[3] = 0.357;
    p.arc[1][2] = 0.408, p.arc[1][3] = 0.411, p.arc[2][3] = 0.500;
    p.face_through_centre[0] = {0.269, 0, 0.396};
    p.face_through_centre[1] = {0.192, 0.192, 0.396};
    p.face_through_centre[2] = {0.365, 0.153, 0};
    p.face_on_sphere = {0.606, 0.254, 0.754};
    p.middle = {0.277, 0.118, 0.383};
    p.cells = {10, 14, 12, 12};
    p.growth[1][2] = p.growth[1][3] = 2.5;
    p.growth[2][1] = 2.5, p.growth[2][3] = 1.5;
    break;
  case Wedge::octant: // Z, X, Y
    p.corner = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    p.radial[1] = p.radial[2] = p.radial[3] = 0.40;
    p.arc[1][2] = p.arc[1][3] = p.arc[2][3] = 0.5;
    p.face_through_centre[0] = {0.32, 0, 0.32};
    p.face_through_centre[1] = {0, 0.32, 0.32};
    p.face_through_centre[2] = {0.32, 0.32, 0};
    p.face_on_sphere = {1 / root3, 1 / root3, 1 / root3};
    p.middle = {0.28, 0.28, 0.28};
    p.cells = {10, 12, 12, 12};
    for (int i = 1; i < corners; ++i)
      for (int j = 1; j < corners; ++j)
        if (i != j) p.growth[i][j] = 4;
    break;
  }
  p.face_on_sphere = unit(p.face_on_sphere);
  return p;
}

Vector3 on_arc(const Vector3& from, const Vector3& to, double share) {
  const double angle = std::acos(dot(from, to));
  return 1 / std::sin(angle) * (std::sin((1 - share) * angle) * from + std::sin(share * angle) * to);
}

/// The share of the way reached after i of n cells that grow by `growth` from the first to the last.
double reached(int i, int n, double growth) {
  if (n == 1 || std::abs(growth - 1) < 1e-12) return static_cast<double>(i) / n;
  const double ratio = std::pow(growth, 1.0 / (n - 1));
  return (std::pow(ratio, i) - 1) / (std::pow(ratio, n) - 1);
}

class Builder {
 public:
  Builder(Wedge wedge, int elements) : plan(plan_of(wedge)) {
    const auto count = [](const Key& n) {
      return n[0] * n[1] * n[2] + n[0] * n[1] * n[3] + n[0] * n[2] * n[3] + n[1] * n[2] * n[3];
    };
    const double scale = std::cbrt(static_cast<double>(elements) / count(plan.cells));
    for (int& n : plan.cells) n = std::max(2, static_cast<int>(std::lround(n * scale)));
  }

  WedgeMesh operator()() {
    for (int p = 0; p < corners; ++p) block(p);
    mirrors();
    return std::move(mesh);
  }

 private:
  /// Middle of the edge, face or body between some corners.
  Vector3 middle(const std::vector<int>& of) const {
    if (of.size() == 1) return plan.corner[of[0]];
    if (of.size() == 4) return plan.middle;
    if (of.size() == 2)
      return of[0] == 0 ? plan.radial[of[1]] * plan.corner[of[1]]
                        : on_arc(plan.corner[of[0]], plan.corner[of[1]], plan.arc[of[0]][of[1]]);
    if (of[0] != 0) return plan.face_on_sphere;
    return plan.face_through_centre[of[1] == 1 ? of[2] - 2 : 2];
  }

  /// The block at a corner: a lattice with n[q] cells towards each other corner q, as far as the cuts. A node
  /// has the key of its places towards the other corners, and n[p] for its own; blocks that share it agree.
  void block(int p) {
    std::array<int, 3> to{};
    for (int q = 0, k = 0; q < corners; ++q)
      if (q != p) to[k++] = q;
    const std::array<int, 3> n{plan.cells[to[0]], plan.cells[to[1]], plan.cells[to[2]]};
    const auto node = [&](int i, int j, int k) {
      Key key;
      key[p] = plan.cells[p];
      key[to[0]] = i, key[to[1]] = j, key[to[2]] = k;
      const auto [at, fresh] = number.try_emplace(key, static_cast<int>(mesh.nodes.size()));
      if (fresh) {
        mesh.nodes.push_back(place(p, to, n, {i, j, k}));
        keys.push_back(key);
      }
      return at->second;
    };
    const bool right_handed = dot(cross(middle({std::min(p, to[0]), std::max(p, to[0])}) - plan.corner[p],
                                        middle({std::min(p, to[1]), std::max(p, to[1])}) - plan.corner[p]),
                                  middle({std::min(p, to[2]), std::max(p, to[2])}) - plan.corner[p]) > 0;
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i) {
          std::array<int, 8> hex = {
              node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
              node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
          if (!right_handed) {
            std::swap(hex[1], hex[3]);
            std::swap(hex[5], hex[7]);
          }
          mesh.elements.push_back(hex);
          // The way to the centre is the first.
          if (p != 0 && i == 0) {
            std::array<int, 4> face = {node(0, j, k), node(0, j + 1, k), node(0, j + 1, k + 1),
                                       node(0, j, k + 1)};
            const auto& x = mesh.nodes;
            if (dot(cross(x[face[1]] - x[face[0]], x[face[3]] - x[face[0]]), x[face[0]]) < 0)
              std::swap(face[1], face[3]);
            mesh.surface.push_back(face);
          }
        }
  }

  /// Trilinear between the eight middles, with the sphere's bulge fading towards the inside. Ways along the
  /// same direction are graded alike where blocks share them.
  Vector3 place(int p, const std::array<int, 3>& to, const std::array<int, 3>& n,
                const std::array<int, 3>& at) const {
    double share[3];
    for (int d = 0; d < 3; ++d) {
      const int r = (d + 1) % 3, s = (d + 2) % 3;
      const double a = static_cast<double>(at[r]) / n[r], b = static_cast<double>(at[s]) / n[s];
      share[d] = 0;
      for (const int far_r : {0, 1})
        for (const int far_s : {0, 1}) {
          double growth = plan.growth[p][to[d]];
          if (far_r) growth *= plan.growth[to[r]][to[d]];
          if (far_s) growth *= plan.growth[to[s]][to[d]];
          growth = std::pow(growth, 1.0 / (1 + far_r + far_s));
          share[d] += (far_r ? a : 1 - a) * (far_s ? b : 1 - b) * reached(at[d], n[d], growth);
        }
    }
    const auto corner = [&](int i, int j, int k) {
      std::vector<int> of{p};
      if (i) of.push_back(to[0]);
      if (j) of.push_back(to[1]);
      if (k) of.push_back(to[2]);
      std::sort(of.begin(), of.end());
      return middle(of);
    };
    const auto mix = [](const Vector3& a, const Vector3& b, double t) { return (1 - t) * a + t * b; };
    const auto layer = [&](int i) {
      return mix(mix(corner(i, 0, 0), corner(i, 1, 0), share[1]),
                 mix(corner(i, 0, 1), corner(i, 1, 1), share[1]), share[2]);
    };
    const Vector3 near = layer(0), far = layer(1);
    if (p == 0) return mix(near, far, share[0]);
    return mix(unit(near), far, share[0]); // to[0] is the centre
  }

  /// The mirror opposite to a corner on the sphere has the nodes with place 0 towards it.
  void mirrors() {
    for (int q = 1; q < corners; ++q) {
      const int r = q % 3 + 1, s = r % 3 + 1;
      const Vector3 normal = unit(cross(plan.corner[r], plan.corner[s]));
      auto& [along, list] = mesh.mirrors.emplace_back();
      along = normal;
      for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i][q] == 0) {
          list.push_back(static_cast<int>(i));
          mesh.nodes[i] = mesh.nodes[i] - dot(mesh.nodes[i], normal) * normal; // off by rounding at most
        }
    }
  }

  Plan plan;
  WedgeMesh mesh;
  std::map<Key, int> number;
  std::vector<Key> keys;
};

} // namespace

WedgeMesh sphere_wedge(Wedge wedge, int elements) { return Builder(wedge, elements)(); }

std::vector<std::array<Vector3, 3>> copies(const WedgeMesh& mesh) {
  using Matrix = std::array<Vector3, 3>;
  std::vector<Matrix> group = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (std::size_t known = 0; known < group.size(); ++known)
    for (const auto& [n, nodes] : mesh.mirrors) {
      Matrix product; // the reflection after the known one
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          double along = 0;
          for (int k = 0; k < 3; ++k) along += n[k] * group[known][k][j];
          product[i][j] = group[known][i][j] - 2 * n[i] * along;
        }
      const bool fresh = std::none_of(group.begin(), group.end(), [&](const Matrix& m) {
        double difference = 0;
        for (int i = 0; i < 3; ++i) difference += norm(m[i] - product[i]);
        return difference < 1e-6;
      });
      if (fresh) group.push_back(product);
    }
  return group;
}

MeshQuality quality(const WedgeMesh& mesh, const std::vector<double>& u) {
  // The three neighbours of each corner, right-handed.
  constexpr int neighbours[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                    {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  MeshQuality q{1, 0};
  for (const auto& hex : mesh.elements) {
    Vector3 x[8];
    for (int a = 0; a < 8; ++a)
      x[a] = mesh.nodes[hex[a]] + Vector3{u[3 * hex[a]], u[3 * hex[a] + 1], u[3 * hex[a] + 2]};
    double least = 1;
    for (int a = 0; a < 8; ++a) {
      const Vector3 e = unit(x[neighbours[a][0]] - x[a]), f = unit(x[neighbours[a][1]] - x[a]),
                    g = unit(x[neighbours[a][2]] - x[a]);
      least = std::min(least, dot(cross(e, f), g));
    }
    q.least = std::min(q.least, least);
    q.mean += least / static_cast<double>(mesh.elements.size());
  }
  return q;
}

} // namespace platen::fe
