#pragma once
// The fit of `wang` told in words and as JSON.

#include "fit/wang.hpp"

#include <string>

namespace platen::app {

std::string wang_words(const fit::WangFit&);
std::string wang_json(const press::Curve&, const fit::WangFit&);

} // namespace platen::app
