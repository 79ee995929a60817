#pragma once
// What a law says about itself: its name, source and validity, and its parameters. Validation, messages, the
// reference pages, the command line, the C interface and the DEM codes read nothing else.

#include "platen/law/error.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace platen::law {

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// Whose a parameter is. Of a pair of unlike bodies the second one's has a key of its own: E_Pa, E2_Pa.
enum class Of : unsigned char { pair, body };

/// One parameter of a law; its key carries its unit.
struct Parameter {
  std::string key;
  std::string meaning;
  Range range;
  Of of = Of::pair;
  double fallback = required; ///< value where it is not given; NaN: it has to be
};

/// A parameter whose value is one of a few words, or a list of numbers ("0.1,0.3").
struct WordParameter {
  std::string key;
  std::string meaning;
  std::string values; ///< "simple|die|hydrostatic", the first is the fallback; empty: a list of numbers
};

struct LawInfo {
  std::string name;
  std::string title;
  std::string source;
  std::string validity;
  std::string variants; ///< "published|c1", the first is the default
  std::vector<Parameter> parameters;
  std::vector<WordParameter> words = {};
};

/// The key of the second body: a 2 before the unit.
inline std::string second_key(std::string_view key) {
  for (const std::string_view unit : {"_Pa", "_m", "_deg"})
    if (key.ends_with(unit))
      return std::string(key.substr(0, key.size() - unit.size())) + "2" + std::string(unit);
  return std::string(key) + "2";
}

inline Parameter youngs_modulus() { return {"E_Pa", "Young's modulus", positive, Of::body}; }
inline Parameter poissons_ratio() { return {"nu", "Poisson's ratio", poisson, Of::body}; }
inline Parameter strength_coefficient() {
  return {"kappa_Pa", "strength coefficient of sigma = kappa epsilon^(1/m)", positive, Of::body};
}
inline Parameter hardening_exponent() {
  return {"inverse_m", "hardening exponent 1/m, the same on both sides", {0, 1}};
}
inline Parameter yield_stress() { return {"sigma_y_Pa", "uniaxial yield stress", positive, Of::body}; }
inline WordParameter loading_case() {
  return {"loading", "how the particle is pressed", "simple|die|hydrostatic"};
}

/// Numbers of a published law that a fit may replace; 0 stands for the published closed form.
template <class Table>
std::vector<Parameter> with_coefficients(std::vector<Parameter> parameters, const Table& coefficients) {
  for (const auto& c : coefficients)
    parameters.push_back({std::string(c.key), std::string(c.meaning), c.range, Of::pair, 0});
  return parameters;
}

/// What every law takes beside its own: the two bodies.
inline LawInfo complete(LawInfo info) {
  constexpr Range any_length{0, infinity, true, true};
  std::vector<Parameter> all{{"radius_m", "radius of the first sphere", any_length},
                             {"radius2_m", "radius of the second; inf: a plane of the second material",
                              radius_or_plane, Of::pair, 0}};
  for (auto& p : info.parameters) all.push_back(p);
  for (const auto& p : info.parameters)
    if (p.of == Of::body)
      all.push_back({second_key(p.key), p.meaning + ", second body", p.range, Of::pair, 0});
  info.parameters = std::move(all);
  info.words.insert(info.words.begin(), {"against", "a second sphere, or a rigid plane", "sphere|plane"});
  return info;
}

} // namespace platen::law
