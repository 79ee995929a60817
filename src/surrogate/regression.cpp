#include "surrogate/regression.hpp"

#include "core/interrupt.hpp"
#include "fit/least_squares.hpp"

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

double sum_of(const std::vector<std::vector<double>>& columns, const std::vector<double>& c,
              std::size_t row) {
  double sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * columns[k][row];
  return sum;
}

void add_products(std::span<const double> x, int degree, std::size_t from, double product,
                  std::vector<double>& all) {
  all.push_back(product);
  if (degree > 0)
    for (std::size_t k = from; k < x.size(); ++k) add_products(x, degree - 1, k, product * x[k], all);
}

void add_names(const std::vector<std::string>& of, int degree, std::size_t from, const std::string& name,
               std::vector<std::string>& all) {
  all.push_back(name.empty() ? "1" : name);
  if (degree > 0)
    for (std::size_t k = from; k < of.size(); ++k)
      add_names(of, degree - 1, k, name.empty() ? of[k] : name + " " + of[k], all);
}

} // namespace

std::vector<std::string> monomial_names(const std::vector<std::string>& of, int degree) {
  std::vector<std::string> all;
  add_names(of, degree, 0, "", all);
  return all;
}

std::vector<double> monomials(std::span<const double> x, int degree) {
  std::vector<double> all;
  add_products(x, degree, 0, 1, all);
  return all;
}

std::vector<std::size_t> stepwise(const std::vector<std::vector<double>>& columns,
                                  const std::vector<double>& y) {
  const auto n = static_cast<double>(y.size());
  const auto criterion = [&](const std::vector<std::size_t>& chosen) {
    std::vector<std::vector<double>> some;
    for (const std::size_t k : chosen) some.push_back(columns[k]);
    const auto c = fit::least_squares(some, y);
    double squares = 0;
    for (std::size_t i = 0; i < y.size(); ++i) squares += std::pow(y[i] - sum_of(some, c, i), 2);
    return n * std::log(squares / n) + static_cast<double>(chosen.size()) * std::log(n);
  };
  std::vector<std::size_t> chosen = {0};
  for (double least = criterion(chosen);;) {
    core::stop_if_asked();
    std::vector<std::size_t> best;
    for (std::size_t k = 1; k < columns.size(); ++k) {
      auto other = chosen;
      if (const auto found = std::find(other.begin(), other.end(), k); found != other.end())
        other.erase(found);
      else other.push_back(k);
      if (const double value = criterion(other); value < least - 1e-9) least = value, best = other;
    }
    if (best.empty()) return chosen;
    chosen = best;
  }
}

std::vector<double> regression_left_out(const std::vector<std::vector<double>>& columns,
                                        const std::vector<double>& y,
                                        const std::vector<std::size_t>& groups) {
  std::vector<double> said(y.size());
  for (std::size_t group = 0; group <= *std::max_element(groups.begin(), groups.end()); ++group) {
    core::stop_if_asked();
    std::vector<std::vector<double>> others(columns.size());
    std::vector<double> other_y;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (groups[i] == group) continue;
      other_y.push_back(y[i]);
      for (std::size_t k = 0; k < columns.size(); ++k) others[k].push_back(columns[k][i]);
    }
    const auto c = fit::least_squares(others, other_y);
    for (std::size_t i = 0; i < y.size(); ++i)
      if (groups[i] == group) said[i] = sum_of(columns, c, i);
  }
  return said;
}

} // namespace platen::surrogate
