#include "reproduce/metals.hpp"

#include "core/error.hpp"
#include "fit/agarwal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::reproduce {

namespace {

law::LoadingCase loading_from(const std::string& word) {
  return word == "simple" ? law::LoadingCase::simple
         : word == "die"  ? law::LoadingCase::die
                          : law::LoadingCase::hydrostatic;
}

double lambda_of(double E, double nu, double sigma_y) { return E / ((1 - nu * nu) * sigma_y); }
double zeta_of(double E, double nu, double sigma_y) { return E / (3 * (1 - 2 * nu) * sigma_y); }

void need_one(const Pool& pool, std::size_t found, law::LoadingCase loading) {
  if (found == 0)
    throw core::InvalidInput(
        fmt::format("{}: no run of {} loading is done", pool.runs.file, name_of(loading)));
}

constexpr const char* shades[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"};

} // namespace

std::optional<double> Metal::operator[](const std::string& key) const {
  const auto it = found.find(key);
  return it == found.end() ? std::nullopt : std::optional(it->second);
}

law::AgarwalCurve<double> Metal::published() const {
  return law::AgarwalCurve<double>::make(loading, law::AgarwalVariant::published, lambda, zeta);
}

std::vector<Metal> rows_of_table_a1(const Data& data, law::LoadingCase loading) {
  std::vector<Metal> list;
  const Pool& pool = data.pool("shahin");
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run) {
    if (!pool.done(run) || loading_from(pool.text(run, "experiment")) != loading) continue;
    const double E = pool.number(run, "material.E_Pa"), nu = pool.number(run, "material.nu"),
                 sigma_y = pool.number(run, "material.sigma_y_Pa");
    Metal metal{loading, lambda_of(E, nu, sigma_y), zeta_of(E, nu, sigma_y), pool.loading.at(run), {}};
    for (const auto& column : pool.runs.columns)
      if (column.starts_with("agarwal."))
        if (const auto value = pool.value(run, column)) metal.found[column.substr(8)] = *value;
    list.push_back(std::move(metal));
  }
  need_one(pool, list.size(), loading);
  std::ranges::sort(list, {}, &Metal::lambda);
  return list;
}

std::vector<Metal> metals(const Data& data, law::LoadingCase loading) {
  std::vector<Metal> list = rows_of_table_a1(data, loading);
  if (loading != law::LoadingCase::simple) return list;
  const Pool& pool = data.pool("von-mises");
  constexpr double nu = 0.3, sigma_y = 1e6; // its ratios alone matter
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run) {
    const double E = pool.number(run, "material.E_bar") * sigma_y;
    Metal metal{loading, lambda_of(E, nu, sigma_y), zeta_of(E, nu, sigma_y), pool.loading.at(run), {}};
    if (metal.lambda < 117) continue; // the least of Table A.1
    const auto fit = fit::fit_agarwal(metal_curve(metal.curve, "simple", E, nu, sigma_y));
    for (const auto& c : law::agarwal_coefficients)
      if (std::ranges::find(fit.held, c.key) == fit.held.end())
        metal.found[std::string(c.key)] = fit.fitted.*c.member;
    list.push_back(std::move(metal));
  }
  std::ranges::sort(list, {}, &Metal::lambda);
  return list;
}

std::vector<HardeningMetal> hardening_metals(const Data& data, law::LoadingCase loading) {
  std::vector<HardeningMetal> list;
  const Pool& pool = data.pool("shahin-hardening");
  for (int run = 1; run <= static_cast<int>(pool.size()); ++run)
    if (pool.done(run) && loading_from(pool.text(run, "experiment")) == loading)
      list.push_back({loading, pool.number(run, "material.hardening.inverse_m"), pool.loading.at(run)});
  need_one(pool, list.size(), loading);
  std::ranges::sort(list, {}, &HardeningMetal::inverse_m);
  return list;
}

std::string name_of(law::LoadingCase loading) {
  return loading == law::LoadingCase::simple ? "simple"
         : loading == law::LoadingCase::die  ? "die"
                                             : "hydrostatic";
}

std::vector<double> compared_overlaps(law::LoadingCase loading, const BranchCurve& curve) {
  const double limit = loading == law::LoadingCase::simple ? 0.5 : law::x_of_filled_cell(loading);
  std::vector<double> x;
  for (const double at : curve.x)
    if (at >= 0.06 - 1e-9 && at <= 0.9 * limit) x.push_back(at);
  return x;
}

bool is_drawn(std::size_t i, std::size_t of) {
  constexpr std::size_t most = 4;
  if (of <= most) return true;
  for (std::size_t n = 0; n < most; ++n)
    if (i == (n * (of - 1) + (most - 1) / 2) / (most - 1)) return true;
  return false;
}

std::vector<Chart> three_charts(const std::vector<Compared>& list, const std::string& title,
                                const std::string& stress) {
  std::vector<Chart> charts = {{title, "overlap  γ/2R = δ/R", fmt::format("pressure  F/(πa²{})", stress), {}},
                               {title, "overlap  γ/2R = δ/R", "contact radius  a/R", {}},
                               {title, "overlap  γ/2R = δ/R", fmt::format("force  F/(πR²{})", stress), {}}};
  std::size_t place = 0;
  for (std::size_t n = 0; n < list.size(); ++n) {
    if (!is_drawn(n, list.size())) continue;
    const Compared& c = list[n];
    const std::string colour = shades[place++ % std::size(shades)];
    std::vector<double> x, F, a, H;
    for (std::size_t i = 0; i < c.press->x.size(); ++i) {
      if (c.press->x[i] < 0.01 - 1e-9) continue; // contacts of a few faces
      x.push_back(c.press->x[i]);
      F.push_back(c.press->F[i]);
      a.push_back(c.press->a[i]);
      H.push_back(c.press->F[i] / (c.press->a[i] * c.press->a[i]));
    }
    charts[0].series.push_back({c.name, Mark::line, x, H, colour});
    charts[1].series.push_back({c.name, Mark::line, x, a, colour});
    charts[2].series.push_back({c.name, Mark::line, x, F, colour});
    if (c.x.empty()) continue;
    charts[0].series.push_back({"law", Mark::dashed, c.x, c.H, colour});
    charts[1].series.push_back({"law", Mark::dashed, c.x, c.a, colour});
    charts[2].series.push_back({"law", Mark::dashed, c.x, c.F, colour});
  }
  return charts;
}

} // namespace platen::reproduce
