#include "study/table.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/edmans_sinka.hpp"
#include "fit/unloading.hpp"
#include "press/curve_csv.hpp"

#include <fmt/format.h>

#include <cmath>

namespace platen::study {
namespace {

constexpr std::string_view loading_columns = ",k,delta_t,a,relative_l2,e_p,e_a,F_bar_end";

std::string loading_cells(const press::Curve& curve, std::string_view variant) {
  const auto fit = fit::fit_edmans_sinka(curve, variant);
  std::string cells;
  for (const double x : {fit.k, fit.delta_t, fit.a, fit.errors.relative_l2, fit.errors.e_p, fit.errors.e_a,
                         press::loading_end(curve)->F_bar})
    cells += "," + core::number_text(x);
  return cells;
}

std::string unloading_cells(const press::Curve& curve, const std::vector<double>& from) {
  const auto fits = fit::fit_unloading(curve).fits;
  std::string cells;
  for (const double delta_bar : from) {
    const fit::UnloadingFit* found = nullptr;
    for (const auto& fit : fits)
      if (std::abs(fit.delta_bar_max - delta_bar) < 1e-9) found = &fit;
    cells +=
        found ? fmt::format(",{},{},{},{}", core::number_text(found->alpha), core::number_text(found->beta),
                            core::number_text(found->delta_bar_0), core::number_text(found->r_squared))
              : ",,,,";
  }
  return cells;
}

} // namespace

std::string runs_csv(const Study& study, const Store& store, std::string_view variant) {
  // Factors may change where a run unloads; columns are those of the first.
  const auto from = study.runs.front().press_case.unload_from;
  const bool fitted = !study.laws.empty();
  std::string csv =
      fmt::format("# study = {}\n# engine = {}\n# variant = {}\nkey", study.name, core::engine, variant);
  for (const auto& factor : study.factors) csv += "," + factor;
  csv += ",state";
  std::string empty;
  if (fitted) {
    csv += loading_columns;
    empty = ",,,,,,,";
    for (const double delta_bar : from) {
      for (const char* name : {"alpha", "beta", "delta_bar_0", "R2"})
        csv += fmt::format(",{}_{}", name, core::number_text(delta_bar));
      empty += ",,,,";
    }
  }
  csv += ",cpu_s,wall_s\n";
  for (const auto& run : study.runs) {
    const auto key = key_of(run.press_case);
    const auto state = store.state(key);
    csv += key;
    for (const double input : run.inputs) csv += "," + core::number_text(input);
    csv += state == Store::State::done ? ",done" : state == Store::State::failed ? ",failed" : ",missing";
    if (fitted && state == Store::State::done) {
      const auto curve = press::read_curve(store.run(key) / "curve.csv");
      csv += loading_cells(curve, variant) + unloading_cells(curve, from);
    } else csv += empty;
    if (state == Store::State::missing) csv += ",,\n";
    else {
      const auto cost = store.cost(key);
      csv += fmt::format(",{},{}\n", core::number_text(cost.cpu_s), core::number_text(cost.wall_s));
    }
  }
  return csv;
}

} // namespace platen::study
