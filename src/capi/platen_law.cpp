#include "platen_law.h"

#include "platen/law/catalogue.hpp"

#include <cstring>
#include <exception>
#include <type_traits>

struct platen_law {
  platen::law::Law law;
};

namespace {

using platen::law::State;
static_assert(std::is_trivially_copyable_v<State> && sizeof(State) % sizeof(double) == 0);
static_assert(static_cast<int>(platen::law::Branch::reloading) == PLATEN_RELOADING);

void tell(char* message, size_t size, const char* what) {
  if (!message || size == 0) return;
  std::strncpy(message, what, size - 1);
  message[size - 1] = '\0';
}

const char* or_empty(const char* text) { return text ? text : ""; }

/// The caller's bytes may lie anywhere, and be anything.
platen::law::Response advance(const platen_law* law, void* state, double overlap) {
  State memory;
  std::memcpy(&memory, state, sizeof memory);
  const auto now = platen::law::evaluate(law->law, memory, overlap);
  std::memcpy(state, &now.state, sizeof memory);
  return now;
}

} // namespace

extern "C" platen_law* platen_law_new(const char* law, const char* variant, const char* parameters,
                                      char* message, size_t message_size) {
  try {
    return new platen_law{platen::law::make_law(or_empty(law), or_empty(variant),
                                                platen::law::parameter_texts(or_empty(parameters)))};
  } catch (const std::exception& error) { tell(message, message_size, error.what()); } catch (...) {
    tell(message, message_size, "unknown failure");
  }
  return nullptr;
}

extern "C" void platen_law_free(platen_law* law) { delete law; }

extern "C" size_t platen_law_state_size(const platen_law*) { return sizeof(State); }
extern "C" unsigned platen_law_state_version(const platen_law*) { return platen::law::state_version; }
extern "C" const char* platen_law_state_name(const platen_law*, size_t i) {
  return i < std::size(platen::law::state_names) ? platen::law::state_names[i] : nullptr;
}

extern "C" platen_law_response platen_law_evaluate(const platen_law* law, void* state, double overlap_m) {
  const auto now = advance(law, state, overlap_m);
  return {now.force,           now.stiffness,       now.contact_radius,
          now.mean_pressure,   now.dissipated_work, static_cast<int>(now.branch),
          now.in_range ? 1 : 0};
}

extern "C" void platen_law_evaluate_all(const platen_law* law, size_t n, const double* overlap_m,
                                        void* states, double* force_N, double* stiffness_N_per_m) {
  char* state = static_cast<char*>(states);
  for (size_t i = 0; i < n; ++i, state += sizeof(State)) {
    const auto now = advance(law, state, overlap_m[i]);
    force_N[i] = now.force;
    if (stiffness_N_per_m) stiffness_N_per_m[i] = now.stiffness;
  }
}
