#pragma once
// Every law by name, at run time: what a command line, a law card or the C interface needs. A DEM code that
// knows its law at compile time includes that law's header alone and calls `prepare` itself.

#include "platen/law/agarwal.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/eepa.hpp"
#include "platen/law/etsion_unloading.hpp"
#include "platen/law/hertz.hpp"
#include "platen/law/jackson_green.hpp"
#include "platen/law/kogut_etsion.hpp"
#include "platen/law/luding.hpp"
#include "platen/law/mdr.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/thornton_ning.hpp"
#include "platen/law/wang.hpp"

#include <limits>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace platen::law {

using AnyLaw = std::variant<Hertz<double>, Similarity<double>, EdmansSinka<double>, Wang<double>, Agarwal,
                            Shahin, ThorntonNing<double>, KogutEtsion<double>, EtsionUnloading<double>,
                            JacksonGreen, Mdr, Luding<double>, Eepa<double>>;

inline constexpr double required = std::numeric_limits<double>::quiet_NaN();

/// One parameter of a law; its key carries its unit. This table gives validation, messages and the reference.
struct Parameter {
  std::string_view key;
  std::string_view meaning;
  Range range;
  double fallback = required; ///< value where it is not given; NaN: it has to be
};

/// A parameter whose value is one of a few words, or a list of numbers ("0.1,0.3").
struct WordParameter {
  std::string_view key;
  std::string_view meaning;
  std::string_view values; ///< "simple|die|hydrostatic", the first is the fallback; empty: a list of numbers
};

struct LawInfo {
  std::string_view name;
  std::string_view title;
  std::string_view source;
  std::string_view validity;
  std::string_view variants; ///< "published|c1", the first is the default
  std::vector<Parameter> parameters;
  std::vector<WordParameter> words;
};

/// "key" -> text of its value, as in `key=value`.
using ParameterTexts = std::map<std::string, std::string, std::less<>>;

