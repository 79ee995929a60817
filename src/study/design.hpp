#pragma once
// Designs: which levels of its factors each run of a study has.

#include "core/csv.hpp"
#include "study/factor.hpp"
#include "study/spread.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace platen::study {

/// A level for each factor.
using Point = std::vector<Level>;

/// Every combination of the values, the last factor's changing fastest.
std::vector<Point> factorial(const std::vector<Factor>&);

/// The rows of a table; of those whose cells are as `only` says. A column in MPa serves a factor in Pa.
/// InvalidInput for a missing column, a word without a name, and units that do not fit.
std::vector<Point> rows_of(const core::Csv&, const std::vector<Factor>&,
                           const std::map<std::string, std::string>& only);

/// Each range is cut into as many strata as there are runs, and each stratum has one run, at random within
/// it; values are shared out evenly. Of the ways to combine the strata, exchanges of two at a time look for
/// one with a small MaxPro criterion.
std::vector<Point> latin_hypercube(const std::vector<Factor>&, std::size_t runs, std::uint64_t seed);

/// Fast flexible filling (Lekivetz & Jones 2015; SH section 2.2): random admissible points, 50 a run but at
/// most 20,000, in runs/k Ward clusters, each in k Ward clusters of its own, for a factor with k values, of
/// which there may be one; from each of these the point that makes the MaxPro criterion small; the values
/// shared out at random among the k. Every value must be admissible with every point.
std::vector<Point> space_filling(const std::vector<Factor>&, std::size_t runs, std::uint64_t seed,
                                 const std::function<bool(const Point&)>& admissible);

/// The numeric factors of a point, each range mapped to [0, 1]. A factor without a range has that of `all`.
std::vector<CubePoint> in_cube(const std::vector<Factor>&, const std::vector<Point>& all,
                               const std::vector<Point>& points);
/// The words of each point, joined; empty where no factor has words.
std::vector<std::string> categories(const std::vector<Point>&);

} // namespace platen::study
