#pragma once
// Laws and curves beside a reference curve: what `platen compare` says, in the command and in Python.

#include "fit/compare.hpp"
#include "fit/law_card.hpp"
#include "material/models.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace platen::fit {

/// A law, with parameters of its own over those of its card.
struct LawItem {
  LawCard card;
  law::ParameterTexts parameters = {};
  std::string label;
};
struct CurveItem {
  press::Curve curve;
  std::string label;
};

struct Question {
  CurveItem reference;
  std::vector<std::variant<LawItem, CurveItem>> items;
  /// Gives the laws parameters that neither their cards nor `parameters` say; more than the curve itself
  /// does.
  std::optional<material::Material> material;
  /// For every law that has the parameter. InvalidInput where none has.
  law::ParameterTexts parameters = {};
  std::vector<double> ends = {}; ///< of ranges of delta/R, ascending; the end of the reference closes them
};

struct RangeOfOverlap {
  double above = 0, to = 0;          ///< delta/R
  std::vector<Deviation> deviations; ///< one for each trace
};

struct Comparison {
  Reference reference;
  std::vector<Trace> traces;
  std::vector<RangeOfOverlap> ranges;
  std::vector<std::string> warnings; ///< which laws are asked outside their validity
};

Comparison compare(const Question&);

/// One Markdown table a range, nearest first. `material`: of the reference, may be empty.
std::string words_of(const Comparison&, const std::string& material);

} // namespace platen::fit
