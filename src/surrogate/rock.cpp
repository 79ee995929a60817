#include "surrogate/rock.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/first_yield.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace platen::surrogate {
namespace {

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

std::string grain_words(const Rock& rock, const Grain& g) {
  return fmt::format("{}-{}: E = {:.3g} GPa, nu = {:.3g}, phi = {:.3g} degrees, sigma_c = {:.3g} MPa",
                     rock.pool, g.run, g.E_Pa / 1e9, g.nu, g.phi_deg, g.sigma_c_Pa / 1e6);
}

} // namespace

double force_at(const Coefficients& c, double omega) {
  return omega < 1 ? std::pow(omega, 1.5) : c[0] * std::pow(omega, c[1]);
}
double omega_at(const Coefficients& c, double force) {
  const double omega = std::pow(force / c[0], 1 / c[1]);
  return omega < 1 ? std::min(1.0, std::pow(force, 1 / 1.5)) : omega;
}

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

std::string advice_to_press(const std::string& card) {
  return fmt::format("`platen derive {} --radius_m R -o DIR` presses it", card);
}

PredictedRock predict_rock(const RockInterpolation& interpolation, const material::Material& material,
                           const std::string& advised_card) {
  const std::string advice = advice_to_press(advised_card);
  const Grain g = grain_of(material);
  const Rock& rock = interpolation.rock();
  PredictedRock p;
  p.rock = rock;
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
  p.of = said ? *said : of_elastic;
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
