#include "reproduce/granules.hpp"

#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::reproduce {
namespace {

/// 0.25 -> "025", as in the names of the presses.
std::string plain(double x) {
  std::string text = core::number_text(x);
  std::erase(text, '.');
  return text;
}

} // namespace

double Granule::law(double x) const {
  return x <= delta_t ? k * x : k * delta_t * std::exp(a * (x - delta_t));
}

std::vector<Granule> granules(const Pool& pool) {
  std::vector<Granule> list;
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run)
    if (pool.done(run))
      list.push_back({run, pool.number(run, "material.E_bar"), pool.number(run, "material.Gamma_bar"),
                      pool.number(run, "material.Lambda_bar"), pool.number(run, "k"),
                      pool.number(run, "delta_t"), pool.number(run, "a"), pool.number(run, "e_p"),
                      pool.number(run, "e_a")});
  return list;
}

Granule granule(const Pool& pool, double E_bar, double Gamma_bar, double Lambda_bar) {
  const int run = pool.find(
      {{"material.E_bar", E_bar}, {"material.Gamma_bar", Gamma_bar}, {"material.Lambda_bar", Lambda_bar}});
  const auto list = granules(pool);
  return *std::ranges::find(list, run, &Granule::run);
}

std::string name_of(double E_bar, double Gamma_bar, double Lambda_bar) {
  return fmt::format("Ē₀ = {}, Γ̄₀ = {}, Λ̄₀ = {}", E_bar, Gamma_bar, Lambda_bar);
}

std::string Corner::press() const {
  return fmt::format("corner-E{}-G{}-L{}", core::number_text(E_bar), plain(Gamma_bar), plain(Lambda_bar));
}

std::vector<Corner> corners() {
  std::vector<Corner> list;
  for (const double E : {3.0, 500.0})
    for (const double G : {0.25, 1.0})
      for (const double L : {0.01, 1.0}) list.push_back({E, G, L});
  return list;
}

Series force(const std::string& name, const BranchCurve& curve, double factor, Mark mark) {
  Series series{name, mark, curve.x, curve.F};
  for (double& F : series.y) F *= factor;
  return series;
}

} // namespace platen::reproduce
