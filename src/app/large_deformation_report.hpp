#pragma once
// Fits of `agarwal` and `shahin`, in words and as JSON.

#include "fit/agarwal.hpp"
#include "fit/shahin.hpp"

#include <string>

namespace platen::app {

std::string agarwal_words(const press::Curve&, const fit::AgarwalFit&);
std::string agarwal_json(const press::Curve&, const fit::AgarwalFit&);
std::string shahin_words(const press::Curve&, const fit::ShahinFit&);
std::string shahin_json(const press::Curve&, const fit::ShahinFit&);

} // namespace platen::app
