#pragma once
// A flat drawing of filled shapes, lines and words, written as SVG (by us) or PNG (by gnuplot).
// Lengths in pixels, x to the right, y downwards. Later items cover earlier ones.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace platen::plot {

struct Point {
  double x = 0, y = 0;
};

/// A filled polygon without holes: what lies in a hole is drawn on top of it.
struct Polygon {
  std::vector<Point> ring;
  std::string fill; ///< "#rrggbb"
};

struct Line {
  std::vector<Point> points;
  std::string stroke;
  double width = 1;
};

enum class Anchor { start, middle, end };

struct Text {
  Point at; ///< on the baseline
  std::string words;
  double size = 14;
  Anchor anchor = Anchor::start;
  std::string fill = "#222222";
  bool bold = false;
};

struct Scene {
  double width = 0, height = 0;
  std::string description; ///< for screen readers
  std::vector<std::variant<Polygon, Line, Text>> items;
};

/// Writes by file ending: .svg or .png (which needs gnuplot). Throws InvalidInput for other endings, IoError
/// when the file cannot be written.
void write(const Scene&, const std::filesystem::path& file);

} // namespace platen::plot
