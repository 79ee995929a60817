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
#include "platen/law/parameter_reader.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/thornton_ning.hpp"
#include "platen/law/wang.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace platen::law {

using AnyLaw = std::variant<Hertz<double>, Similarity<double>, EdmansSinka<double>, Wang<double>, Agarwal,
                            Shahin, ThorntonNing<double>, KogutEtsion<double>, EtsionUnloading<double>,
                            JacksonGreen, Mdr, Luding<double>, Eepa<double>>;

namespace detail {

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
          "in a die over the overlap of the primary contacts, force up to x = gamma/2R = 0.1 and pressure "
          "from about 0.41 on, nothing between and no unloading; allowed here is primary (C++: "
          "secondary_contact() in "
          "agarwal_secondary.hpp)");
    AgarwalMaterial one{E, nu, read("sigma_y_Pa"), detail::loading_of(read)};
    one.variant = chosen == "published" ? AgarwalVariant::published : AgarwalVariant::hertz_radius;
    for (const auto& c : agarwal_coefficients) one.coefficients.*c.member = read(c.key);
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
  for (const auto& c : shahin_coefficients) one.coefficients.*c.member = read(c.key);
  ShahinMaterial two = one;
  two.E = E2, two.nu = nu2, two.kappa = read.second("kappa2_Pa", one.kappa);
  return prepared(one, two);
}

/// evaluate() for a law known at run time.
inline Response evaluate(const AnyLaw& law, const State& state, double overlap) {
  return std::visit([&](const auto& l) { return evaluate(l, state, overlap); }, law);
}

} // namespace platen::law
