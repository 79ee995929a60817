#include "fuzz.hpp"

#include "material/deck.hpp"

using namespace platen;

PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    for (const auto& deck : material::read_deck(fuzz::text_of(data, size), "deck"))
      for (const auto& units : material::deck_units()) {
        const auto converted = material::convert(deck, units, 0.5);
        (void)material::deck_of(converted.material, units);
      }
  });
}
