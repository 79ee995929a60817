// Rock: the pool, its errors and its file; what is predicted of it is in rock.cpp.

#include "surrogate/rock.hpp"

#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "study/card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "grains.csv";

Rock rock_of_catalogue(const std::string& advice) {
  std::error_code error;
  for (const auto& catalogue : core::catalogues())
    if (const auto file = catalogue / "pools/wang" / file_name; fs::is_regular_file(file, error))
      return read_rock(file);
  throw core::InvalidInput(
      fmt::format("the catalogue has no grains of rock, pools/wang/{}; {}", file_name, advice));
}

} // namespace

RockErrors errors_of(const Rock& rock, const std::vector<std::optional<Coefficients>>& said) {
  std::array<std::vector<double>, 4> of;
  std::vector<double> force, work;
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!said[i]) continue;
    const Coefficients &c = *said[i], &truth = rock.grains[i].of;
    for (std::size_t k = 0; k < 4; ++k) of[k].push_back(std::abs(c[k] / truth[k] - 1));
    const double F_max = 1 / yield_of(rock, rock.grains[i]), omega_max = omega_at(truth, F_max);
    double squares = 0, all = 0;
    constexpr int steps = 200;
    for (int s = 1; s <= steps; ++s) {
      const double omega = omega_max * (s - 0.5) / steps, F = force_at(truth, omega);
      squares += std::pow(force_at(c, omega) - F, 2);
      all += F * F;
    }
    force.push_back(std::sqrt(squares / all));
    // (17) and (18): F_max (F_max/m)^(1/n)/(n + 1) is given back
    const auto returned = [&](const Coefficients& x) {
      return std::pow(F_max / x[2], 1 / x[3]) / (x[3] + 1);
    };
    work.push_back(std::abs(returned(c) / returned(truth) - 1));
  }
  RockErrors errors;
  for (std::size_t k = 0; k < 4; ++k) errors.of[k] = quantiles(of[k]);
  errors.force = quantiles(force);
  errors.work = quantiles(work);
  errors.materials = static_cast<int>(force.size());
  return errors;
}

RockErrors errors_beside(const Rock& rock, const Rock& other) {
  if (rock.engine != other.engine || rock.radius_m != other.radius_m || rock.force_N != other.force_N)
    throw core::InvalidInput(
        fmt::format("pools {} and {} differ in engine, radius or largest force", rock.pool, other.pool));
  const RockInterpolation interpolation(rock);
  std::vector<std::optional<Coefficients>> said;
  for (const Grain& g : other.grains) said.push_back(interpolation.at(g));
  return errors_of(other, said);
}

std::vector<std::optional<Coefficients>> left_out_by_neighbours(
    const Rock& rock, RockInterpolation::CoordinatesOf coordinates) {
  std::vector<std::optional<Coefficients>> said;
  for (std::size_t i = 0; i < rock.grains.size(); ++i) {
    Rock others = rock;
    others.grains.erase(others.grains.begin() + static_cast<std::ptrdiff_t>(i));
    said.push_back(RockInterpolation(others, coordinates).at(rock.grains[i]));
  }
  return said;
}

bool is_of_rock(const fs::path& folder) {
  const auto study = study::read_study((folder / "study.toml").string());
  return std::ranges::find(study.laws, "wang") != study.laws.end();
}

Rock rock_of_pool(const fs::path& folder) {
  const auto study = study::read_study((folder / "study.toml").string());
  const auto runs = core::read_csv(folder / "runs.csv");
  Rock rock;
  rock.pool = fs::weakly_canonical(folder).filename().string();
  rock.engine = static_cast<int>(runs.number_note("engine"));
  const auto refuse = [&](const std::string& why) {
    throw core::InvalidInput(fmt::format("{}: {}", folder.string(), why));
  };
  if (runs.rows.size() != study.runs.size())
    refuse(
        fmt::format("{} runs, where the study has {}; export it again", runs.rows.size(), study.runs.size()));
  const auto state = runs.column("state");
  for (std::size_t i = 0; i < study.runs.size(); ++i) {
    const auto& c = study.runs[i].press_case;
    const auto* local = std::get_if<press::Local>(&c.experiment);
    const auto* m = std::get_if<material::DruckerPrager>(&c.material.model);
    if (!local || !m) refuse(fmt::format("run {} is no local press of a drucker-prager material", i + 1));
    if (i == 0) rock.radius_m = c.radius_m, rock.force_N = local->force_max_N;
    if (c.radius_m != rock.radius_m || local->force_max_N != rock.force_N)
      refuse(fmt::format("run {} has another radius or force than the first", i + 1));
    const auto& row = runs.rows[i];
    if (row.cells[state] != "done") continue;
    Grain g{static_cast<int>(i) + 1, m->E, m->nu, m->friction_deg(), m->sigma_c, of_elastic};
    if (!row.cells[runs.column("wang.m")].empty())
      for (std::size_t k = 0; k < 4; ++k)
        g.of[k] = runs.number(row, runs.column(fmt::format("wang.{}", coefficient_names[k])));
    rock.grains.push_back(g);
  }
  if (rock.grains.size() < 5)
    refuse(fmt::format("{} runs are done; five are wanted at least", rock.grains.size()));
  rock.left_out = errors_of(rock, left_out_by_neighbours(rock));
  return rock;
}

std::string text_of(const Rock& rock) {
  std::string text = fmt::format(
      "# pool = {}\n# engine = {}\n# radius_m = {}\n# force_N = {}\n# note = coefficients of the law wang, "
      "elastic "
      "where a grain does not yield, or hardly; errors: median, of five in a hundred larger, worst\n",
      rock.pool, rock.engine, core::number_text(rock.radius_m), core::number_text(rock.force_N));
  const auto& e = rock.left_out;
  text += fmt::format("# left_out.materials = {}\n", e.materials);
  const auto add = [&](const char* name, const Quantiles& q) {
    text += fmt::format(
        "# left_out.{0}.median = {1:.3g}\n# left_out.{0}.p95 = {2:.3g}\n# left_out.{0}.worst = {3:.3g}\n",
        name, q.median, q.p95, q.worst);
  };
  for (std::size_t k = 0; k < 4; ++k) add(coefficient_names[k], e.of[k]);
  add("force", e.force);
  add("work", e.work);
  text += "run,E_Pa,nu,phi_deg,sigma_c_Pa,a,b,m,n\n";
  for (const Grain& g : rock.grains) {
    text += fmt::format("{}", g.run);
    for (const double x : {g.E_Pa, g.nu, g.phi_deg, g.sigma_c_Pa, g.of[0], g.of[1], g.of[2], g.of[3]})
      text += fmt::format(",{:.8g}", x);
    text += "\n";
  }
  return text;
}

Rock read_rock(const fs::path& file) { return read_rock(core::read_csv(file)); }

PredictedRock predict_rock(const material::Material& material, const std::string& advised_card) {
  const Rock rock = rock_of_catalogue(advice_to_press(advised_card));
  return predict_rock(RockInterpolation(rock), material, advised_card);
}

} // namespace platen::surrogate
