#include "study/table.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "core/version.hpp"
#include "fit/agarwal.hpp"
#include "fit/edmans_sinka.hpp"
#include "fit/shahin.hpp"
#include "fit/unloading.hpp"
#include "fit/wang.hpp"
#include "press/curve_csv.hpp"
#include "study/derived.hpp"
#include "study/grid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace platen::study {
namespace {

using Cells = std::vector<Cell>;

void append(Cells& row, const Cells& more) { row.insert(row.end(), more.begin(), more.end()); }

constexpr std::array loading_columns = {"k", "delta_t", "a", "relative_l2", "e_p", "e_a", "F_bar_end"};
constexpr std::array unloading_columns = {"alpha", "beta", "delta_bar_0", "R2"};

/// What a law writes into a row: names of columns, and the cells of a curve under them.
struct LawColumns {
  std::string_view law;
  std::vector<std::string> (*names)(const std::vector<double>& unload_from);
  Cells (*cells)(const press::Curve&, std::string_view variant, const std::vector<double>& unload_from);
};

std::vector<std::string> edmans_sinka_names(const std::vector<double>& unload_from) {
  std::vector<std::string> names(loading_columns.begin(), loading_columns.end());
  for (const double delta_bar : unload_from)
    for (const char* name : unloading_columns)
      names.push_back(fmt::format("{}_{}", name, core::number_text(delta_bar)));
  return names;
}

Cells edmans_sinka_cells(const press::Curve& curve, std::string_view variant,
                         const std::vector<double>& unload_from) {
  const auto fit = fit::fit_edmans_sinka(curve, variant);
  Cells cells = {fit.k,
                 fit.delta_t,
                 fit.a,
                 fit.errors.relative_l2,
                 fit.errors.e_p,
                 fit.errors.e_a,
                 press::loading_end(curve)->F_bar};
  const auto fits = fit::fit_unloading(curve).fits;
  for (const double delta_bar : unload_from) {
    const auto found = std::find_if(fits.begin(), fits.end(), [&](const fit::UnloadingFit& one) {
      return std::abs(one.delta_bar_max - delta_bar) < 1e-9;
    });
    if (found == fits.end()) append(cells, Cells(unloading_columns.size()));
    else append(cells, {found->alpha, found->beta, found->delta_bar_0, found->r_squared});
  }
  return cells;
}

constexpr std::array deviation_columns = {"force_largest", "force_rms", "published_force_largest",
                                          "published_force_rms"};

/// Coefficients of a law of large deformation under its name, then how far it is from the curve.
template <class Table> std::vector<std::string> coefficient_names(std::string_view law, const Table& table) {
  std::vector<std::string> names;
  for (const auto& c : table) names.push_back(fmt::format("{}.{}", law, c.key));
  for (const char* name : deviation_columns) names.push_back(fmt::format("{}.{}", law, name));
  return names;
}

/// Empty where the curve does not determine a coefficient, or has nothing to compare with.
template <class Fit, class Table> Cells coefficient_cells(const Fit& fit, const Table& table) {
  Cells cells;
  for (const auto& c : table)
    if (std::find(fit.held.begin(), fit.held.end(), c.key) == fit.held.end())
      cells.emplace_back(fit.fitted.*c.member);
    else cells.emplace_back();
  if (fit.of_fitted.points == 0) append(cells, Cells(deviation_columns.size()));
  else
    append(cells, {fit.of_fitted.force.largest, fit.of_fitted.force.rms, fit.of_published.force.largest,
                   fit.of_published.force.rms});
  return cells;
}

constexpr std::array wang_columns = {"F_y_N", "delta_y_m", "a", "b", "R2", "m", "n", "unload_R2"};

/// F_y and delta_y alone of a grain that does not yield, or hardly: with fewer points beyond first yield than
/// a fit wants.
Cells wang_cells(const press::Curve& curve, std::string_view, const std::vector<double>&) {
  const auto yield = fit::first_yield(curve.E_Pa, curve.nu, curve.phi_deg, curve.sigma_c_Pa, curve.radius_m);
  Cells cells = {yield.F_N, yield.delta_m};
  if (fit::points_beyond(curve, yield) < fit::wang_enough_points) {
    append(cells, Cells(wang_columns.size() - cells.size()));
    return cells;
  }
  const auto fit = fit::fit_wang(curve);
  append(cells, {fit.a, fit.b, fit.r_squared});
  if (fit.unloading.empty()) append(cells, Cells(3));
  else append(cells, {fit.m, fit.n, fit.unloading_r_squared});
  return cells;
}

const std::array law_columns = {
    LawColumns{"edmans-sinka", edmans_sinka_names, edmans_sinka_cells},
    LawColumns{"agarwal",
               [](const std::vector<double>&) {
                 auto names = coefficient_names("agarwal", law::agarwal_coefficients);
                 for (const char* name : {"Gamma", "side_onset", "tau", "omega"})
                   names.push_back(fmt::format("agarwal.{}", name));
                 return names;
               },
               [](const press::Curve& curve, std::string_view, const std::vector<double>&) {
                 const auto fit = fit::fit_agarwal(curve);
                 Cells cells = coefficient_cells(fit, law::agarwal_coefficients);
                 const auto add = [&](const std::optional<double>& value) {
                   if (value) cells.emplace_back(*value);
                   else cells.emplace_back();
                 };
                 add(fit.Gamma);
                 add(fit.side_onset);
                 add(fit.sides ? std::optional(fit.sides->tau) : std::nullopt);
                 add(fit.sides ? std::optional(fit.sides->omega) : std::nullopt);
                 return cells;
               }},
    LawColumns{
        "shahin",
        [](const std::vector<double>&) { return coefficient_names("shahin", law::shahin_coefficients); },
        [](const press::Curve& curve, std::string_view, const std::vector<double>&) {
          return coefficient_cells(fit::fit_shahin(curve), law::shahin_coefficients);
        }},
    LawColumns{"wang",
               [](const std::vector<double>&) {
                 std::vector<std::string> names;
                 for (const char* name : wang_columns) names.push_back(fmt::format("wang.{}", name));
                 return names;
               },
               wang_cells},
};

/// The engines of the runs that are there: one, unless runs of older engines were kept.
/// Engines whose runs are there; this one, where there is none.
std::string engines_of(const Study& study, const Store& store, const std::vector<Found>& found) {
  std::vector<int> engines;
  for (const int engine : store.engines())
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i].state != Store::State::missing &&
          found[i].key == key_of(study.runs[i].press_case, engine)) {
        engines.push_back(engine);
        break;
      }
  if (engines.empty()) engines.push_back(core::engine);
  return fmt::format("{}", fmt::join(engines, " "));
}

