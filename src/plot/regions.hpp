#pragma once
// A patchwork of coloured cells becomes a few outlines: one ring for each connected patch of one colour.
// This keeps a picture of 5,000 elements small, and free of seams between cells.

#include "plot/scene.hpp"
#include "press/result.hpp"

#include <array>
#include <functional>
#include <vector>

namespace platen::plot {

/// Colour of the quarter of an element that belongs to one of its corners.
using Colour = std::function<int(std::size_t element, std::size_t corner)>;

struct Patchwork {
  struct Cell {
    std::array<int, 4> corners; ///< counter-clockwise
    int colour = 0;
  };
  std::vector<Point> vertices;
  std::vector<Cell> cells;
};

/// Quarters of the elements of a snapshot, mirrored to the full section: axis and equator become inner lines.
Patchwork full_section(const press::Snapshot&, const Colour&);

/// Outline of one patch of one colour. What lies in a hole of it has less area.
struct Region {
  int colour = 0;
  double area = 0;
  std::vector<Point> ring; ///< counter-clockwise
};

/// All patches, the larger first: painted in this order none needs a hole.
std::vector<Region> regions(const Patchwork&);

/// The ring without vertices closer than `tolerance` to the line between their neighbours.
std::vector<Point> simplified(const std::vector<Point>& ring, double tolerance);

} // namespace platen::plot
