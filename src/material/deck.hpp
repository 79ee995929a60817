#pragma once
// Material sections of Abaqus input files (CalculiX shares the keywords that it knows).

#include "material/models.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace platen::material {

/// One keyword with its data lines.
struct Keyword {
  int line = 0;
  std::string name;                                            ///< "CAP HARDENING", upper case
  std::vector<std::pair<std::string, std::string>> parameters; ///< names upper case; empty values for flags
  std::vector<std::vector<std::optional<double>>> rows;        ///< empty cells are nothing

  std::string parameter(std::string_view name) const; ///< upper case; empty where it is not there
};

/// What stands between *MATERIAL and the next keyword that is none of a material.
struct DeckMaterial {
  std::string file, name;
  std::vector<Keyword> keywords;
  const Keyword* find(std::string_view name) const;
};

/// All materials of a deck. InvalidInput with file and line for data that are no numbers, and where there is
/// no *MATERIAL.
std::vector<DeckMaterial> read_deck(std::string_view text, const std::string& file);

/// The one of that name; without a name the only one. InvalidInput, with the names, where there is none.
const DeckMaterial& choose(const std::vector<DeckMaterial>&, const std::string& name);

/// How the deck's numbers become SI.
struct DeckUnits {
  std::string_view name, words;
  double stress = 1, density = 1;
};
const std::vector<DeckUnits>& deck_units();
/// InvalidInput, with the known systems, for another name.
const DeckUnits& deck_units(const std::string& name);

struct Converted {
  Material material;
  std::vector<std::string> said;      ///< how it was read
  std::vector<std::string> left_over; ///< what has no counterpart here, a line each
};

/// The model is the most special that the keywords name. `rho_r0`: relative density at which volumetric
/// plastic strain is 0, where the field variable does not say it. InvalidInput for what cannot be read, with
/// file and line.
Converted convert(const DeckMaterial&, const DeckUnits&, std::optional<double> rho_r0 = {});

struct DeckText {
  std::string text;
  std::vector<std::string> left_over; ///< of the card, without counterpart in Abaqus
};

/// The material as a section of an input file. InvalidInput for vmdc, which Abaqus has not.
DeckText deck_of(const Material&, const DeckUnits&);

/// The sentence that asks for the units, with what each system would make of the deck.
std::string which_units(const DeckMaterial&);

} // namespace platen::material
