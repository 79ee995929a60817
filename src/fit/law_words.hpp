#pragma once
// Materials in the words of the laws.

#include "material/models.hpp"
#include "platen/law/parameter_reader.hpp"

namespace platen::fit {

/// What a material card says in the words of the laws. A model with its strength under another name gives
/// that.
law::ParameterTexts law_words(const material::Material&);

} // namespace platen::fit
