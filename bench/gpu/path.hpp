#pragma once
// What both sides run: contacts that load, unload, reload and part, each with a size of its own, and no step
// like the one before. Only products and integers, so that both sides get the same bits.

#include "platen/law/table.hpp"

#include <cstdint>
#include <vector>

namespace platen::bench {

constexpr int steps = 24;
constexpr std::uint32_t sorts = 1 << 16; ///< contact i has the size and the law of sort i % sorts

struct Path {
  const double* size = nullptr; ///< overlap at level 1, of each sort [m]
  double level[steps] = {0.1, 0.3, 0.6, 0.8, 1.0, 0.9, 0.7,  0.5, 0.8, 1.0, 1.2, 1.4,
                         1.1, 0.2, 0.9, 1.3, 1.6, 1.5, -0.1, 0.3, 1.4, 1.8, 1.6, 2.0};

  /// Of contact i at step t; 1/8 more or less than its level.
  [[nodiscard]] PLATEN_FUNCTION double overlap(std::uint32_t i, int t) const {
    std::uint32_t h = i * 24u + static_cast<std::uint32_t>(t);
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return size[i % sorts] * level[t] * ((896 + (h >> 24)) * 0x1p-10);
  }
};

/// One law for all contacts, or several, drawn at random.
struct Laws {
  std::vector<law::Law> list;
  std::vector<std::uint8_t> kind; ///< of each sort

  [[nodiscard]] const law::Law& of(std::uint32_t i) const { return list[kind[i % sorts]]; }
};

struct Answer {
  law::State state;
  double force, radius;
};

/// One step of `contacts` contacts on the host, the first of them `first`.
void host_step(const Laws&, const Path&, std::uint32_t first, int t, std::vector<Answer>& contacts);

/// Time of a contact and step [ns] with all steps of `each` contacts on each of `threads` threads.
double host_time(const Laws&, const Path&, std::uint32_t each, unsigned threads);

} // namespace platen::bench
