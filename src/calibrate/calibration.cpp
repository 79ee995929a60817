#include "calibrate/calibration.hpp"

#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace platen::calibrate {
namespace {

using core::InvalidInput;
using measure::Measurement, measure::Specimen;

// Two parameters cannot be told apart where they are so correlated and one of them is so uncertain.
constexpr double alike = 0.9, uncertain = 0.1;
constexpr double weak = 0.05; // relative standard error from which on the profile likelihood is asked

/// What is looked for in a material, as that of a law.
FreeLaw free_law_of(const Settings& settings) {
  if (!settings.material) return free_law(settings.law);
  const auto& m = *settings.material;
  return {"pressed", m.free(), m.strength(), true};
}

const law::Parameter* parameter(const law::LawInfo& info, std::string_view key) {
  for (const auto& p : info.parameters)
    if (p.key == key) return &p;
  return nullptr;
}

/// What the law needs beside what is looked for must be given: a curve does not show nu.
void refuse_missing(const FreeLaw& law, const Settings& settings) {
  const auto& info = law::find_law(settings.law);
  for (const auto& p : info.parameters) {
    const bool looked_for =
        std::ranges::any_of(law.parameters, [&](const auto& f) { return f.key == p.key; });
    const bool own = p.key == "sigma_ref_Pa"; // only its product with k is in the law
    if (!std::isnan(p.fallback) || looked_for || own || p.key == "radius_m" ||
        settings.given.contains(std::string(p.key)))
      continue;
    const bool option = p.key == "nu" || p.key == "E_Pa";
    throw InvalidInput(fmt::format("{} needs {}, {}, which a force curve does not show; give it with {}{}{}",
                                   settings.law, p.key, p.meaning, option ? "--" : "-p ", p.key,
                                   option ? " NUMBER" : "=NUMBER"));
  }
  for (const auto& [key, value] : settings.given) {
    const auto* known = parameter(info, key);
    if (!known) continue; // the law says it better
    if (const auto number = core::number_from(value); !number || !known->range.contains(*number))
      throw InvalidInput(fmt::format("{} = {} is not in {}", key, value, law::text(known->range)));
  }
}

/// S = F/(pi R^2 delta/R) where the force is largest.
double curve_stress(const Samples& s) {
  const auto top = std::ranges::max_element(s.force_N) - s.force_N.begin();
  const double delta = s.delta(static_cast<std::size_t>(top), s.contact_guess_m);
  if (!(delta > 0) || !(s.force_max_N > 0))
    throw InvalidInput("no force grows with the displacement; are these the right columns?");
  return s.force_max_N / (std::numbers::pi * s.radius_m * delta);
}

struct Quality {
  double R2 = 0, relative_l2 = 0;
};
Quality quality(const Particle& p) {
  const auto& F = p.samples.force_N;
  const double mean = std::accumulate(F.begin(), F.end(), 0.0) / static_cast<double>(F.size());
  double deviation = 0, spread = 0, square = 0;
  for (std::size_t i = 0; i < F.size(); ++i) {
    const double measured = p.measured_N(i);
    deviation += std::pow(measured - p.force_N[i], 2);
    spread += std::pow(F[i] - mean, 2);
    square += measured * measured;
  }
  return {1 - deviation / spread, std::sqrt(deviation / square)};
}

class Calibrator {
 public:
  Calibrator(const std::vector<Measurement>& measurements, const Settings& settings)
      : measurements_(measurements), settings_(settings), law_(free_law_of(settings)) {
    task_.card.law = law_.law;
    task_.card.variant = settings.variant;
    task_.card.parameters = settings.given;
    if (settings.material) make_of_material();
    else make_of_law();
    task_.scales = law_.scales;
    task_.strength = law_.strength;
    task_.ratio_most = law_.ratio_most;
    task_.free = free_parameters(settings);
    if (task_.free.empty()) throw InvalidInput("all parameters are given: nothing is left to be looked for");
  }

  void make_of_law() {
    refuse_missing(law_, settings_);
    task_.make = [this](law::ParameterTexts texts, double radius_m) -> AnyLaw {
      texts["radius_m"] = core::number_text(radius_m), texts["against"] = "plane";
      return fit::make_law(task_.card, texts);
    };
  }

