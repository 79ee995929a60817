#pragma once
// Words that the rows of Shahin's thesis share, and its rows by what they are of.

#include "reproduce/metals.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace platen::reproduce {

constexpr law::LoadingCase loadings[] = {law::LoadingCase::simple, law::LoadingCase::die,
                                         law::LoadingCase::hydrostatic};
constexpr const char* overlap_label = "overlap  γ/2R = δ/R";
constexpr const char* lambda_label = "λ = E/((1 − ν²)σ_y)";

constexpr double alike = 0.1; ///< of the force: what "similar" is taken to mean

/// A number that the thesis prints.
inline double printed(const Data& data, const std::string& key) { return data.printed("shahin", key); }

/// The first grid overlap from `from` on where two curves differ by more than a share of the first; nothing
/// where none does.
template <class One, class Other>
double parts_at(const One& one, const Other& other, double from, double to, double share) {
  for (double x = from; x <= to; x += 0.0025)
    if (std::abs(other(x) / one(x) - 1) > share) return x;
  return to;
}

std::vector<Row> lead_rows(const Data&);          ///< section 2.1 to 2.3: lead in three loadings, the design
std::vector<Row> raw_rows(const Data&);           ///< section 2.3: force and radius of the presses
std::vector<Row> coefficient_rows(const Data&);   ///< section 2.4: over lambda
std::vector<Row> plastic_law_rows(const Data&);   ///< section 2.5: the law over the presses
std::vector<Row> side_rows(const Data&);          ///< section 2.6: walls of the die
std::vector<Row> coefficient_tables(const Data&); ///< tables 2.1, 2.2

} // namespace platen::reproduce
