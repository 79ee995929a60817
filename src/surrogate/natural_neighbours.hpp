#pragma once
// Natural neighbours (Sibson 1981) in one to four dimensions. A place takes a part of the Voronoi cell of
// each site around it, were it a site as well; the share of a site is the part that is taken from it.
//
// Sites and shares: exact at the sites, linear functions are met, continuous, no length to be chosen. The
// cells are not cut. Each simplex T of the Delaunay triangulation is split into the parts that are nearest to
// its corners; of corner i, with beta_v(s) the barycentric coordinate of v in the circumcentre of s,
//   |T| sum over chains {i} = s_0 < s_1 < ... < s_d = T  prod_k beta_{s_k \ s_{k-1}}(s_k),
// and what i loses is that of the simplices that the place destroys less that of those that it makes.
//
// On a grid many sites lie on one sphere, and how it is triangulated is open. So places are sheared by a
// thousandth first, all pairs of axes to one side: then every box falls into d! simplices (Kuhn's), and
// nothing is left to rounding. It is as if the metric differed by a thousandth.

#include "surrogate/process.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace platen::surrogate {

inline constexpr std::size_t most_dimensions = 4;

struct Share {
  std::size_t site;
  double share;
};

class NaturalNeighbours {
 public:
  /// Coordinates are expected in about [0, 1]. InvalidInput: not one to four of them, sites at one place, or
  /// all in one plane.
  explicit NaturalNeighbours(const Inputs& sites);

  /// Positive, of sum 1; none outside of the hull of the sites. On the hull those of its plane alone have a
  /// share: natural neighbours there, in one dimension less.
  std::vector<Share> shares(std::span<const double> at) const;

 private:
  using Point = std::array<double, most_dimensions>;
  /// Corners in falling order, 16 bits each: of a face of a simplex.
  using Face = std::uint64_t;
  struct Simplex {
    std::array<std::size_t, most_dimensions + 1> corners;
    Point centre;
    double radius2;
    std::array<double, most_dimensions + 1> nearest; ///< volume of the part nearest to each corner
  };
  /// Of the hull, with the unit normal outwards: normal.x = offset.
  struct Side {
    std::array<std::size_t, most_dimensions> corners;
    Point normal, centre;
    double offset, radius2;
  };
  struct Circumsphere;

  Point sheared(std::span<const double> at) const;
  Circumsphere circumsphere(std::span<const Point* const> corners) const;
  Simplex simplex_of(std::span<const std::size_t> corners) const;
  void nearest_parts(std::span<const Point* const> corners, std::span<double> parts) const;
  Side side_of(std::span<const std::size_t> corners) const;
  double beyond(const Side&, const Point&) const;
  double distance2(const Point&, const Point&) const;
  bool destroys(const Side&, const Point&) const;
  /// Faces that one of the simplices has alone.
  std::vector<Face> open_faces(std::vector<Face>& faces) const;
  void add_faces(std::vector<Face>& faces, std::span<const std::size_t> corners) const;
  void insert(std::size_t site);
  std::vector<Share> shares_on(const Side&, std::span<const double> at) const;

  std::size_t d_;
  Inputs sites_;
  std::vector<Point> points_; ///< sheared
  Point middle_{};            ///< inside
  std::vector<Simplex> simplices_;
  std::vector<Side> sides_;
};

} // namespace platen::surrogate
