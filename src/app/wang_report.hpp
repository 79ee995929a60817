#pragma once
// The fit of `wang` told in words, as JSON, as a picture.

#include "fit/wang.hpp"

#include <filesystem>
#include <string>

namespace platen::app {

std::string wang_words(const fit::WangFit&);
std::string wang_json(const press::Curve&, const fit::WangFit&);
void draw_wang_fit(const press::Curve&, const fit::WangFit&, const std::filesystem::path&);

} // namespace platen::app