  void make_of_material() {
    const auto typical = settings_.material->typical();
    task_.card.parameters["nu"] = core::number_text(material::initial_nu(typical.model));
    task_.make = [this](const law::ParameterTexts& texts, double radius_m) -> AnyLaw {
      try {
        return law::prepare_on_rigid_plane(settings_.curves.of(settings_.material->with(texts)), radius_m);
      } catch (const law::BadParameter& error) { throw InvalidInput(error.what()); }
    };
    if (!settings_.curves.astray) return;
    task_.astray = [this](const law::ParameterTexts& texts, double radius_m) {
      std::vector<AnyLaw> laws;
      for (const auto& m : settings_.curves.astray(settings_.material->with(texts)))
        laws.emplace_back(law::prepare_on_rigid_plane(m, radius_m));
      return laws;
    };
  }

  Calibration run() {
    collect();
    fit_each();
    fit_all();
    say_misfit();
    say_alike();
    say_scatter();
    c_.card = card_of(c_, task_.card, measurements_, settings_.machine);
    return std::move(c_);
  }

 private:
  void collect() {
    std::size_t all = 0;
    for (const auto& m : measurements_)
      for (const auto& s : m.specimens) {
        ++all;
        if (!s.diameter_m)
          throw InvalidInput(
              fmt::format("{}, line {}: the file does not say the diameter of {}; give --radius_m", s.file,
                          s.first_line, s.name));
        Particle p;
        p.stages = measure::stages_of(s);
        if (p.stages.broke) {
          const auto row = p.stages.broke->row;
          c_.broken.push_back(
              fmt::format("{} broke: line {}, the force fell by {:.0f} % while the platens closed; "
                          "kept out",
                          s.name, s.line[row], 100 * p.stages.broke->fell));
          continue;
        }
        p.file = s.file, p.name = s.name, p.diameter_m = *s.diameter_m;
        p.samples = samples_of(s, p.stages, settings_.machine, law_.has_unloading);
        p.rows = p.samples.rows;
        say_relaxation(s, p);
        c_.particles.push_back(std::move(p));
        specimens_.push_back(&s);
      }
    if (c_.particles.empty())
      throw InvalidInput(fmt::format("all {} particles broke: {}", all, fmt::join(c_.broken, "; ")));
    task_.curve_stress_Pa = curve_stress(c_.particles.front().samples);
    if (settings_.law == "edmans-sinka" && !settings_.given.contains("sigma_ref_Pa")) {
      task_.card.parameters["sigma_ref_Pa"] = core::number_text(task_.curve_stress_Pa);
      c_.said.push_back("only the product k sigma_ref is in the law; sigma_ref is the curve's own stress");
    }
    refuse_without_unloading();
    c_.free = task_.free;
  }

  /// The laws know no time.
  void say_relaxation(const Specimen& s, const Particle& p) {
    constexpr double noticed = 0.02;
    for (std::size_t i = 0; i < s.force_N.size();) {
      std::size_t end = i;
      while (end < s.force_N.size() && p.stages.of_row[end] == measure::Stage::hold) ++end;
      if (end == i) {
        ++i;
        continue;
      }
      const double fell = s.force_N[i] - s.force_N[end - 1];
      if (fell > noticed * p.samples.force_max_N && fell > 6 * p.stages.force_noise_N)
        c_.said.push_back(
            fmt::format("{}: in the hold from line {} on the force fell by {:.2g} % of the largest: it "
                        "relaxes, and the law knows no time",
                        s.name, s.line[i], 100 * fell / p.samples.force_max_N));
      i = end;
    }
  }

  void refuse_without_unloading() const {
    if (std::ranges::any_of(c_.particles, [](const auto& p) { return p.samples.unloads; })) return;
    for (const auto& free : task_.free)
      if (free.of_unloading)
        throw InvalidInput(fmt::format(
            "{} is seen in unloading alone, and nothing unloads here; give it with {}{}", free.key,
            free.key == "E_Pa" ? "--E_Pa NUMBER" : "-p ", free.key == "E_Pa" ? "" : free.key + "=NUMBER"));
  }

  /// One particle that cannot be fitted alone, as one of a batch that did not unload, does not stop the
  /// others.
  void fit_each() {
    std::vector<double> start = settings_.start; // where the first ended
    for (auto& p : c_.particles) {
      Task task = task_;
      std::erase_if(task.free, [&](const auto& f) { return f.of_unloading && !p.samples.unloads; });
      if (task.free.size() != task_.free.size()) continue;
      const Solution found = search(task, {p.samples}, start);
      if (start.empty()) start = found.values;
      p.values = found.values, p.errors = found.errors;
      p.samples.contact_guess_m = found.own.front().contact_m;
    }
  }

