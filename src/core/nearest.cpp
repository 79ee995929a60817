#include "core/nearest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace platen::core {

int edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  };
  const std::size_t n = b.size();
  std::vector<int> two_up(n + 1), up(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_up.swap(up);
    up.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      row[j] = std::min({up[j] + 1, row[j - 1] + 1, up[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1)});
      if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
        row[j] = std::min(row[j], two_up[j - 2] + 1);
    }
  }
  return row[n];
}

std::string nearest(std::string_view written, std::span<const std::string> known) {
  // A name that is wholly different is no suggestion, and a very long one is not worth the comparison.
  constexpr std::size_t longest = 200;
  if (written.size() > longest) return {};
  std::string best;
  int best_distance = std::max<int>(1, static_cast<int>(written.size()) / 2) + 1;
  for (const auto& name : known)
    if (const int distance = edit_distance(written, name); distance < best_distance) {
      best = name;
      best_distance = distance;
    }
  return best;
}

std::string suggestion(std::string_view written, std::span<const std::string> known) {
  const std::string best = nearest(written, known);
  if (best.empty()) return fmt::format("; known are: {}", fmt::join(known, ", "));
  return fmt::format("; did you mean '{}'?", best);
}

} // namespace platen::core
