#include "surrogate/natural_neighbours.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

constexpr double flat = 1e-11;      ///< distance from a plane, or of two places, that counts as none
constexpr std::size_t far = 0xffff; ///< the corner at infinity of what lies beyond a side

} // namespace

/// Of up to five corners, in their own plane.
struct NaturalNeighbours::Circumsphere {
  Point centre{};
  double radius2 = 0;
  double volume = 0;                              ///< of their simplex
  std::array<double, most_dimensions + 1> beta{}; ///< barycentric coordinates of the centre
};

NaturalNeighbours::Circumsphere NaturalNeighbours::circumsphere(std::span<const Point* const> corners) const {
  // Edges from the first corner, E = Q R; the centre is c = Q y with R^T y = |e|^2 / 2, and R beta = y.
  const std::size_t n = corners.size() - 1;
  std::array<Point, most_dimensions> Q;
  std::array<std::array<double, most_dimensions>, most_dimensions> R;
  std::array<double, most_dimensions> y;
  Circumsphere s;
  s.centre = *corners[0];
  s.volume = 1;
  for (std::size_t j = 0; j < n; ++j) {
    double half = 0;
    for (std::size_t k = 0; k < d_; ++k) {
      Q[j][k] = (*corners[j + 1])[k] - (*corners[0])[k];
      half += Q[j][k] * Q[j][k] / 2;
    }
    for (std::size_t i = 0; i < j; ++i) {
      double dot = 0;
      for (std::size_t k = 0; k < d_; ++k) dot += Q[i][k] * Q[j][k];
      for (std::size_t k = 0; k < d_; ++k) Q[j][k] -= dot * Q[i][k];
      R[i][j] = dot;
      half -= dot * y[i];
    }
    double norm = 0;
    for (std::size_t k = 0; k < d_; ++k) norm += Q[j][k] * Q[j][k];
    norm = std::sqrt(norm);
    for (std::size_t k = 0; k < d_; ++k) Q[j][k] /= norm;
    R[j][j] = norm;
    y[j] = half / norm;
    for (std::size_t k = 0; k < d_; ++k) s.centre[k] += y[j] * Q[j][k];
    s.radius2 += y[j] * y[j];
    s.volume *= norm / static_cast<double>(j + 1);
  }
  s.beta[0] = 1;
  for (std::size_t j = n; j-- > 0;) {
    double sum = y[j];
    for (std::size_t i = j + 1; i < n; ++i) sum -= R[j][i] * s.beta[i + 1];
    s.beta[j + 1] = sum / R[j][j];
    s.beta[0] -= s.beta[j + 1];
  }
  return s;
}

void NaturalNeighbours::nearest_parts(std::span<const Point* const> corners, std::span<double> parts) const {
  const std::size_t n = corners.size(), subsets = std::size_t{1} << n;
  std::array<std::array<double, most_dimensions + 1>, 32> chains; // of a subset, from each of its corners
  double volume = 1;
  for (std::size_t subset = 1; subset < subsets; ++subset) {
    std::array<const Point*, most_dimensions + 1> of{};
    std::array<std::size_t, most_dimensions + 1> which;
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i)
      if (subset >> i & 1) of[count] = corners[i], which[count++] = i;
    if (count == 1) {
      chains[subset][which[0]] = 1;
      continue;
    }
    std::array<double, most_dimensions + 1> beta{0.5, 0.5};
    if (count > 2 || subset + 1 == subsets) {
      const auto s = circumsphere({of.data(), count});
      beta = s.beta;
      volume = s.volume;
    }
    for (std::size_t a = 0; a < count; ++a) {
      double sum = 0;
      for (std::size_t b = 0; b < count; ++b)
        if (b != a) sum += beta[b] * chains[subset & ~(std::size_t{1} << which[b])][which[a]];
      chains[subset][which[a]] = sum;
    }
  }
  for (std::size_t i = 0; i < n; ++i) parts[i] = volume * chains[subsets - 1][i];
}