  /// The median of what each particle gave; empty where one gave nothing.
  std::vector<double> middle() const {
    std::vector<double> medians;
    for (std::size_t k = 0; k < task_.free.size(); ++k) {
      std::vector<double> each;
      for (const auto& p : c_.particles) {
        if (k >= p.values.size()) return {};
        each.push_back(p.values[k]);
      }
      std::ranges::nth_element(each, each.begin() + static_cast<long>(each.size() / 2));
      medians.push_back(each[each.size() / 2]);
    }
    return medians;
  }

  void take(const Solution& all) {
    c_.values = all.values, c_.errors = all.errors, c_.noise_errors = all.noise_errors;
    c_.correlations = all.correlations;
  }

  /// What a profile found to be better than the solution, if any did.
  std::optional<State> take_profiles(const Solution& all) {
    c_.profiles.clear();
    std::optional<State> better;
    for (std::size_t k = 0; k < task_.free.size(); ++k) {
      c_.profiles.emplace_back();
      if (!settings_.all_profiles && !weakly_determined(k)) continue;
      c_.profiles.back() = profile(task_, all, k, settings_.all_profiles);
      const auto& found = c_.profiles.back()->better;
      if (found && (!better || found->cost < better->cost)) better = found;
    }
    return better;
  }

  void fit_all() {
    std::vector<Samples> samples;
    for (const auto& p : c_.particles) samples.push_back(p.samples);
    Solution all = search(task_, samples, settings_.start.empty() ? middle() : settings_.start);
    constexpr int most = 3;
    for (int again = 0; again < most; ++again) {
      take(all);
      const auto better = take_profiles(all);
      if (!better) break;
      all = search_on(task_, all, *better);
    }
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < c_.particles.size(); ++i) {
      auto& p = c_.particles[i];
      const auto& s = *specimens_[i];
      const auto& own = all.own[i];
      p.contact_m = own.contact_m, p.contact_error_m = own.contact_error_m;
      p.contact = fmt::format("{} +- {:.2g}", s.on_scale_of_file(own.contact_m),
                              own.contact_error_m / s.travel_unit.in_SI);
      p.baseline_N = own.baseline_N, p.baseline_fitted = own.baseline_fitted;
      p.drift_N = own.drift_N, p.drift_fitted = own.drift_fitted;
      p.force_N = own.force_N;
      const Quality q = quality(p);
      p.R2 = q.R2, p.relative_l2 = q.relative_l2;
      for (std::size_t k = 0; k < p.samples.travel_m.size(); ++k)
        p.delta_bar_max = std::max(p.delta_bar_max, p.samples.delta(k, p.contact_m) / p.samples.radius_m);
      c_.delta_bar_max = std::max(c_.delta_bar_max, p.delta_bar_max);
      c_.rows += p.rows;
      sum += q.R2, weight += 1;
      c_.relative_l2 = std::max(c_.relative_l2, q.relative_l2);
    }
    c_.R2 = sum / weight;
    doubt(all);
    for (const auto& values : settings_.asked) tell(all, values);
  }

