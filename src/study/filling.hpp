#pragma once
// How the designs of studies fill the ranges of their factors.

#include "study/card.hpp"
#include "study/spread.hpp"

namespace platen::study {

/// Of the study's own factors.
Spread spread_of(const Study&);
/// Of the factors of `s`, by the runs of another study over them. InvalidInput where one is missing there.
Spread spread_of(const Study& other, const Study& s);

} // namespace platen::study
