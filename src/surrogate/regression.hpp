#pragma once
// Linear regression, and the choice of its terms.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace platen::surrogate {

/// Products of powers of x up to a degree, 1 first: of (x, y) and 2: 1, x, y, x^2, x y, y^2 in some order.
std::vector<double> monomials(std::span<const double> x, int degree);
/// "1", "x", "x x", "x y" and so on, in the same order.
std::vector<std::string> monomial_names(const std::vector<std::string>& of, int degree);

/// Columns that are worth their keep, by stepwise regression: the one is added or taken away that lowers
/// Schwarz's criterion n ln(RSS/n) + k ln n most, until none does. Column 0 is always there.
std::vector<std::size_t> stepwise(const std::vector<std::vector<double>>& columns,
                                  const std::vector<double>& y);

/// What the regression says of each y when it and all of its group are left out; groups: a number for each y.
std::vector<double> regression_left_out(const std::vector<std::vector<double>>& columns,
                                        const std::vector<double>& y, const std::vector<std::size_t>& groups);

} // namespace platen::surrogate