  void tell(const Solution& best, const std::vector<double>& values) {
    const Trial t = trial(task_, best, values);
    Told told{values, t.deviance, 0, 0, {}};
    if (t.own.empty()) told.relative_l2 = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < t.own.size(); ++i) {
      Particle p = c_.particles[i];
      p.baseline_N = t.own[i].baseline_N, p.drift_N = t.own[i].drift_N, p.force_N = t.own[i].force_N;
      const Quality q = quality(p);
      told.R2 += q.R2 / static_cast<double>(t.own.size());
      told.relative_l2 = std::max(told.relative_l2, q.relative_l2);
      told.force_N.push_back(p.force_N);
    }
    c_.told.push_back(std::move(told));
  }

  std::optional<double> known(std::string_view key) const {
    for (std::size_t k = 0; k < task_.free.size(); ++k)
      if (task_.free[k].key == key) return c_.values[k];
    const auto found = task_.card.parameters.find(std::string(key));
    return found == task_.card.parameters.end() ? std::nullopt : core::number_from(found->second);
  }

  void doubt(const Solution& all) {
    const auto& first = c_.particles.front();
    for (const auto& p : c_.particles) {
      fit::Claim claim;
      claim.name = c_.particles.size() > 1 ? p.name : p.file;
      claim.radius_m = p.samples.radius_m;
      claim.contact_known = true;
      claim.R2 = p.R2;
      for (std::size_t i = 0; i < p.samples.force_N.size(); ++i)
        if (p.samples.stage[i] == measure::Stage::loading) {
          claim.delta_m.push_back(p.samples.delta(i, p.contact_m));
          claim.force_N.push_back(p.measured_N(i));
        }
      claim.E_Pa = known("E_Pa");
      claim.nu = known("nu");
      if (settings_.law == "eepa") claim.E_Pa.reset(); // a stiffness by that name
      if (&p == &first) {
        if (!law_.strength.empty() && law_.strength != "sigma_ref_Pa")
          claim.strength_Pa = known(law_.strength);
        for (std::size_t k = 0; k < task_.free.size(); ++k)
          if (all.on_bound[k]) claim.on_bound.push_back(task_.free[k].key);
      }
      for (auto& d : fit::doubts_about(claim)) c_.doubts.push_back(std::move(d));
    }
  }

  bool weakly_determined(std::size_t k) const {
    if (!(c_.errors[k] < weak * std::abs(c_.values[k]))) return true;
    for (std::size_t j = 0; j < task_.free.size(); ++j)
      if (j != k && std::abs(c_.correlations[k][j]) > alike && (vague(k) || vague(j))) return true;
    return false;
  }

  bool vague(std::size_t k) const { return !(c_.errors[k] < uncertain * std::abs(c_.values[k])); }

  /// Standard errors know noise alone; particles of one batch may differ by more.
  void say_scatter() {
    for (std::size_t k = 0; k < task_.free.size(); ++k) {
      double low = std::numeric_limits<double>::infinity(), high = -low, error = 0;
      for (const auto& p : c_.particles)
        if (k < p.values.size())
          low = std::min(low, p.values[k]), high = std::max(high, p.values[k]),
          error = std::max(error, p.errors[k]);
      if (high - low > 8 * error && high - low > 0.1 * std::abs(c_.values[k]))
        c_.said.push_back(
            fmt::format("the particles differ by more than their noise: {} from {:.4g} to {:.4g}; is each "
                        "diameter right?",
                        task_.free[k].key, low, high));
    }
  }

  /// What is more than noise, the law or the material does not have.
  void say_misfit() {
    constexpr double noticed = 0.05, times = 3;
    const Particle* worst = nullptr;
    double worst_noise = 0;
    for (const auto& p : c_.particles) {
      double square = 0;
      for (double F : p.samples.force_N) square += F * F;
      const double noise =
          p.samples.force_noise_N / std::sqrt(square / static_cast<double>(p.samples.force_N.size()));
      if (p.relative_l2 > noticed + times * noise && (!worst || p.relative_l2 > worst->relative_l2))
        worst = &p, worst_noise = noise;
    }
    if (worst)
      c_.said.push_back(fmt::format(
          "{} misses {} by {:.2g} % (relative L2), and its noise is {:.2g} %: it is "
          "not such a {}",
          settings_.material ? "the material" : "law " + settings_.law, worst->name, 100 * worst->relative_l2,
          100 * worst_noise, settings_.material ? "material" : "particle"));
  }

  void say_alike() {
    for (std::size_t i = 0; i < task_.free.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        if (std::abs(c_.correlations[i][j]) > alike && (vague(i) || vague(j)))
          c_.said.push_back(
              fmt::format("these curves cannot tell {} and {} apart (correlation {:.3f}): give one of "
                          "them, or measure what parts them, as an unloading",
                          task_.free[j].key, task_.free[i].key, c_.correlations[i][j]));
      if (!(c_.errors[i] < 0.3 * std::abs(c_.values[i])) && task_.free[i].logarithmic)
        c_.said.push_back(fmt::format("these curves hardly determine {}: {}", task_.free[i].key,
                                      c_.profiles[i]
                                          ? words_of(*c_.profiles[i])
                                          : fmt::format("{:.3g} +- {:.2g}", c_.values[i], c_.errors[i])));
    }
  }

  const std::vector<Measurement>& measurements_;
  const Settings& settings_;
  const FreeLaw law_;
  Task task_;
  std::vector<const Specimen*> specimens_;
  Calibration c_;
};

} // namespace

std::vector<FreeParameter> free_parameters(const Settings& settings) {
  auto free = free_law_of(settings).parameters;
  std::erase_if(free, [&](const auto& p) { return settings.given.contains(p.key); });
  return free;
}

Calibration calibrate(const std::vector<Measurement>& measurements, const Settings& settings) {
  return Calibrator(measurements, settings).run();
}

} // namespace platen::calibrate
