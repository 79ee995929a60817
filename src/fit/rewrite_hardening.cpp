#include "fit/rewrite_hardening.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "fit/golden.hpp"
#include "fit/least_squares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace platen::fit {
namespace {

using material::Hardening, material::VonMises;

constexpr int samples = 400;    ///< middles of as many equal parts of the range
constexpr int evaluations = 40; ///< of a golden section: 4e-9 of its interval
/// Exponents 1/m, 1/n and eta that are looked at.
constexpr double exponent_least = 0.01, ludwik_most = 3, eta_most = 20;

struct Stress {
  std::vector<double> strain, sigma; ///< eps_p, Pa
};

double stress_of(const VonMises& m, double eps_p) {
  return material::yield_stress(m.hardening, m.E, m.sigma_y, eps_p).value;
}

Stress sampled(const VonMises& m, const StrainRange& range) {
  Stress s;
  for (int i = 0; i < samples; ++i) {
    s.strain.push_back(range.from + (range.to - range.from) * (i + 0.5) / samples);
    s.sigma.push_back(stress_of(m, s.strain.back()));
  }
  return s;
}

VonMises with(VonMises m, double sigma_y, Hardening hardening) {
  m.hardening = std::move(hardening);
  m.sigma_y = initial_yield_stress(m.hardening, m.E, sigma_y);
  return m;
}

/// Sum of (sigma' - sigma)^2.
double misfit(const VonMises& m, const Stress& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.strain.size(); ++i)
    sum += std::pow(stress_of(m, s.strain[i]) - s.sigma[i], 2);
  return sum;
}

/// `count` numbers from low to high, by equal factors or by equal steps.
std::vector<double> between(double low, double high, int count, bool by_factors) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    all.push_back(by_factors ? low * std::pow(high / low, t) : low + (high - low) * t);
  }
  return all;
}

/// The exponent whose material misses the stress least; what the others are for it is `best`'s affair.
VonMises best_exponent(const Stress& s, const std::string& kind, const std::string& exponent,
                       const std::vector<double>& candidates, const std::function<VonMises(double)>& best) {
  const auto found = scanned_minimum([&](double e) { return misfit(best(e), s); }, candidates, evaluations);
  const double low = candidates.front(), high = candidates.back(), near = 1e-6 * (high - low);
  if (found.at < low + near || found.at > high - near)
    throw core::InvalidInput(fmt::format(
        "no {} law follows this stress: {} ends at {}, on the bound of {} to {}; take another kind, or a "
        "table",
        kind, exponent, core::number_text(found.at), low, high));
  return best(found.at);
}

VonMises as_none(const VonMises& m, const Stress& s, const StrainRange&) {
  double mean = 0;
  for (const double sigma : s.sigma) mean += sigma / samples;
  return with(m, mean, material::PerfectlyPlastic{});
}

/// sigma_y is linear: sum sigma exp/sum exp^2.
VonMises as_exponential(const VonMises& m, const Stress& s, const StrainRange&) {
  return best_exponent(s, "exponential", "eta", between(-eta_most, eta_most, 81, false), [&](double eta) {
    double top = 0, bottom = 0;
    for (std::size_t i = 0; i < s.strain.size(); ++i) {
      const double e = std::exp(eta * s.strain[i]);
      top += e * s.sigma[i], bottom += e * e;
    }
    return with(m, top / bottom, material::ExponentialHardening{eta});
  });
}

VonMises as_hollomon(const VonMises& m, const Stress& s, const StrainRange&) {
  const double top = *std::max_element(s.sigma.begin(), s.sigma.end());
  // 1/m = 1 is a straight line, which is a law of this kind.
  return best_exponent(s, "hollomon", "1/m", between(exponent_least, 1, 40, true), [&](double inverse_m) {
    const auto of = [&](double log_kappa) {
      return with(m, 0, material::Hollomon{std::exp(log_kappa), inverse_m});
    };
    const double high = std::min(std::log(0.999 * m.E), std::log(top) + 5);
    const auto kappa =
        golden_section([&](double k) { return misfit(of(k), s); }, std::log(top) - 5, high, evaluations);
    return of(kappa.at);
  });
}

/// sigma_y and K are linear.
VonMises as_ludwik(const VonMises& m, const Stress& s, const StrainRange&) {
  return best_exponent(
      s, "ludwik", "1/n", between(exponent_least, ludwik_most, 60, true), [&](double inverse_n) {
        // The law's own shape, with its parabola near 0: what K = 1 adds to no yield stress, in units of a K
        // near the one sought, on which the parabola depends a little.
        double K = *std::max_element(s.sigma.begin(), s.sigma.end()), sigma_y = 0;
        for (int i = 0; i < 3; ++i) {
          std::vector<double> power;
          for (const double strain : s.strain)
            power.push_back(stress_of(with(m, 0, material::Ludwik{K, inverse_n}), strain) / K);
          const auto c = least_squares({std::vector<double>(s.strain.size(), 1.0), power}, s.sigma);
          sigma_y = c[0];
          if (!(c[1] > 0)) return with(m, as_none(m, s, {}).sigma_y, material::PerfectlyPlastic{});
          K = c[1];
        }
        return with(m, sigma_y, material::Ludwik{K, inverse_n});
      });
}

VonMises as_table(const VonMises& m, const Stress&, const StrainRange& range) {
  std::vector<double> strain, stress;
  constexpr int points = material::HardeningTable::size_max;
  for (int i = 0; i < points; ++i) {
    strain.push_back(range.to * std::pow(static_cast<double>(i) / (points - 1), 4));
    stress.push_back(stress_of(m, strain.back()));
  }
  return with(m, 0, material::HardeningTable{strain, stress});
}

using Rewrite = VonMises (*)(const VonMises&, const Stress&, const StrainRange&);
const std::map<std::string, Rewrite> rewrites = {{"none", as_none},
                                                 {"exponential", as_exponential},
                                                 {"hollomon", as_hollomon},
                                                 {"ludwik", as_ludwik},
                                                 {"table", as_table}};

} // namespace

RewrittenHardening rewrite_hardening(const VonMises& m, const std::string& kind, StrainRange range) {
  const auto rewrite = rewrites.find(kind);
  if (rewrite == rewrites.end()) {
    std::vector<std::string> kinds;
    for (const auto& [name, of] : rewrites) kinds.push_back(name);
    throw core::InvalidInput(fmt::format("there is no hardening {}{}", kind, core::suggestion(kind, kinds)));
  }
  if (!(range.from >= 0 && range.from < range.to && range.to <= 100))
    throw core::InvalidInput(fmt::format(
        "plastic strains from {} to {}: they must ascend, from 0 to 100 at most", range.from, range.to));
  const Stress s = sampled(m, range);
  RewrittenHardening out{rewrite->second(m, s, range)};
  if (kind == "ludwik" &&
      !(std::holds_alternative<material::Ludwik>(out.material.hardening) && out.material.sigma_y > 0))
    throw core::InvalidInput(
        "no ludwik law follows this stress: it would need a strength K or a yield stress below 0; "
        "take another kind, or a table");
  double norm = 0;
  for (const double sigma : s.sigma) norm += sigma * sigma;
  out.relative_rms = std::sqrt(misfit(out.material, s) / norm);
  const auto look = [&](double strain) {
    const double error = std::abs(stress_of(out.material, strain) / stress_of(m, strain) - 1);
    if (error > out.worst) out.worst = error, out.worst_at = strain;
  };
  look(range.from), look(range.to);
  for (const double strain : s.strain) look(strain);
  return out;
}

} // namespace platen::fit