double NaturalNeighbours::distance2(const Point& x, const Point& y) const {
  double sum = 0;
  for (std::size_t k = 0; k < d_; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
  return sum;
}

double NaturalNeighbours::beyond(const Side& side, const Point& x) const {
  double sum = -side.offset;
  for (std::size_t k = 0; k < d_; ++k) sum += side.normal[k] * x[k];
  return sum;
}

bool NaturalNeighbours::destroys(const Side& side, const Point& x) const {
  const double past = beyond(side, x);
  return past > flat || (past > -flat && distance2(x, side.centre) < side.radius2);
}

NaturalNeighbours::Point NaturalNeighbours::sheared(std::span<const double> at) const {
  // One sign, and no two alike.
  constexpr double shear[] = {1.000e-3, 1.123e-3, 0.917e-3, 1.271e-3, 0.859e-3, 1.049e-3};
  Point x{};
  std::size_t pair = 0;
  for (std::size_t k = 0; k < d_; ++k) x[k] = at[k];
  for (std::size_t k = 0; k < d_; ++k)
    for (std::size_t l = k + 1; l < d_; ++l) x[k] -= shear[pair++] * at[l];
  return x;
}

NaturalNeighbours::Simplex NaturalNeighbours::simplex_of(std::span<const std::size_t> corners) const {
  Simplex simplex{};
  std::array<const Point*, most_dimensions + 1> of{};
  for (std::size_t i = 0; i <= d_; ++i) of[i] = &points_[simplex.corners[i] = corners[i]];
  const auto s = circumsphere({of.data(), d_ + 1});
  simplex.centre = s.centre;
  simplex.radius2 = s.radius2;
  nearest_parts({of.data(), d_ + 1}, simplex.nearest);
  return simplex;
}

NaturalNeighbours::Side NaturalNeighbours::side_of(std::span<const std::size_t> corners) const {
  Side side{};
  std::array<const Point*, most_dimensions> of{};
  for (std::size_t i = 0; i < d_; ++i) of[i] = &points_[side.corners[i] = corners[i]];
  const auto s = circumsphere({of.data(), d_});
  side.centre = s.centre;
  side.radius2 = s.radius2;
  // The normal: what of the way from the middle to a corner is left without the edges, which are orthogonal
  // already after another circle (twice, for rounding).
  std::vector<Point> edges;
  for (std::size_t i = 1; i < d_; ++i) {
    Point edge = *of[i];
    for (std::size_t k = 0; k < d_; ++k) edge[k] -= (*of[0])[k];
    edges.push_back(edge);
  }
  Point normal = *of[0];
  for (std::size_t k = 0; k < d_; ++k) normal[k] -= middle_[k];
  edges.push_back(normal);
  for (std::size_t j = 0; j < d_; ++j) {
    for (int twice = 0; twice < 2; ++twice)
      for (std::size_t i = 0; i < j; ++i) {
        double dot = 0;
        for (std::size_t k = 0; k < d_; ++k) dot += edges[i][k] * edges[j][k];
        for (std::size_t k = 0; k < d_; ++k) edges[j][k] -= dot * edges[i][k];
      }
    const double norm = std::sqrt(distance2(edges[j], Point{}));
    for (std::size_t k = 0; k < d_; ++k) edges[j][k] /= norm;
  }
  side.normal = edges.back();
  for (std::size_t k = 0; k < d_; ++k) side.offset += side.normal[k] * (*of[0])[k];
  return side;
}

void NaturalNeighbours::add_faces(std::vector<Face>& faces, std::span<const std::size_t> corners) const {
  std::array<std::size_t, most_dimensions + 1> sorted{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    std::size_t j = i;
    for (; j > 0 && sorted[j - 1] < corners[i]; --j) sorted[j] = sorted[j - 1];
    sorted[j] = corners[i];
  }
  for (std::size_t without = 0; without < corners.size(); ++without) {
    Face face = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (i != without) face = face << 16 | sorted[i];
    faces.push_back(face);
  }
}

std::vector<NaturalNeighbours::Face> NaturalNeighbours::open_faces(std::vector<Face>& faces) const {
  std::sort(faces.begin(), faces.end());
  std::vector<Face> open;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t next = i + 1;
    while (next < faces.size() && faces[next] == faces[i]) ++next;
    if (next == i + 1) open.push_back(faces[i]);
    i = next;
  }
  return open;
}

namespace {

template <std::size_t n> std::array<std::size_t, n + 1> corners_of(std::uint64_t face, std::size_t d) {
  std::array<std::size_t, n + 1> corners{};
  for (std::size_t i = 0; i < d; ++i) corners[i] = face >> (16 * (d - 1 - i)) & 0xffff;
  return corners;
}

} // namespace

/// Bowyer & Watson: what the site destroys leaves a hole; its open faces and the site fill it.
void NaturalNeighbours::insert(std::size_t site) {
  const Point& x = points_[site];
  std::vector<Face> faces;
  std::erase_if(simplices_, [&](const Simplex& s) {
    if (!(distance2(x, s.centre) < s.radius2)) return false;
    add_faces(faces, {s.corners.data(), d_ + 1});
    return true;
  });
  std::erase_if(sides_, [&](const Side& s) {
    if (!destroys(s, x)) return false;
    std::array<std::size_t, most_dimensions + 1> corners{};
    std::copy_n(s.corners.begin(), d_, corners.begin());
    corners[d_] = far;
    add_faces(faces, {corners.data(), d_ + 1});
    return true;
  });
  for (const Face face : open_faces(faces)) {
    auto corners = corners_of<most_dimensions>(face, d_);
    if (corners[0] == far) {
      corners[0] = site;
      sides_.push_back(side_of({corners.data(), d_}));
    } else {
      corners[d_] = site;
      simplices_.push_back(simplex_of({corners.data(), d_ + 1}));
    }
  }
}

