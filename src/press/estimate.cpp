#include "press/estimate.hpp"

#include "press/confined.hpp"

#include <algorithm>
#include <cmath>

namespace platen::press {
namespace {

struct Coarsen {
  void operator()(ByOverlap& e) const {
    e.elements /= 2;
    e.unload_from.clear();
    e.fields_at.clear();
  }
  void operator()(Triaxial& e) const {
    e.elements /= 2;
    e.fields_at.clear();
  }
  void operator()(Local& e) const {
    e.edges = std::max(8, e.edges / 2);
    for (auto* list : {&e.unload_from, &e.unload_from_N, &e.fields_at, &e.fields_at_N}) list->clear();
  }
};

/// Of a row between two of a loading curve, by overlap.
double between(const std::vector<const CurvePoint*>& rows, double delta_m, double CurvePoint::*value) {
  const auto above = std::lower_bound(rows.begin(), rows.end(), delta_m,
                                      [](const CurvePoint* p, double x) { return p->delta_m < x; });
  if (above == rows.begin() || above == rows.end()) return std::nan("");
  const CurvePoint &a = **(above - 1), &b = **above;
  return a.*value + (delta_m - a.delta_m) / (b.delta_m - a.delta_m) * (b.*value - a.*value);
}

std::vector<const CurvePoint*> loading(const Result& result) {
  std::vector<const CurvePoint*> rows;
  for (const auto& point : result.curve.points)
    if (point.branch == Branch::loading && (rows.empty() || point.delta_m > rows.back()->delta_m))
      rows.push_back(&point);
  return rows;
}

} // namespace

Case coarser(const Case& c) {
  Case coarse = c;
  std::visit(Coarsen{}, coarse.experiment);
  return coarse;
}

std::optional<ErrorEstimate> estimate_error(const Case& c, const Result& fine, const Progress& progress) {
  const Result coarse = press(coarser(c), progress);
  if (coarse.failure || coarse.interrupted || fine.failure) return {};
  // (h_coarse/h_fine)^2
  const double elements = double(fine.statistics.elements) / coarse.statistics.elements;
  const double squares = is_confined(c.experiment) ? std::pow(elements, 2.0 / 3) : elements;
  ErrorEstimate e{0, 0, fine.statistics.elements, coarse.statistics.elements};
  const auto rows = loading(fine), others = loading(coarse);
  if (rows.empty()) return {};
  for (const CurvePoint* p : rows) {
    if (p->delta_m < 0.05 * rows.back()->delta_m) continue;
    const auto difference = [&](double CurvePoint::*value) {
      return std::abs(between(others, p->delta_m, value) / (p->*value) - 1) / (squares - 1);
    };
    e.force = std::fmax(e.force, difference(&CurvePoint::force_N)); // leaves out NaN: beyond the other's rows
    e.radius = std::fmax(e.radius, difference(&CurvePoint::contact_radius_m));
  }
  return e;
}

} // namespace platen::press
