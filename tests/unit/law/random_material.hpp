#pragma once
// A random material of any law, as texts, from what the law says of its parameters.

#include "platen/law/catalogue.hpp"

#include <cstdio>
#include <cstdlib>
#include <random>

namespace platen::law::testing {

/// Random numbers, the same in each quick run; `./run verify` draws others (RC_PARAMS=seed=N repeats them).
class Random {
 public:
  Random() {
    const char* asked = std::getenv("RC_PARAMS");
    const std::string text = asked ? asked : "";
    const auto at = text.find("seed=");
    engine_.seed(at == text.npos ? std::random_device{}() : std::stoull(text.substr(at + 5)));
  }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double log_between(double low, double high) { return low * std::pow(high / low, unit()); }

 private:
  std::mt19937_64 engine_;
};

inline std::string text_of(const LawChoice& one) {
  std::string text = one.name + " --variant " + one.variant;
  for (const auto& [key, value] : one.parameters) text += " -p " + key + "=" + value;
  return text;
}

inline std::string digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// One body, without radius.
inline LawChoice random_material(const LawInfo& info, Random& random) {
  LawChoice one{info.name, "", {}};
  const auto variants = detail::split(info.variants, '|');
  one.variant = variants[static_cast<std::size_t>(random.unit() * static_cast<double>(variants.size()))];
  const bool rock = info.name == "wang";
  const double E = rock ? random.between(10e9, 30e9) : random.log_between(1e8, 1e11);
  const double strength =
      E / random.log_between(info.name == "shahin" || info.name == "similarity" ? 2 : 60, 5000);
  const double k_1 = random.log_between(1e2, 1e6);
  for (const auto& p : info.parameters) {
    const auto set = [&](double value) { one.parameters[p.key] = digits(value); };
    if (p.key == "radius_m" || p.key == "radius2_m" || p.key.find('2') != std::string::npos) {
      if (p.key == "k_2_N_per_m") set(k_1 * random.log_between(1, 20));
    } else if (p.key == "E_Pa") set(E);
    else if (p.key == "nu") set(rock ? random.between(0.1, 0.3) : random.between(0, 0.45));
    else if (p.key == "sigma_c_Pa") set(random.between(5e6, 50e6));
    else if (p.key == "phi_deg") set(random.between(20, 40));
    else if (p.key.ends_with("_Pa")) set(strength);
    else if (p.key == "k_1_N_per_m") set(k_1);
    else if (p.key == "phi_f") set(random.log_between(0.01, 0.5));
    else if (p.key == "inverse_m") set(random.unit());
    else if (p.key == "lambda_p") set(random.between(0, 0.95));
    else if (p.key == "n" && info.name == "eepa") set(random.between(1, 2));
    else if (info.name == "edmans-sinka" && p.key == "k") set(random.log_between(0.5, 7));
    else if (info.name == "edmans-sinka" && p.key == "delta_t") set(random.between(0.03, 0.3));
    else if (info.name == "edmans-sinka" && p.key == "a") set(random.between(0.5, 6));
    else if (rock && one.variant == "fitted")
      set(p.key == "a" || p.key == "m" ? random.between(0.9, 1.6) : random.between(1.3, 1.5));
    else if (std::isnan(p.fallback))
      set(random.between(std::max(p.range.low, 0.0), std::min(p.range.high, 1.0)));
  }
  for (const auto& w : info.words) {
    if (w.key == "against" || w.key == "kind" || w.values.empty()) continue;
    const auto values = detail::split(w.values, '|');
    one.parameters[w.key] =
        values[static_cast<std::size_t>(random.unit() * static_cast<double>(values.size()))];
  }
  if (info.name == "edmans-sinka" && random.unit() < 0.5) { // radii of presses, from the metal's to granules'
    double a = random.between(0.14, 0.2);
    one.parameters["radius_delta_bar"] = "0.02,0.05,0.1,0.2,0.5";
    one.parameters["a_bar"] = digits(a);
    for (const double ratio : {2.5, 2.0, 2.0, 2.5})
      one.parameters["a_bar"] += "," + digits(a *= std::pow(ratio, random.between(0.3, 0.6)));
  }
  if (info.name == "edmans-sinka" && random.unit() < 0.5) {
    one.parameters["unload_delta_bar"] = "0.1,0.3,0.5";
    one.parameters["alpha"] = digits(random.between(1.2, 1.8)) + "," + digits(random.between(1.2, 1.8)) +
                              "," + digits(random.between(1.2, 1.8));
    one.parameters["beta"] = digits(random.between(1, 3)) + "," + digits(random.between(1, 3)) + "," +
                             digits(random.between(1, 3));
  }
  if (info.name == "pressed") { // Hertz that gives way to a linear, then stiffening curve, as granules do
    const double E_flat = E / (1 - std::pow(std::stod(one.parameters["nu"]), 2)),
                 yield = random.log_between(2e-6, 2e-2);
    const double stiffening = random.between(0, 4), a_more = random.between(1, 1.6);
    std::string x_text, F_text, a_text;
    for (int i = 0; i < 40; ++i) {
      const double x = 1e-4 * std::pow(5e3, i / 39.0);
      const double hertz = 4.0 / 3 * E_flat * x * std::sqrt(x), late = std::sqrt(yield / x);
      const double F = hertz * std::pow(1 + std::pow(1 / late, 3), -1.0 / 3) * std::exp(stiffening * x);
      const double a = std::sqrt(x) * (1 + (a_more - 1) * x / (x + yield));
      const char* comma = i ? "," : "";
      x_text += comma + digits(x);
      F_text += comma + digits(F / (3.14159 * strength));
      a_text += comma + digits(a);
    }
    one.parameters["delta_bar"] = x_text;
    one.parameters["F_bar"] = F_text;
    one.parameters["a_bar"] = a_text;
    if (random.unit() < 0.7) {
      one.parameters["unload_delta_bar"] = "0.1,0.3,0.5";
      one.parameters["alpha"] =
          digits(random.between(1.2, 1.8)) + "," + digits(random.between(1.2, 1.8)) + ",1.4";
      one.parameters["beta"] = digits(random.between(1, 2)) + "," + digits(random.between(1, 2)) + ",1.5";
    }
  }
  return one;
}

} // namespace platen::law::testing