NaturalNeighbours::NaturalNeighbours(const Inputs& sites) : d_(sites.dimensions), sites_(sites) {
  if (d_ < 1 || d_ > most_dimensions || sites.size() <= d_ || sites.size() >= far)
    throw core::InvalidInput(fmt::format("natural neighbours: {} sites in {} dimensions; one to {} "
                                         "dimensions, and more sites than dimensions, are wanted",
                                         sites.size(), d_, most_dimensions));
  for (std::size_t i = 0; i < sites.size(); ++i) points_.push_back(sheared(sites.row(i)));
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (distance2(points_[i], points_[j]) < flat * flat)
        throw core::InvalidInput(
            fmt::format("natural neighbours: sites {} and {} are at one place", j + 1, i + 1));
  // A simplex to begin with: the corner that is farthest from the plane of those before.
  std::vector<std::size_t> first = {0};
  std::vector<Point> left = points_;
  for (auto& x : left)
    for (std::size_t k = 0; k < d_; ++k) x[k] -= points_[0][k];
  while (first.size() <= d_) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
      if (distance2(left[i], Point{}) > distance2(left[farthest], Point{})) farthest = i;
    const double square = distance2(left[farthest], Point{});
    if (!(square > 1e-16))
      throw core::InvalidInput(fmt::format("natural neighbours: the {} sites lie in a plane of fewer than {} "
                                           "dimensions",
                                           sites.size(), d_));
    const Point direction = left[farthest];
    for (auto& x : left) {
      double dot = 0;
      for (std::size_t k = 0; k < d_; ++k) dot += x[k] * direction[k];
      for (std::size_t k = 0; k < d_; ++k) x[k] -= dot / square * direction[k];
    }
    first.push_back(farthest);
  }
  for (const std::size_t i : first)
    for (std::size_t k = 0; k < d_; ++k) middle_[k] += points_[i][k] / static_cast<double>(d_ + 1);
  simplices_.push_back(simplex_of(first));
  for (std::size_t without = 0; without <= d_; ++without) {
    auto corners = first;
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(without));
    sides_.push_back(side_of(corners));
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (std::find(first.begin(), first.end(), i) == first.end()) insert(i);
}

std::vector<Share> NaturalNeighbours::shares_on(const Side& side, std::span<const double> at) const {
  // Coordinates in the plane: all but the one that the normal points along most.
  std::size_t dropped = 0;
  for (std::size_t k = 0; k < d_; ++k)
    if (std::abs(side.normal[k]) > std::abs(side.normal[dropped])) dropped = k;
  const auto kept = [&](std::span<const double> x) {
    std::vector<double> in_plane;
    for (std::size_t k = 0; k < d_; ++k)
      if (k != dropped) in_plane.push_back(x[k]);
    return in_plane;
  };
  Inputs plane{d_ - 1, {}};
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!(std::abs(beyond(side, points_[i])) < flat)) continue;
    which.push_back(i);
    for (const double x : kept(sites_.row(i))) plane.values.push_back(x);
  }
  auto shares = NaturalNeighbours(plane).shares(kept(at));
  for (auto& share : shares) share.site = which[share.site];
  return shares;
}

std::vector<Share> NaturalNeighbours::shares(std::span<const double> at) const {
  const Point x = sheared(at);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (distance2(x, points_[i]) < flat * flat) return {{i, 1}};
  const Side* on = nullptr;
  for (const Side& side : sides_) {
    const double past = beyond(side, x);
    if (past > flat) return {};
    if (past > -flat) on = &side;
  }
  if (on) return shares_on(*on, at);
  std::vector<double> taken(points_.size());
  std::vector<Face> faces;
  for (const Simplex& s : simplices_) {
    if (!(distance2(x, s.centre) < s.radius2)) continue;
    add_faces(faces, {s.corners.data(), d_ + 1});
    for (std::size_t i = 0; i <= d_; ++i) taken[s.corners[i]] += s.nearest[i];
  }
  double all = 0;
  for (const Face face : open_faces(faces)) {
    const auto corners = corners_of<most_dimensions>(face, d_);
    std::array<const Point*, most_dimensions + 1> of{};
    std::array<double, most_dimensions + 1> parts;
    for (std::size_t i = 0; i < d_; ++i) of[i] = &points_[corners[i]];
    of[d_] = &x;
    nearest_parts({of.data(), d_ + 1}, parts);
    for (std::size_t i = 0; i < d_; ++i) taken[corners[i]] -= parts[i];
    all += parts[d_];
  }
  std::vector<Share> shares;
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i] != 0) shares.push_back({i, taken[i] / all});
  return shares;
}

} // namespace platen::surrogate
