#include "fit/convert_deck.hpp"

#include "core/toml.hpp"
#include "fit/doubt.hpp"
#include "material/card.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

namespace platen::fit {
namespace {

std::vector<Doubt> doubts_about(const material::Material& m, const material::DeckMaterial& deck) {
  std::vector<Doubt> doubts;
  const double E = material::initial_E(m.model), sigma = material::reference_stress(m.model);
  const auto doubt = [&](const std::string& what) {
    doubts.push_back({true, fmt::format("{}; are these the units? {}", what, material::which_units(deck))});
  };
  constexpr double E_least = 1e4, E_most = 1.3e12;           // gels; diamond
  constexpr double density_least = 20, density_most = 2.3e4; // foams; osmium
  if (E < E_least || E > E_most) doubt(fmt::format("E = {:.3g} Pa is that of no material", E));
  else if (m.density && (*m.density < density_least || *m.density > density_most))
    doubt(fmt::format("a density of {:.3g} kg/m3 is that of no material", *m.density));
  if (sigma > E)
    doubts.push_back(
        {true, fmt::format("{}: the strength, {:.3g} Pa, is above E = {:.3g} Pa", deck.file, sigma, E)});
  return doubts;
}

} // namespace

ConvertedCard convert_deck(const material::DeckMaterial& deck, const material::DeckUnits& units,
                           std::optional<double> rho_r0, bool despite_doubts) {
  auto converted = material::convert(deck, units, rho_r0);
  auto doubts = pass(doubts_about(converted.material, deck), despite_doubts);
  std::string source = fmt::format("converted from {}, units {}",
                                   std::filesystem::path(deck.file).filename().string(), units.words);
  if (!converted.left_over.empty())
    source += fmt::format("; without counterpart: {}", fmt::join(converted.left_over, "; "));
  if (!doubts.empty()) source += fmt::format("; doubted: {}", fmt::join(doubts, "; "));
  auto card =
      fmt::format("{}\n[source]\ndefault = {}\n", card_text(converted.material), core::in_quotes(source));
  (void)material::read_card(core::parse_toml(card, deck.file)); // what the model does not admit is said now
  return {std::move(card), std::move(converted.said), std::move(converted.left_over), std::move(doubts)};
}

} // namespace platen::fit
