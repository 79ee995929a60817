#pragma once
// A row of the page of the papers: a figure or table, what its paper says, what ours is, and a verdict that
// is computed from both.

#include "reproduce/chart.hpp"

#include <string>
#include <vector>

namespace platen::reproduce {

/// What |ours - theirs| is measured by.
enum class Measure {
  relative, ///< over |theirs|
  absolute, ///< in the unit of the number
};

/// A number of the paper beside ours.
struct Comparison {
  std::string what; ///< with unit
  double theirs = 0, ours = 0;
  double tolerance = 0; ///< of the difference, up to which it counts as reproduced
  Measure measure = Measure::relative;
  double error = 0; ///< of ours, relative: what another engine may change without being said
};

double difference(const Comparison&);
/// False where a number is not finite.
bool agrees(const Comparison&);

/// Two curves over the same abscissae, as the comparison at the one where they differ most. InvalidInput
/// where they differ in length or have no point.
Comparison overlay(const std::string& what, const std::string& abscissa, const std::vector<double>& x,
                   const std::vector<double>& theirs, const std::vector<double>& ours, double tolerance,
                   double error);

enum class Verdict { reproduced, differs, not_comparable };
std::string_view name_of(Verdict);

/// A file that lies in the catalogue and is shown as it is.
struct Picture {
  std::string source; ///< below the catalogue
  std::string caption;
};

struct Row {
  std::string id;           ///< "es-fig-11", of the page and of its files
  std::string name;         ///< "Fig. 11"
  std::string subject;      ///< "errors of the fits"
  std::string theirs;       ///< what the paper says or draws
  std::string ours;         ///< what it is compared with
  std::string because = {}; ///< why it differs, or cannot be compared; remarks
  std::vector<Comparison> comparisons = {};
  std::vector<Chart> charts = {};
  std::vector<Picture> pictures = {};
};

/// reproduced: every comparison agrees; differs: one does not; not comparable: there is none, and a reason
/// why. InvalidInput where there is neither number nor reason.
Verdict verdict(const Row&);

/// The comparison that is furthest outside its tolerance, or nearest to it; null where there is none.
const Comparison* worst(const Row&);

/// "reproduced", "differs by 12 % in …", "cannot be compared, because …".
std::string sentence(const Row&);

/// "+4.2 %" ("+12 times" from ten times on), or the difference in the unit of the number.
std::string difference_text(double difference, Measure);
std::string difference_text(const Comparison&);

} // namespace platen::reproduce
