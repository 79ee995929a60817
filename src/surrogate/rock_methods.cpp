// Ways to predict the coefficients of a grain of rock from the others, side by side.

#include "platen/law/wang.hpp"
#include "surrogate/process.hpp"
#include "surrogate/regression.hpp"
#include "surrogate/rock.hpp"

#include <cmath>
#include <numeric>

namespace platen::surrogate {
namespace {

using Said = std::vector<std::optional<Coefficients>>;

/// What is interpolated or regressed: ln a, b, ln m, n; back with `from`.
double to_linear(double value, std::size_t k) { return k % 2 == 0 ? std::log(value) : value; }
double from_linear(double value, std::size_t k) { return k % 2 == 0 ? std::exp(value) : value; }

Said by_process(const Rock& rock, RockInterpolation::CoordinatesOf coordinates) {
  Inputs inputs;
  for (const Grain& g : rock.grains) {
    const auto row = coordinates(rock, g);
    inputs.dimensions = row.size();
    inputs.values.insert(inputs.values.end(), row.begin(), row.end());
  }
  Said said(rock.grains.size(), Coefficients{});
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> values;
    for (const Grain& g : rock.grains) values.push_back(to_linear(g.of[k], k));
    const double mean =
        std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& value : values) value -= mean;
    const auto out = left_out(fit_process(inputs, values), inputs, values);
    for (std::size_t i = 0; i < said.size(); ++i) (*said[i])[k] = from_linear(out.mean[i] + mean, k);
  }
  return said;
}

std::vector<std::size_t> one_by_one(std::size_t count) {
  std::vector<std::size_t> groups(count);
  std::iota(groups.begin(), groups.end(), std::size_t{0});
  return groups;
}

/// Columns of which a regression is made, of each coefficient all or those that stepwise regression chooses.
/// In the paper's convention: delta of both spheres, delta_y of one.
Said by_regression(const Rock& rock, const std::vector<std::vector<double>>& columns, bool choose) {
  Said said(rock.grains.size(), Coefficients{});
  for (std::size_t k = 0; k < 4; ++k) {
    std::vector<double> values;
    for (const Grain& g : rock.grains)
      values.push_back(k % 2 == 0 ? g.of[k] / std::exp2(g.of[k + 1]) : g.of[k]);
    std::vector<std::vector<double>> some;
    if (choose)
      for (const std::size_t column : stepwise(columns, values)) some.push_back(columns[column]);
    else some = columns;
    const auto out = regression_left_out(some, values, one_by_one(values.size()));
    for (std::size_t i = 0; i < said.size(); ++i) (*said[i])[k] = out[i];
  }
  for (auto& one : said)
    for (const std::size_t k : {0, 2}) (*one)[k] *= std::exp2((*one)[k + 1]);
  return said;
}

Said as_printed(const Rock& rock) {
  Said said;
  for (const Grain& g : rock.grains) {
    const auto c = law::wang_table2(g.E_Pa, g.nu, g.phi_deg, g.sigma_c_Pa);
    said.push_back(Coefficients{c.a, c.b, c.m, c.n});
  }
  return said;
}

template <class Terms> std::vector<std::vector<double>> columns_of(const Rock& rock, const Terms& terms) {
  std::vector<std::vector<double>> columns;
  for (const Grain& g : rock.grains) {
    const auto row = terms(g);
    columns.resize(row.size());
    for (std::size_t k = 0; k < row.size(); ++k) columns[k].push_back(row[k]);
  }
  return columns;
}

} // namespace

std::vector<RockMethod> rock_methods(const Rock& rock) {
  std::vector<RockMethod> methods;
  const auto add = [&](const char* name, const Said& said) {
    methods.push_back({name, errors_of(rock, said)});
  };
  add("regression (19) as printed", as_printed(rock));
  add("regression (19), refitted",
      by_regression(rock,
                    columns_of(rock,
                               [](const Grain& g) {
                                 const double c = g.sigma_c_Pa / 1e6;
                                 return std::vector{1.0,       g.E_Pa / 1e9, g.nu, g.phi_deg * g.phi_deg,
                                                    g.phi_deg, c * c,        c};
                               }),
                    false));
  add("stepwise, E, nu, phi, sigma_c to the 3rd power",
      by_regression(
          rock, columns_of(rock, [&](const Grain& g) { return monomials(four_coordinates_of(rock, g), 3); }),
          true));
  add("stepwise, nu, phi, ln F_y to the 4th power",
      by_regression(rock,
                    columns_of(rock, [&](const Grain& g) { return monomials(coordinates_of(rock, g), 4); }),
                    true));
  add("natural neighbours, E, nu, phi, sigma_c", left_out_by_neighbours(rock, four_coordinates_of));
  add("Gaussian process, E, nu, phi, sigma_c", by_process(rock, four_coordinates_of));
  add("natural neighbours, nu, phi, ln F_y", left_out_by_neighbours(rock, coordinates_of));
  add("Gaussian process, nu, phi, ln F_y", by_process(rock, coordinates_of));
  return methods;
}

} // namespace platen::surrogate
