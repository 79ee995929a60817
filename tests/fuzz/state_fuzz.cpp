// Law, parameters and state of a contact as a host hands them over: "LAW VARIANT PARAMETERS\n", 16 bytes of
// state, then overlaps. Whatever is in them, the answer comes.
#include "fuzz.hpp"

#include "platen_law.h"

#include <cstring>
#include <vector>

PLATEN_FUZZ {
  const std::string all = platen::fuzz::text_of(data, size);
  const auto end = all.find('\n'), first = all.find(' ');
  if (end == all.npos || first > end) return 0;
  const auto second = std::min(all.find(' ', first + 1), end);
  const std::string name = all.substr(0, first), variant = all.substr(first + 1, second - first - 1),
                    parameters = all.substr(second, end - second);
  char why[300] = "";
  platen_law* law = platen_law_new(name.c_str(), variant.c_str(), parameters.c_str(), why, sizeof why);
  if (!law) {
    if (!why[0]) __builtin_trap();
    return 0;
  }
  std::vector<char> state(platen_law_state_size(law));
  const auto left = all.substr(end + 1);
  std::memcpy(state.data(), left.data(), std::min(left.size(), state.size()));
  for (std::size_t at = state.size(); at + sizeof(double) <= left.size(); at += sizeof(double)) {
    double overlap = 0;
    std::memcpy(&overlap, left.data() + at, sizeof overlap);
    const auto now = platen_law_evaluate(law, state.data(), overlap);
    if (now.branch < PLATEN_SEPARATED || now.branch > PLATEN_RELOADING) __builtin_trap();
  }
  platen_law_free(law);
  return 0;
}
