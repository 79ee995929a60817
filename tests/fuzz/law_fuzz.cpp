#include "fuzz.hpp"

#include "fit/law_card.hpp"

using namespace platen;

/// The law of a card that was read can be evaluated, or says what is missing.
PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto card = fit::read_law_card(fuzz::file_of(data, size, ".toml"));
    (void)fit::text_of(card);
    const auto law = fit::make_law(card, {{"radius_m", "1e-3"}});
    law::State state;
    for (const double overlap : {1e-9, 1e-6, 1e-4, 3e-4, 2e-4, 0.0, 1e-3})
      state = evaluate(law, state, overlap).state;
  });
}
