#pragma once
// Every law by name, at run time: what a command line, a law card, the C interface or a DEM code needs. Which
// laws these are stands in every_law.hpp, with the code of what is declared here. A program of many sources
// compiles that once: where PLATEN_LAWS_APART is defined these are declarations alone, and one source
// includes every_law.hpp as well (src/laws).

#include "platen/law/law_info.hpp"
#include "platen/law/parameter_reader.hpp"
#include "platen/law/table.hpp"

#include <string>
#include <string_view>
#include <vector>

#ifdef PLATEN_LAWS_APART
#define PLATEN_CATALOGUE
#else
#define PLATEN_CATALOGUE inline
#endif

namespace platen::law {

/// A law and how it is made.
struct LawType {
  LawInfo info;
  Law (*of_pair)(const Reader& one, double R1, const Reader& two, double R2, const TableAccuracy&);
  Law (*on_plane)(const Reader& one, double R);
};

PLATEN_CATALOGUE const std::vector<LawType>& law_types();
PLATEN_CATALOGUE const std::vector<LawInfo>& laws();

/// Throws BadParameter.
PLATEN_CATALOGUE const LawType& find_type(std::string_view name);
PLATEN_CATALOGUE const LawInfo& find_law(std::string_view name);

/// A law with its variant; an empty one is the law's default.
struct LawChoice {
  std::string name, variant;
  ParameterTexts parameters; ///< of one body, without radius

  /// Throws BadParameter.
  [[nodiscard]] Reader reader() const;
};

/// Two bodies, each with its own parameters. Laws that differ, or that do not take the two, are joined.
PLATEN_CATALOGUE Law make_law(const LawChoice& one, double R1, const LawChoice& two, double R2,
                              const TableAccuracy& = {});
PLATEN_CATALOGUE Law make_law_on_plane(const LawChoice& one, double R);

/// From one set of texts, where the second body's parameters have keys of their own (second_key); what is not
/// given of it is like the first. Throws BadParameter.
PLATEN_CATALOGUE Law make_law(std::string_view name, std::string_view variant, const ParameterTexts& texts);

/// What the table of a law is made from: the formulas of one material, for two equal spheres or on a rigid
/// plane.
template <class Material> auto formulas(const LawChoice& one, double R) {
  const Material m = Material::read(one.reader());
  return prepare(m, R, m, R);
}
template <class Material> auto formulas_on_plane(const LawChoice& one, double R) {
  return prepare_on_rigid_plane(Material::read(one.reader()), R);
}

} // namespace platen::law

#ifndef PLATEN_LAWS_APART
#include "platen/law/every_law.hpp"
#endif
