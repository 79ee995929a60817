#include "fe/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace platen::fe {
namespace {

// Gauss-Legendre on [-1, 1]: Abramowitz & Stegun, table 25.4.
constexpr std::array<double, 8> x8{-0.960289856497536232, -0.796666477413626740, -0.525532409916328986,
                                   -0.183434642495649805, 0.183434642495649805,  0.525532409916328986,
                                   0.796666477413626740,  0.960289856497536232};
constexpr std::array<double, 8> w8{0.101228536290376259, 0.222381034453374471, 0.313706645877887287,
                                   0.362683783378361983, 0.362683783378361983, 0.313706645877887287,
                                   0.222381034453374471, 0.101228536290376259};
constexpr std::array<double, 4> x4{-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                   0.861136311594052575};
constexpr std::array<double, 4> w4{0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                   0.347854845137453857};
constexpr std::array<std::array<double, 2>, 4> corner_of{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

/// Along the arc between the nodes.
void place(const SectionMesh& mesh, Surface<SectionMesh>::Face& face) {
  const auto angle = [&](int k) {
    return std::atan2(mesh.nodes[face.node[k]][0], mesh.nodes[face.node[k]][1]);
  };
  const double from = angle(0), h = angle(1) - from;
  for (std::size_t i = 0; i < x8.size(); ++i) {
    const double t = (1 + x8[i]) / 2, at = from + t * h;
    face.point[i] = {
        {1 - t, t}, {std::sin(at), std::cos(at)}, 2 * std::numbers::pi * std::sin(at) * h * w8[i] / 2};
  }
}

/// Over the bilinear face, seen from the centre of the sphere.
void place(const WedgeMesh& mesh, Surface<WedgeMesh>::Face& face) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double xi = x4[i], eta = x4[j];
      SurfacePoint<WedgeMesh>& point = face.point[4 * i + j];
      Vector3 B{}, B_xi{}, B_eta{};
      for (int a = 0; a < 4; ++a) {
        const auto& node = mesh.nodes[face.node[a]];
        const auto [xa, ya] = corner_of[a];
        point.N[a] = (1 + xi * xa) * (1 + eta * ya) / 4;
        B = B + point.N[a] * node;
        B_xi = B_xi + xa * (1 + eta * ya) / 4 * node;
        B_eta = B_eta + (1 + xi * xa) * ya / 4 * node;
      }
      // dX = (1 - X X)/|B| dB: the solid angle of the bilinear face.
      const double length = norm(B);
      point.X = 1 / length * B;
      point.area = std::abs(dot(B, cross(B_xi, B_eta))) / (length * length * length) * w4[i] * w4[j];
    }
}

} // namespace

template <class Mesh> Surface<Mesh>::Surface(const Mesh& mesh) {
  std::vector<std::vector<int>> at_node(mesh.nodes.size());
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
    for (const int node : mesh.elements[e]) at_node[node].push_back(e);
  for (const auto& nodes : mesh.surface) {
    Face& face = faces.emplace_back();
    face.node = nodes;
    const auto under = std::find_if(at_node[nodes[0]].begin(), at_node[nodes[0]].end(), [&](int e) {
      const auto& corners = mesh.elements[e];
      for (int k = 0; k < Mesh::face_corners; ++k) {
        const auto at = std::find(corners.begin(), corners.end(), nodes[k]);
        if (at == corners.end()) return false;
        face.corner[k] = static_cast<int>(at - corners.begin());
      }
      return true;
    });
    if (under == at_node[nodes[0]].end()) throw std::logic_error("a face of the surface without an element");
    face.element = *under;
    place(mesh, face);
  }
}

template struct Surface<SectionMesh>;
template struct Surface<WedgeMesh>;

} // namespace platen::fe
