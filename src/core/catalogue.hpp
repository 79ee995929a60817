#pragma once
// Where cards are found: by path, then in $PLATEN_CATALOGUE, then in the catalogue that came with the
// program.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace platen::core {

/// The catalogue folders that exist, in the order in which they are searched.
std::vector<std::filesystem::path> catalogues();

/// The card file: `what` is a path, or a name in `folder` ("materials", "laws") of a catalogue.
/// InvalidInput with the nearest name when there is none.
std::filesystem::path find_card(std::string_view folder, std::string_view what);

/// Names of all cards of a folder, sorted, each once.
std::vector<std::string> card_names(std::string_view folder);

} // namespace platen::core
