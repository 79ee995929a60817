#include "fuzz.hpp"

#include "core/toml.hpp"
#include "material/card.hpp"

using namespace platen;

/// A card that was read is written, read again, and the same.
PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto card = material::read_card(core::parse_toml(fuzz::text_of(data, size), "card"));
    const std::string text = material::card_text(card.material);
    if (material::card_text(material::read_card(core::parse_toml(text, "again")).material) != text)
      __builtin_trap();
  });
}