std::string word(Store::State state) {
  constexpr std::array words = {"missing", "done", "failed", "damaged"};
  return words[static_cast<std::size_t>(state)];
}

/// Six digits: what a press is good for, and room.
double rounded(double x) { return *core::number_from(fmt::format("{:.6g}", x)); }

} // namespace

std::vector<std::string> fitted_laws() {
  std::vector<std::string> names;
  for (const auto& law : law_columns) names.emplace_back(law.law);
  return names;
}

/// Where the runs of a study unload, by overlap.
std::vector<double> unloading_of(const press::Case& c) {
  if (const auto* path = press::by_overlap(c.experiment)) return path->unload_from;
  if (const auto* local = std::get_if<press::Local>(&c.experiment)) return local->unload_from;
  return {};
}

std::vector<Found> find_runs(const Study& study, const Store& store) {
  std::vector<Found> found;
  for (const auto& run : study.runs) {
    auto key = store.key(run.press_case);
    const auto state = store.verified(key);
    found.push_back({std::move(key), state});
  }
  return found;
}

std::string nothing_done(const Store& store, const std::vector<Found>& found) {
  const auto done = [](const Found& run) { return run.state == Store::State::done; };
  if (std::ranges::any_of(found, done)) return "";
  return fmt::format("no run of the study is done in {}", store.folder().string());
}

std::string damage(const Store& store, const std::vector<Found>& found) {
  const auto damaged = [](const Found& run) { return run.state == Store::State::damaged; };
  const auto first = std::ranges::find_if(found, damaged);
  if (first == found.end()) return "";
  return fmt::format("{} of {} runs are damaged and without numbers in the tables, the first: {}; "
                     "`platen study run` presses them again",
                     std::ranges::count_if(found, damaged), found.size(), store.damage(first->key));
}

