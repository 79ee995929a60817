#pragma once
// All laws, and the code of what catalogue.hpp declares. A law is a header and a line in LawTypes; its
// material type says everything else:
//
//   static LawInfo info()                    name, source, validity, variants, parameters
//   static Material read(const Reader&)      from texts
//   prepare(m1, R1, m2, R2), prepare_on_rigid_plane(m, R)   its formulas (ContactLaw), or BadParameter
//
// A law of one's own outside this folder: define PLATEN_OWN_LAWS as the header that has it, with
// `using OwnLaws = std::tuple<MyMaterial>` in platen::law.

#include "platen/law/agarwal.hpp"
#include "platen/law/catalogue.hpp"
#include "platen/law/edmans_sinka.hpp"
#include "platen/law/eepa.hpp"
#include "platen/law/etsion_unloading.hpp"
#include "platen/law/hertz.hpp"
#include "platen/law/jackson_green.hpp"
#include "platen/law/joined.hpp"
#include "platen/law/kogut_etsion.hpp"
#include "platen/law/luding.hpp"
#include "platen/law/mdr.hpp"
#include "platen/law/pressed.hpp"
#include "platen/law/shahin.hpp"
#include "platen/law/similarity.hpp"
#include "platen/law/tabulate.hpp"
#include "platen/law/thornton_ning.hpp"
#include "platen/law/wang.hpp"

#include <algorithm>
#include <tuple>

#ifdef PLATEN_OWN_LAWS
#include PLATEN_OWN_LAWS
#endif

namespace platen::law {

#ifndef PLATEN_OWN_LAWS
using OwnLaws = std::tuple<>;
#endif

using LawTypes = decltype(std::tuple_cat(
    std::tuple<HertzMaterial, SimilarityMaterial, EdmansSinkaMaterial, WangMaterial, AgarwalMaterial,
               ShahinMaterial, ThorntonNingMaterial, KogutEtsionMaterial, EtsionUnloadingMaterial,
               JacksonGreenMaterial, MdrMaterial, LudingMaterial, EepaMaterial, PressedMaterial>{},
    OwnLaws{}));

PLATEN_CATALOGUE const std::vector<LawType>& law_types() {
  static const std::vector<LawType> all = [] {
    std::vector<LawType> list;
    const auto add = [&]<class Material>(std::type_identity<Material>) {
      list.push_back(
          {complete(Material::info()),
           [](const Reader& one, double R1, const Reader& two, double R2, const TableAccuracy& accuracy) {
             return tabulate(prepare(Material::read(one), R1, Material::read(two), R2), accuracy);
           },
           [](const Reader& one, double R) {
             return tabulate(prepare_on_rigid_plane(Material::read(one), R));
           }});
    };
    [&]<class... Material>(std::type_identity<std::tuple<Material...>>) {
      (add(std::type_identity<Material>{}), ...);
    }(std::type_identity<LawTypes>{});
    return list;
  }();
  return all;
}

PLATEN_CATALOGUE const std::vector<LawInfo>& laws() {
  static const std::vector<LawInfo> all = [] {
    std::vector<LawInfo> list;
    for (const auto& type : law_types()) list.push_back(type.info);
    return list;
  }();
  return all;
}

PLATEN_CATALOGUE const LawType& find_type(std::string_view name) {
  std::vector<std::string> known;
  for (const LawType& type : law_types()) {
    if (type.info.name == name) return type;
    known.push_back(type.info.name);
  }
  throw BadParameter("there is no law '" + std::string(name) + "'; known are: " + detail::listed(known));
}
PLATEN_CATALOGUE const LawInfo& find_law(std::string_view name) { return find_type(name).info; }

PLATEN_CATALOGUE Reader LawChoice::reader() const {
  const LawInfo& info = find_law(name);
  const auto variants = detail::split(info.variants, '|');
  if (variant.empty()) return {info, parameters, variants.front()};
  if (std::find(variants.begin(), variants.end(), variant) == variants.end())
    throw BadParameter(name + ": there is no variant '" + variant +
                       "'; known are: " + detail::listed(variants));
  return {info, parameters, variant};
}

PLATEN_CATALOGUE Law make_law(const LawChoice& one, double R1, const LawChoice& two, double R2,
                              const TableAccuracy& accuracy) {
  const Reader a = one.reader(), b = two.reader();
  if (a.loading() != b.loading()) // a particle in a die beside one that is pressed alone
    throw BadParameter(one.name + " and " + two.name +
                       ": both sides must have the same loading (simple, die or hydrostatic)");
  if (one.name == two.name && a.variant == b.variant) try {
      return find_type(one.name).of_pair(a, R1, b, R2, accuracy);
    } catch (const BadParameter&) { // of one of them, or only of the two together
      if (one.parameters == two.parameters) throw;
    }
  const Law like1 = find_type(one.name).of_pair(a, 1, a, 1, {}),
            like2 = find_type(two.name).of_pair(b, 1, b, 1, {});
  for (const auto& [law, name] : {std::pair{&like1, &one.name}, std::pair{&like2, &two.name}})
    if (law->force_power != 2 || law->table->shape != Shape::power)
      throw BadParameter(
          *name + ": its " + (law->force_power != 2 ? "springs have" : "unloading has") +
          " a form of its own, and cannot be joined with another law; give both sides the same");
  const auto side = [](const Law& like) {
    const double end = like.table->valid[0][1];
    return JoinedSide{like.table.get(), larger(0.5, smaller(end, 1.0))};
  };
  const auto body = [](const Law& like, double R) {
    Body own = like.pair.body[0];
    own.curvature = 1 / R;
    return own;
  };
  return tabulate(join(make_pair(body(like1, R1), body(like2, R2)), side(like1), side(like2)), accuracy);
}

PLATEN_CATALOGUE Law make_law_on_plane(const LawChoice& one, double R) {
  return find_type(one.name).on_plane(one.reader(), R);
}

PLATEN_CATALOGUE Law make_law(std::string_view name, std::string_view variant, const ParameterTexts& texts) {
  const LawInfo& info = find_law(name);
  LawChoice one{std::string(name), std::string(variant), texts};
  const Reader all = one.reader();
  const double R = all("radius_m"), R2 = all.given("radius2_m") ? all("radius2_m") : R;
  const bool on_plane = all.word("against") == "plane";
  if (on_plane && all.given("radius2_m"))
    throw BadParameter(std::string(name) + ": radius2_m has no meaning against a rigid plane");
  LawChoice two = one;
  for (LawChoice* body : {&one, &two})
    for (const char* key : {"radius_m", "radius2_m", "against"}) body->parameters.erase(key);
  for (const auto& p : info.parameters) {
    if (p.of != Of::body) continue;
    const std::string key = second_key(p.key);
    if (!all.given(key)) continue;
    if (on_plane)
      throw BadParameter(std::string(name) + ": " + key + " has no meaning against a rigid plane");
    two.parameters[p.key] = texts.at(key);
    one.parameters.erase(key);
    two.parameters.erase(key);
    (void)all(key);
  }
  if (!on_plane) return make_law(one, R, two, R2);
  return make_law_on_plane(one, R);
}

} // namespace platen::law
