#pragma once
// `agarwal` beside a pressed curve, in words and as JSON.

#include "fit/agarwal.hpp"

#include <string>

namespace platen::app {

std::string agarwal_words(const press::Curve&, const fit::AgarwalFit&);
std::string agarwal_json(const press::Curve&, const fit::AgarwalFit&);

} // namespace platen::app
