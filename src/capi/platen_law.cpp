#include "platen_law.h"

#include "platen/law/batch.hpp"
#include "platen/law/catalogue.hpp"

#include <cstring>
#include <exception>
#include <type_traits>

struct platen_law {
  platen::law::AnyLaw law;
};

namespace {

using platen::law::State;
static_assert(sizeof(State) == sizeof(platen_law_state) && std::is_trivially_copyable_v<State>);
static_assert(static_cast<int>(platen::law::Branch::reloading) == PLATEN_RELOADING);

void tell(char* message, size_t size, const char* what) {
  if (!message || size == 0) return;
  std::strncpy(message, what, size - 1);
  message[size - 1] = '\0';
}

const char* or_empty(const char* text) { return text ? text : ""; }

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

extern "C" platen_law_response platen_law_evaluate(const platen_law* law, platen_law_state* state,
                                                   double overlap_m) {
  const auto now = platen::law::evaluate(law->law, {state->gamma, state->gamma_max}, overlap_m);
  *state = {now.state.gamma, now.state.gamma_max};
  return {now.force,           now.stiffness,       now.contact_radius,
          now.mean_pressure,   now.dissipated_work, static_cast<int>(now.branch),
          now.in_range ? 1 : 0};
}

extern "C" void platen_law_evaluate_all(const platen_law* law, size_t n, const double* overlap_m,
                                        platen_law_state* state, double* force_N, double* stiffness_N_per_m) {
  std::visit(
      [&](const auto& l) {
        for (size_t i = 0; i < n; ++i) {
          const auto now = evaluate(l, State{state[i].gamma, state[i].gamma_max}, overlap_m[i]);
          state[i] = {now.state.gamma, now.state.gamma_max};
          force_N[i] = now.force;
          if (stiffness_N_per_m) stiffness_N_per_m[i] = now.stiffness;
        }
      },
      law->law);
}