Sheet design_sheet(const Study& study) {
  Sheet sheet{"design",
              {{"study", study.name}, {"kind", study.kind}, {"seed", std::to_string(study.seed)}},
              {"run"},
              {}};
  for (const auto& factor : study.factors) sheet.columns.push_back(factor.name);
  for (const auto& derived : derived_quantities()) sheet.columns.push_back(derived.name);
  for (const auto& run : study.runs) {
    Cells row = {static_cast<std::int64_t>(sheet.rows.size() + 1)};
    for (const auto& input : run.inputs)
      std::visit([&](const auto& level) { row.emplace_back(level); }, input);
    for (const auto& derived : derived_quantities()) row.emplace_back(derived.of(run.press_case));
    sheet.rows.push_back(std::move(row));
  }
  return sheet;
}

Sheet runs_sheet(const Study& study, const Store& store, const std::vector<Found>& found,
                 std::string_view variant) {
  // Factors may change where a run unloads; columns are those of the first.
  const auto from = unloading_of(study.runs.front().press_case);
  Sheet sheet{
      "runs",
      {{"study", study.name}, {"engine", engines_of(study, store, found)}, {"variant", std::string(variant)}},
      {"run", "key"},
      {}};
  for (const auto& factor : study.factors) sheet.columns.push_back(factor.name);
  sheet.columns.push_back("state");
  const std::size_t before_fit = sheet.columns.size();
  const auto wanted = [&](const LawColumns& law) {
    return std::find(study.laws.begin(), study.laws.end(), law.law) != study.laws.end();
  };
  for (const auto& law : law_columns)
    if (wanted(law))
      for (const auto& name : law.names(from)) sheet.columns.push_back(name);
  const std::size_t behind_fit = sheet.columns.size();
  sheet.columns.insert(sheet.columns.end(), {"cpu_s", "wall_s"});
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [key, state] = found[i];
    Cells row = {static_cast<std::int64_t>(i + 1), key};
    for (const auto& input : study.runs[i].inputs)
      std::visit([&](const auto& level) { row.emplace_back(level); }, input);
    row.emplace_back(word(state));
    if (behind_fit > before_fit && state == Store::State::done) {
      const auto curve = press::read_curve(store.run(key) / "curve.csv");
      try {
        for (const auto& law : law_columns)
          if (wanted(law)) append(row, law.cells(curve, variant, from));
      } catch (const core::InvalidInput& problem) {
        throw core::InvalidInput(
            fmt::format("run {}, {}: {}", i + 1, (store.run(key) / "curve.csv").string(), problem.what()));
      }
    } else append(row, Cells(behind_fit - before_fit));
    if (state == Store::State::missing || state == Store::State::damaged) append(row, Cells(2));
    else append(row, {store.cost(key).cpu_s, store.cost(key).wall_s});
    sheet.rows.push_back(std::move(row));
  }
  return sheet;
}

Sheet curves_sheet(const Study& study, const Store& store, const std::vector<Found>& found, double step) {
  constexpr std::array branches = {"loading", "unloading", "reloading"};
  const auto any = [&](std::initializer_list<std::string_view> experiments) {
    return std::any_of(study.runs.begin(), study.runs.end(), [&](const Run& run) {
      return std::find(experiments.begin(), experiments.end(), press::name_of(run.press_case.experiment)) !=
             experiments.end();
    });
  };
  const bool x_walls = any({"die", "triaxial"}), y_walls = any({"triaxial"});
  Sheet sheet{
      "curves",
      {{"study", study.name}, {"engine", engines_of(study, store, found)}, {"step", core::number_text(step)}},
      {"run", "branch_id", "branch", "delta_bar", "F_bar", "a_bar"},
      {}};
  if (x_walls) sheet.columns.insert(sheet.columns.end(), {"F_bar_x", "a_bar_x"});
  if (y_walls) sheet.columns.insert(sheet.columns.end(), {"F_bar_y", "a_bar_y"});
  std::int64_t number = 0;
  for (const auto& [key, state] : found) {
    ++number;
    if (state != Store::State::done) continue;
    for (const auto& point : on_grid(press::read_curve(store.run(key) / "curve.csv"), step)) {
      Cells row = {number, std::int64_t{point.branch_id},
                   std::string(branches[static_cast<std::size_t>(point.branch)]), rounded(point.delta_bar)};
      const auto add = [&](const std::optional<Contact>& contact) {
        if (contact) append(row, {rounded(contact->F_bar), rounded(contact->a_bar)});
        else append(row, Cells(2));
      };
      add(point.z);
      if (x_walls) add(point.x);
      if (y_walls) add(point.y);
      sheet.rows.push_back(std::move(row));
    }
  }
  return sheet;
}

} // namespace platen::study
