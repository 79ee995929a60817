#pragma once
// Case cards (TOML): one virtual experiment.

#include "core/toml.hpp"
#include "press/case.hpp"

#include <string>
#include <string_view>

namespace platen::press {

/// A case card by path. The material in it is a catalogue name, a path (relative to the card), or a table.
Case read_case(std::string_view path);
Case read_case(const core::Table&);

/// InvalidInput unless the case is one that can be pressed; for cases that were not read from a card.
void validate(const Case&);

/// The resolved case as the text of a card, its material inline and in SI units: reading it gives the same
/// case.
std::string case_text(const Case&);

/// The same without what is as it is by default: what names a case, so that a new key with a default names
/// the cases of before as before.
std::string case_identity(const Case&);

/// The reference page of case cards, as Markdown.
std::string case_reference();

} // namespace platen::press
