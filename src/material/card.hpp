#pragma once
// Material cards (TOML) and what they hold. A card has no radius: it describes a material, not a particle.

#include "core/toml.hpp"
#include "material/card_section.hpp"
#include "material/models.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace platen::material {

struct Card {
  Material material;
  std::vector<std::pair<std::string, std::string>>
      sources; ///< key, or "default", and where its value is from
  std::string file;
};

/// A card by path or by name in the catalogue.
Card read_card(std::string_view what);
/// A card that stands inside another document.
Card read_card(const core::Table&);

/// The material as the text of a card, every number in SI units.
std::string card_text(const Material&);

/// Every parameter of the model.
std::vector<Parameter> parameters(const Model&);
/// The same, and what the card says beside the model.
std::vector<Parameter> parameters(const Material&);

/// The reference page of material cards, as Markdown.
std::string card_reference();

} // namespace platen::material
