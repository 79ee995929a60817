#pragma once
// A chart as SVG and as CSV.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace platen::reproduce {

inline constexpr int chart_width = 440, chart_height = 360; ///< pixels, as they are drawn

enum class Mark {
  line,   ///< what is ours
  dashed, ///< what is the paper's
  points,
};

struct Series {
  std::string name;
  Mark mark = Mark::line;
  std::vector<double> x, y;
  std::string colour = {}; ///< "#rrggbb"; by default by its place in the chart
};

struct Chart {
  std::string title;
  std::string x_label, y_label; ///< with units
  std::vector<Series> series;
  bool log_x = false, log_y = false;
  std::optional<std::array<double, 2>> y_range = {};
  bool equal_scales = false; ///< of both axes
};

/// Writes FILE.svg and FILE.csv (series,x,y). InvalidInput for a chart without a point, IoError.
void draw(const Chart&, const std::filesystem::path& file);

/// The CSV alone.
std::string csv_text(const Chart&);

} // namespace platen::reproduce
