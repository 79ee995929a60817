#include "surrogate/rock.hpp"

#include "core/catalogue.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/wang.hpp"
#include "press/strength.hpp"
#include "study/card.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

namespace fs = std::filesystem;

constexpr Coefficients elastic = {1, 1.5, 1, 1.5};
constexpr const char* file_name = "grains.csv";

struct Ends {
  double low, high;
};
Ends ends_of(const Rock& rock, double Grain::*member) {
  const auto [low, high] =
      std::minmax_element(rock.grains.begin(), rock.grains.end(),
                          [&](const Grain& x, const Grain& y) { return x.*member < y.*member; });
  return {(*low).*member, (*high).*member};
}
double over_range(const Rock& rock, const Grain& g, double Grain::*member) {
  const auto [low, high] = ends_of(rock, member);
  return (g.*member - low) / (high - low);
}

Inputs inputs_of(const Rock& rock, RockInterpolation::CoordinatesOf coordinates) {
  Inputs inputs;
  for (const Grain& g : rock.grains) {
    const auto row = coordinates(rock, g);
    inputs.dimensions = row.size();
    inputs.values.insert(inputs.values.end(), row.begin(), row.end());
  }
  return inputs;
}

/// F over F_y at omega, as the law has it.
double force_at(const Coefficients& c, double omega) {
  return omega < 1 ? std::pow(omega, 1.5) : c[0] * std::pow(omega, c[1]);
}
double omega_at(const Coefficients& c, double force) {
  const double omega = std::pow(force / c[0], 1 / c[1]);
  return omega < 1 ? std::min(1.0, std::pow(force, 1 / 1.5)) : omega;
}

std::string grain_words(const Rock& rock, const Grain& g) {
  return fmt::format("{}-{}: E = {:.3g} GPa, nu = {:.3g}, phi = {:.3g} degrees, sigma_c = {:.3g} MPa",
                     rock.pool, g.run, g.E_Pa / 1e9, g.nu, g.phi_deg, g.sigma_c_Pa / 1e6);
}

} // namespace

double yield_of(const Rock& rock, const Grain& g) {
  return fit::first_yield(g.E_Pa, g.nu, g.phi_deg, g.sigma_c_Pa, rock.radius_m).F_N / rock.force_N;
}

std::vector<double> coordinates_of(const Rock& rock, const Grain& g) {
  return {over_range(rock, g, &Grain::nu), over_range(rock, g, &Grain::phi_deg),
          std::log(yield_of(rock, g)) / 4};
}

std::vector<double> four_coordinates_of(const Rock& rock, const Grain& g) {
  return {over_range(rock, g, &Grain::E_Pa), over_range(rock, g, &Grain::nu),
          over_range(rock, g, &Grain::phi_deg), over_range(rock, g, &Grain::sigma_c_Pa)};
}

RockInterpolation::RockInterpolation(const Rock& rock, CoordinatesOf coordinates)
    : rock_(rock), coordinates_(coordinates), neighbours_(inputs_of(rock, coordinates)) {}

std::vector<Share> RockInterpolation::shares(const Grain& g) const {
  return neighbours_.shares(coordinates_(rock_, g));
}

std::optional<Coefficients> RockInterpolation::at(const Grain& g) const {
  const auto around = shares(g);
  if (around.empty()) return {};
  Coefficients c{};
  for (const auto& [site, share] : around)
    for (std::size_t k = 0; k < 4; ++k) {
      const double value = rock_.grains[site].of[k];
      c[k] += share * (k % 2 == 0 ? std::log(value) : value);
    }
  for (const std::size_t k : {0, 2}) c[k] = std::exp(c[k]);
  return c;
}

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
    Grain g{static_cast<int>(i) + 1, m->E, m->nu, m->friction_deg(), m->sigma_c, elastic};
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

Rock read_rock(const core::Csv& csv) {
  Rock rock;
  rock.pool = csv.note("pool");
  rock.engine = static_cast<int>(csv.number_note("engine"));
  rock.radius_m = csv.number_note("radius_m");
  rock.force_N = csv.number_note("force_N");
  auto& e = rock.left_out;
  e.materials = static_cast<int>(csv.number_note("left_out.materials"));
  const auto errors = [&](const char* name) {
    const auto one = [&](const char* which) {
      return csv.number_note(fmt::format("left_out.{}.{}", name, which));
    };
    return Quantiles{one("median"), one("p95"), one("worst")};
  };
  for (std::size_t k = 0; k < 4; ++k) e.of[k] = errors(coefficient_names[k]);
  e.force = errors("force");
  e.work = errors("work");
  for (const auto& row : csv.rows) {
    const auto at = [&](const char* column) { return csv.number(row, csv.column(column)); };
    rock.grains.push_back({static_cast<int>(at("run")),
                           at("E_Pa"),
                           at("nu"),
                           at("phi_deg"),
                           at("sigma_c_Pa"),
                           {at("a"), at("b"), at("m"), at("n")}});
  }
  if (!(rock.radius_m > 0 && rock.force_N > 0) || rock.grains.empty())
    throw core::InvalidInput(fmt::format("{}: no grains, or no radius and force; make it again with `platen "
                                         "study surrogate`",
                                         csv.file));
  return rock;
}