inline const std::vector<LawInfo>& laws() {
  static const std::vector<LawInfo> all = [] {
    constexpr Range any_length{0, infinity, true, true}, fraction{0, 1};
    const Parameter R{"radius_m", "radius of the first sphere", any_length};
    const Parameter R2{"radius2_m", "radius of the second; inf: a plane of the second material",
                       radius_or_plane, 0};
    const Parameter E{"E_Pa", "Young's modulus", positive};
    const Parameter nu{"nu", "Poisson's ratio", poisson};
    const Parameter E2{"E2_Pa", "Young's modulus of the second body", positive, 0};
    const Parameter nu2{"nu2", "Poisson's ratio of the second body", poisson, -1};
    const Parameter kappa{"kappa_Pa", "strength coefficient of sigma = kappa epsilon^(1/m)", positive};
    const Parameter kappa2{"kappa2_Pa", "strength coefficient of the second body", positive, 0};
    const Parameter inverse_m{"inverse_m", "hardening exponent 1/m, the same on both sides", fraction};
    const WordParameter against{"against", "a second sphere, or a rigid plane", "sphere|plane"};
    const WordParameter loading{"loading", "how the particle is pressed", "simple|die|hydrostatic"};
    const Parameter sigma_y{"sigma_y_Pa", "uniaxial yield stress", positive};
    const Parameter sigma_y2{"sigma_y2_Pa", "uniaxial yield stress of the second body", positive, 0};
    const WordParameter at{"unload_delta_bar", "delta/R at which alpha and beta are given, at most 8", ""};
    return std::vector<LawInfo>{
        {"hertz",
         "elastic spheres",
         "Hertz (1882)",
         "delta/R <= 0.01",
         "published",
         {R, R2, E, nu, E2, nu2},
         {against}},
        {"similarity",
         "rigid-plastic spheres with power-law hardening, small strain",
         "Biwa & Storakers; Shahin (2.4)-(2.8), (B.24)",
         "delta/R <= 0.03, 0 <= 1/m <= 1",
         "published|curvature-corrected",
         {R, R2, E, nu, E2, nu2, kappa, kappa2, inverse_m},
         {against}},
        {"edmans-sinka",
         "compressible plastic particles, fitted curve",
         "Edmans & Sinka (6), (9)-(14)",
         "delta/R <= 0.5",
         "published|published-corrected|c1|hertz-like",
         {R,
          R2,
          {"sigma_ref_Pa", "stress that makes the force dimensionless: the material's yield stress",
           positive},
          E,
          nu,
          E2,
          nu2,
          {"k", "(6), initial slope of F/(pi R^2 sigma_ref) over delta/R", positive},
          {"delta_t", "(6), end of the first branch in delta/R", {0, 1, true, false}},
          {"a", "(6), rate of the exponential branch", {0, 50, true, false}},
          {"corner", "c1: half-width of the rounded corner over delta_t", {0, 1, true, true}, 0.5}},
         {against,
          at,
          {"alpha", "unloading exponents (9)", ""},
          {"beta", "secant stiffness ratios (11)", ""}}},
        {"wang",
         "granular geomaterials, Drucker-Prager",
         "Wang et al. (2018), (8)-(18)",
         "E 10-30 GPa, nu 0.1-0.3, phi 20-40 deg, sigma_c 5-50 MPa, a/R < 0.02; the contact radius is ours, "
         "provisional",
         "generic|fitted|published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"phi_deg", "friction angle", {0, 60, false, true}},
          {"sigma_c_Pa", "uniaxial compressive strength", positive},
          {"a", "(16), both overlaps whole; 0: from Table 2", non_negative, 0},
          {"b", "(16); 0: from Table 2", non_negative, 0},
          {"m", "(17), fitted only", non_negative, 0},
          {"n", "(17), fitted only", non_negative, 0}},
         {against}},
        {"agarwal",
         "elastic, perfectly plastic spheres, large deformation",
         "Agarwal, Shahin & Gonzalez: Shahin's thesis, (2.12)-(2.48)",
         "lambda = E/((1 - nu^2) sigma_y) 117-5933 (formally >= 22.1); delta/R <= 0.5, in a cell a little "
         "past full",
         "hertz-radius|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against,
          loading,
          {"kind", "secondary: the sides of a particle in a die; refused, see docs/laws/agarwal.md",
           "primary|secondary"}}},
        {"shahin",
         "rigid-plastic spheres with power-law hardening, large deformation",
         "Shahin's thesis, (3.45)-(3.59)",
         "0 <= 1/m <= 1; delta/R <= 0.5, in a cell until it is full",
         "published|hardening-minimum",
         {R, R2, E, nu, E2, nu2, kappa, kappa2, inverse_m},
         {against, loading}},
        {"thornton-ning",
         "elastic spheres with a largest contact pressure; a straight line from yield on",
         "Thornton & Ning (1998), without adhesion",
         "delta/R <= 0.01 (ours; the paper states none)",
         "published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"p_y_Pa", "largest contact pressure, 1.6 to 2.8 yield stresses", positive},
          {"p_y2_Pa", "largest contact pressure of the second body", positive, 0}},
         {against}},
        {"kogut-etsion",
         "elastic, perfectly plastic spheres, power laws in units of first yield",
         "Kogut & Etsion (2002); generic unloading",
         "to 110 overlaps of first yield",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"etsion-unloading",
         "kogut-etsion with the flattened sphere's unloading",
         "Etsion, Kligerman & Kadin (2005), closed form",
         "to 110 overlaps of first yield; published: not where it creates energy",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"jackson-green",
         "elastic, perfectly plastic spheres, hardness falling with the contact radius",
         "Jackson & Green (2005); generic unloading",
         "a/R <= 0.41, sigma_y (1 - nu^2)/E <= 0.01",
         "joined|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"mdr",
         "elastic, perfectly plastic spheres, pressure falling with overlap: the pair kernel",
         "Zunker & Kamrin (2024), as in LAMMPS; without bulk response, growing radius, adhesion",
         "delta/R <= 0.75; published: not where it may create energy",
         "stiffened|published",
         {R, R2, E, nu, E2, nu2, sigma_y, sigma_y2},
         {against}},
        {"luding",
         "linear springs with hysteresis, calibrated",
         "Luding (2008), without adhesion",
         "for the radius it is calibrated at, to the overlap where k_2 is reached",
         "published",
         {R,
          R2,
          {"k_1_N_per_m", "loading stiffness", positive},
          {"k_2_N_per_m", "largest unloading stiffness, at least k_1", positive},
          {"phi_f", "plasticity depth over the reduced diameter", {0, 1, true, false}}},
         {against}},
        {"eepa",
         "springs of overlap^n with hysteresis, calibrated",
         "Thakur et al. (2014), without adhesion; k_1 as in LAMMPS",
         "as calibrated",
         "published",
         {R,
          R2,
          E,
          nu,
          E2,
          nu2,
          {"lambda_p", "contact plasticity 1 - k_1/k_2", {0, 1, false, true}},
          {"n", "exponent", {1, 2}, 1.5}},
         {against}},
    };
  }();
  return all;
}

