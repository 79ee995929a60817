#include "platen_law.h"

#include "platen/law/batch.hpp"
#include "platen/law/catalogue.hpp"

#include <algorithm>
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

/// Contacts of one law as `advance` has them, but for rounding; `stiffness` may be none.
template <platen::law::Want want>
void advance_all(const platen_law* law, size_t n, const double* overlap, char* states, double* force,
                 double* stiffness) {
  using platen::law::Batch;
  Batch batch;
  for (int c = 0; c < Batch::size; ++c) batch.law(c, *law->law.table, law->law.scale);
  while (n > 0) {
    const int count = static_cast<int>(n < Batch::size ? n : Batch::size);
    State memory;
    for (int c = 0; c < count; ++c) {
      std::memcpy(&memory, states + static_cast<size_t>(c) * sizeof memory, sizeof memory);
      batch.overlap[c] = overlap[c], batch.gamma_max[c] = memory.gamma_max;
    }
    platen::law::evaluate<want>(batch, count);
    for (int c = 0; c < count; ++c, states += sizeof memory) {
      force[c] = batch.force[c];
      if (stiffness) stiffness[c] = batch.stiffness[c];
      if (batch.force[c] != batch.force[c]) continue;
      memory = {std::min(overlap[c], batch.gamma_max[c]), batch.gamma_max[c]};
      std::memcpy(states, &memory, sizeof memory);
    }
    n -= static_cast<size_t>(count), overlap += count, force += count;
    if (stiffness) stiffness += count;
  }
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
  using platen::law::Want;
  const auto advance = stiffness_N_per_m ? advance_all<Want::contact> : advance_all<Want::force>;
  advance(law, n, overlap_m, static_cast<char*>(states), force_N, stiffness_N_per_m);
}