namespace {

Rock rock_of_catalogue(const std::string& advice) {
  std::error_code error;
  for (const auto& catalogue : core::catalogues())
    if (const auto file = catalogue / "pools/wang" / file_name; fs::is_regular_file(file, error))
      return read_rock(file);
  throw core::InvalidInput(
      fmt::format("the catalogue has no grains of rock, pools/wang/{}; {}", file_name, advice));
}

Grain grain_of(const material::Material& material) {
  const auto* m = std::get_if<material::DruckerPrager>(&material.model);
  if (!m)
    throw core::InvalidInput(
        fmt::format("{}: the law wang is predicted of drucker-prager materials alone", material.name));
  if (m->psi_deg != m->beta_deg || m->flow_stress_ratio != 1)
    throw core::InvalidInput(fmt::format(
        "{}: the grains were pressed with associated flow (psi_deg = beta_deg) and flow_stress_ratio "
        "= 1; `platen derive` presses others",
        material.name));
  return {0, m->E, m->nu, m->friction_deg(), m->sigma_c, {}};
}

} // namespace

PredictedRock predict_rock(const material::Material& material, const std::string& advised_card) {
  const std::string advice = fmt::format("`platen derive {} --radius_m R -o DIR` presses it", advised_card);
  const Grain g = grain_of(material);
  PredictedRock p;
  p.rock = rock_of_catalogue(advice);
  const Rock& rock = p.rock;
  p.yield = yield_of(rock, g);
  std::vector<std::string> beyond;
  struct Bound {
    const char* words;
    double Grain::*member;
    double unit;
    bool matters;
  };
  for (const Bound& b :
       {Bound{"nu = {:.4g} is not in {:.4g} to {:.4g}", &Grain::nu, 1, true},
        {"phi = {:.4g} degrees is not in {:.4g} to {:.4g}", &Grain::phi_deg, 1, true},
        {"E = {:.4g} GPa, where {:.4g} to {:.4g} were pressed", &Grain::E_Pa, 1e9, false},
        {"sigma_c = {:.4g} MPa, where {:.4g} to {:.4g} were pressed", &Grain::sigma_c_Pa, 1e6, false}}) {
    const auto [low, high] = ends_of(rock, b.member);
    const double x = g.*b.member;
    if (x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9)) continue;
    (b.matters ? beyond : p.reasons)
        .push_back(fmt::format(fmt::runtime(b.words), x / b.unit, low / b.unit, high / b.unit));
  }
  const RockInterpolation interpolation(rock);
  const auto said = beyond.empty() ? interpolation.at(g) : std::nullopt;
  const bool stays_elastic = beyond.empty() && !said && p.yield > 1;
  if (!said && !stays_elastic) {
    if (beyond.empty())
      beyond.push_back(fmt::format(
          "it yields at {:.2g} of the force that the grains were pressed to, no grain so early", p.yield));
    throw core::InvalidInput(fmt::format(
        "{} is outside of what was pressed (pool {}): {}; {} (natural neighbours do not extrapolate)",
        material.name, rock.pool, fmt::join(beyond, "; "), advice));
  }
  p.of = said ? *said : elastic;
  if (!p.reasons.empty()) p.verdict = Verdict::near_the_edge;
  if (said) {
    auto around = interpolation.shares(g);
    std::stable_sort(around.begin(), around.end(),
                     [](const Share& x, const Share& y) { return x.share > y.share; });
    for (std::size_t i = 0; i < std::min<std::size_t>(3, around.size()); ++i)
      p.near.push_back(grain_words(rock, rock.grains[around[i].site]));
  }
  auto& card = p.card;
  card.law = "wang";
  card.variant = "fitted";
  const auto put = [&](const char* key, double value) {
    card.parameters[key] = core::number_text(*core::number_from(fmt::format("{:.6g}", value)));
  };
  for (const auto& [key, value] :
       {std::pair{"E_Pa", g.E_Pa}, {"nu", g.nu}, {"phi_deg", g.phi_deg}, {"sigma_c_Pa", g.sigma_c_Pa}})
    card.parameters[key] = core::number_text(value);
  for (std::size_t k = 0; k < 4; ++k) put(coefficient_names[k], p.of[k]);
  const double delta_y_bar =
      fit::first_yield(g.E_Pa, g.nu, g.phi_deg, g.sigma_c_Pa, rock.radius_m).delta_m / rock.radius_m;
  card.delta_bar = {0, *core::number_from(fmt::format("{:.4g}", delta_y_bar * omega_at(p.of, 1 / p.yield)))};
  card.errors = {{"relative_l2", rock.left_out.force.p95}}; // nineteen in twenty are better
  card.provenance = {{"material", material.name},
                     {"pool", rock.pool},
                     {"runs", static_cast<int>(rock.grains.size())},
                     {"approach", std::string("Hertz-consistent, far field of the sphere taken out")},
                     {"verdict", std::string(name_of(p.verdict))},
                     {"engine", rock.engine}};
  return p;
}

} // namespace platen::surrogate