namespace detail {

inline std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  while (true) {
    const auto end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

inline double number_of(std::string_view law, std::string_view key, const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  if (text == "inf") return infinity;
  if (!(in >> value) || !(in >> std::ws).eof())
    throw BadParameter(std::string(law) + ": " + std::string(key) + " = '" + text + "' is not a number");
  return value;
}

/// The texts of one law, read by its table.
class Reader {
 public:
  Reader(const LawInfo& info, const ParameterTexts& texts) : info_(info), texts_(texts) {
    std::vector<std::string> known;
    for (const auto& p : info.parameters) known.emplace_back(p.key);
    for (const auto& w : info.words) known.emplace_back(w.key);
    for (const auto& [key, text] : texts) {
      bool found = false;
      for (const auto& k : known) found = found || k == key;
      if (!found)
        throw BadParameter(std::string(info.name) + ": there is no parameter '" + key +
                           "'; known are: " + listed(known));
    }
  }
  [[nodiscard]] bool given(std::string_view key) const { return texts_.find(key) != texts_.end(); }

  [[nodiscard]] double operator()(std::string_view key) const {
    for (const auto& p : info_.parameters) {
      if (p.key != key) continue;
      const auto text = texts_.find(key);
      if (text == texts_.end()) {
        if (std::isnan(p.fallback))
          throw BadParameter(std::string(info_.name) + ": " + std::string(key) + " is missing (" +
                             std::string(p.meaning) + ")");
        return p.fallback;
      }
      const double value = number_of(info_.name, key, text->second);
      require(info_.name, key, value, p.range);
      return value;
    }
    throw BadParameter(std::string(info_.name) + ": no parameter " + std::string(key));
  }
  /// A value of the second body, which is that of the first where it is not given.
  [[nodiscard]] double second(std::string_view key, double first) const {
    return given(key) ? (*this)(key) : first;
  }

  [[nodiscard]] std::string word(std::string_view key) const {
    for (const auto& w : info_.words) {
      if (w.key != key) continue;
      const auto allowed = split(w.values, '|');
      const auto text = texts_.find(key);
      if (text == texts_.end()) return allowed.front();
      for (const auto& a : allowed)
        if (a == text->second) return a;
      throw BadParameter(std::string(info_.name) + ": " + std::string(key) + " = '" + text->second +
                         "' is none of: " + listed(allowed));
    }
    return {};
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const {
    std::vector<double> values;
    if (const auto text = texts_.find(key); text != texts_.end())
      for (const auto& part : split(text->second, ',')) values.push_back(number_of(info_.name, key, part));
    return values;
  }

 private:
  const LawInfo& info_;
  const ParameterTexts& texts_;
};

inline LoadingCase loading_of(const Reader& read) {
  const std::string word = read.word("loading");
  return word == "die"           ? LoadingCase::die
         : word == "hydrostatic" ? LoadingCase::hydrostatic
                                 : LoadingCase::simple;
}

inline void read_unloading(const Reader& read, EdmansSinkaMaterial& m) {
  const auto x = read.numbers("unload_delta_bar"), alpha = read.numbers("alpha"), beta = read.numbers("beta");
  if (x.size() != alpha.size() || x.size() != beta.size())
    throw BadParameter("edmans-sinka: unload_delta_bar, alpha and beta must have as many values each");
  require("edmans-sinka", "number of unload_delta_bar", static_cast<double>(x.size()),
          {0, EdmansSinkaMaterial::most_unloadings});
  m.unloadings = static_cast<int>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    m.unload_delta_bar[i] = x[i];
    m.alpha[i] = alpha[i];
    m.beta[i] = beta[i];
  }
}

} // namespace detail

inline const LawInfo& find_law(std::string_view name) {
  std::vector<std::string> known;
  for (const LawInfo& law : laws()) {
    if (law.name == name) return law;
    known.emplace_back(law.name);
  }
  throw BadParameter("there is no law '" + std::string(name) + "'; known are: " + detail::listed(known));
}

/// A prepared law from texts. An empty `variant` is the law's default. Throws BadParameter.
inline AnyLaw make_law(std::string_view name, std::string_view variant, const ParameterTexts& texts) {
  const LawInfo& info = find_law(name);
  const auto variants = detail::split(info.variants, '|');
  std::string chosen(variant.empty() ? variants.front() : std::string(variant));
  bool known = false;
  for (const auto& v : variants) known = known || v == chosen;
  if (!known)
    throw BadParameter(std::string(name) + ": there is no variant '" + chosen +
                       "'; known are: " + detail::listed(variants));

  const detail::Reader read(info, texts);
  const double R = read("radius_m"), R2 = read.second("radius2_m", R);
  const bool on_plane = read.word("against") == "plane";
  if (on_plane)
    for (const char* key : {"radius2_m", "E2_Pa", "nu2", "kappa2_Pa", "sigma_y2_Pa", "p_y2_Pa"})
      if (read.given(key))
        throw BadParameter(std::string(name) + ": " + key + " has no meaning against a rigid plane");
  if (name == "luding") { // no material
    const LudingMaterial springs{read("k_1_N_per_m"), read("k_2_N_per_m"), read("phi_f")};
    if (on_plane) return prepare_on_rigid_plane(springs, R);
    return prepare(springs, R, R2);
  }
  const double E = read("E_Pa"), nu = read("nu"), E2 = read.second("E2_Pa", E), nu2 = read.second("nu2", nu);
  const auto prepared = [&](const auto& one, const auto& two) -> AnyLaw {
    if (on_plane) return prepare_on_rigid_plane(one, R);
    return prepare(one, R, two, R2);
  };

  if (name == "hertz") return prepare_hertz(sphere(R, E, nu), on_plane ? rigid_plane() : sphere(R2, E2, nu2));
  if (name == "similarity") {
    SimilarityMaterial one{E, nu, read("kappa_Pa"), read("inverse_m")};
    if (chosen == "curvature-corrected") one.variant = SimilarityVariant::curvature_corrected;
    SimilarityMaterial two = one;
    two.E = E2, two.nu = nu2, two.kappa = read.second("kappa2_Pa", one.kappa);
    return prepared(one, two);
  }
  if (name == "edmans-sinka") {
    EdmansSinkaMaterial one;
    one.sigma_ref = read("sigma_ref_Pa"), one.E = E, one.nu = nu;
    one.k = read("k"), one.delta_t = read("delta_t"), one.a = read("a"), one.corner = read("corner");
    one.variant = chosen == "c1"                    ? EdmansSinkaVariant::c1
                  : chosen == "hertz-like"          ? EdmansSinkaVariant::hertz_like
                  : chosen == "published-corrected" ? EdmansSinkaVariant::published_corrected
                                                    : EdmansSinkaVariant::published;
    if (chosen == "c1" && !read.given("corner")) one.corner = smaller(0.5, 0.8 / (one.a * one.delta_t));
    detail::read_unloading(read, one);
    EdmansSinkaMaterial two = one;
    two.E = E2, two.nu = nu2;
    return prepared(one, two);
  }
  if (name == "wang") {
    WangMaterial one{E, nu, read("phi_deg"), read("sigma_c_Pa")};
    one.variant = chosen == "fitted"      ? WangVariant::fitted
                  : chosen == "published" ? WangVariant::published
                                          : WangVariant::generic;
    one.a = read("a"), one.b = read("b"), one.m = read("m"), one.n = read("n");
    WangMaterial two = one;
    two.E = E2, two.nu = nu2;
    return prepared(one, two);
  }
  if (name == "agarwal") {
    if (read.word("kind") == "secondary")
      throw BadParameter(
          "agarwal: kind = secondary is no law of its own overlap: the thesis gives the sides of a particle "
          "in a "
          "die over the overlap of the primary contacts, force up to x = gamma/2R = 0.1 and pressure from "
          "about "
          "0.41 on, nothing between and no unloading; allowed here is primary (C++: secondary_contact() in "
          "agarwal_secondary.hpp)");
    AgarwalMaterial one{E, nu, read("sigma_y_Pa"), detail::loading_of(read)};
    one.variant = chosen == "published" ? AgarwalVariant::published : AgarwalVariant::hertz_radius;
    AgarwalMaterial two = one;
    two.E = E2, two.nu = nu2, two.sigma_y = read.second("sigma_y2_Pa", one.sigma_y);
    return prepared(one, two);
  }
  const auto joint = chosen == "published" ? JointVariant::published : JointVariant::joined;
  const auto plastic = [&]<class Material>(Material one) -> AnyLaw { // E, nu and sigma_y, or p_y
    Material two = one;
    two.E = E2, two.nu = nu2;
    if constexpr (requires { one.p_y; }) two.p_y = read.second("p_y2_Pa", one.p_y);
    else two.sigma_y = read.second("sigma_y2_Pa", one.sigma_y);
    return prepared(one, two);
  };
  if (name == "thornton-ning") return plastic(ThorntonNingMaterial{E, nu, read("p_y_Pa")});
  if (name == "kogut-etsion") return plastic(KogutEtsionMaterial{E, nu, read("sigma_y_Pa"), joint});
  if (name == "etsion-unloading") return plastic(EtsionUnloadingMaterial{{E, nu, read("sigma_y_Pa"), joint}});
  if (name == "jackson-green") return plastic(JacksonGreenMaterial{E, nu, read("sigma_y_Pa"), joint});
  if (name == "mdr")
    return plastic(MdrMaterial{E, nu, read("sigma_y_Pa"),
                               chosen == "published" ? MdrVariant::published : MdrVariant::stiffened});
  if (name == "eepa") {
    const EepaMaterial one{E, nu, read("lambda_p"), read("n")};
    EepaMaterial two = one;
    two.E = E2, two.nu = nu2;
    return prepared(one, two);
  }
  ShahinMaterial one{E, nu, read("kappa_Pa"), read("inverse_m"), detail::loading_of(read)};
  one.variant = chosen == "published" ? ShahinVariant::published : ShahinVariant::hardening_minimum;
  ShahinMaterial two = one;
  two.E = E2, two.nu = nu2, two.kappa = read.second("kappa2_Pa", one.kappa);
  return prepared(one, two);
}

/// evaluate() for a law known at run time.
inline Response evaluate(const AnyLaw& law, const State& state, double overlap) {
  return std::visit([&](const auto& l) { return evaluate(l, state, overlap); }, law);
}

/// "key=value key=value ..." as in the C interface.
inline ParameterTexts parameter_texts(std::string_view text) {
  ParameterTexts texts;
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw BadParameter("'" + word + "' is not of the form key=value");
    if (!texts.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
      throw BadParameter("'" + word.substr(0, equals) + "' is given twice");
  }
  return texts;
}

} // namespace platen::law
