#include "calibrate/press_curves.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "fit/unloading.hpp"
#include "platen/law/knot_curve.hpp"
#include "press/curve_csv.hpp"
#include "study/work.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace platen::calibrate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int knots = 40, branches = 5;
constexpr double first_knot = 0.00125; // as the pools have it
constexpr double step = 0.25;          // of a logarithm, to see a slope
constexpr double reach = 2;            // in the same: so far the slopes may be believed
/// A press on a quarter of the elements is as far again from the limit of fine meshes as this.
constexpr double mesh_share = 1.0 / 3;

/// What of a material makes a difference to its curve without dimension: ratios of its stresses, and the
/// rest.
VectorXd dimensionless(const material::Material& m) {
  const double reference = material::reference_stress(m.model);
  std::vector<double> y;
  for (const auto& p : material::parameters(m.model))
    if (p.key.find("_Pa") == p.key.npos) y.push_back(p.value);
    else if (p.value > 0) y.push_back(std::log(p.value / reference));
  return Eigen::Map<const VectorXd>(y.data(), static_cast<Eigen::Index>(y.size()));
}

/// One after the other, as the slopes are of all at once.
VectorXd stacked(const LogCurve& c) {
  std::vector<double> all;
  for (const auto* part : {&c.F, &c.a, &c.alpha, &c.beta}) all.insert(all.end(), part->begin(), part->end());
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}
LogCurve taken_apart(const LogCurve& like, const VectorXd& all) {
  LogCurve c = like;
  Eigen::Index at = 0;
  for (auto* part : {&c.F, &c.a, &c.alpha, &c.beta})
    for (double& v : *part) v = all[at++];
  return c;
}

LogCurve log_curve(const press::Curve& curve, double delta_bar_max) {
  std::vector<double> x, F, a;
  for (const auto& p : curve.points)
    if (p.branch == press::Branch::loading && p.F_bar > 0 && p.contact_radius_m > 0 &&
        (x.empty() || std::log(p.delta_bar) > x.back()))
      x.push_back(std::log(p.delta_bar)), F.push_back(std::log(p.F_bar)),
          a.push_back(std::log(p.contact_radius_m / curve.radius_m));
  const law::MonotoneCurve F_of(x, F), a_of(x, a);
  LogCurve c;
  for (int i = 0; i < knots; ++i) {
    const double at = std::log(first_knot) + std::log(delta_bar_max / first_knot) * i / (knots - 1);
    c.delta_bar.push_back(i + 1 == knots ? delta_bar_max : std::exp(at));
    c.F.push_back(F_of.value(at)), c.a.push_back(a_of.value(at));
  }
  for (const auto& fit : fit::fit_unloading(curve).fits) {
    c.unload_delta_bar.push_back(fit.delta_bar_max);
    c.alpha.push_back(std::log(fit.alpha)), c.beta.push_back(std::log(fit.beta));
  }
  return c;
}

} // namespace

struct PressCurves::Local {
  FreeMaterial sought;
  PressSettings settings;
  int presses = 0;
  press::Curve last = {};
  LogCurve shape = {};                   ///< its overlaps
  VectorXd y0 = {}, centre = {}, z = {}; ///< origin of the coordinates; the last curve, and where it is
  MatrixXd to_z = {}, slopes = {};
  VectorXd mesh = {}; ///< what the logarithms may be off by it

  material::Material material(const std::vector<double>& values) const {
    law::ParameterTexts texts;
    for (std::size_t k = 0; k < values.size(); ++k)
      texts[sought.free()[k].key] = core::number_text(values[k]);
    return sought.with(texts);
  }

  VectorXd coordinates(const material::Material& m) const { return to_z * (dimensionless(m) - y0); }

  struct Wanted {
    std::vector<double> values;
    int elements;
  };

  press::Case press_case(const Wanted& wanted) const {
    press::Simple simple;
    simple.delta_bar_max = settings.delta_bar_max;
    simple.elements = wanted.elements;
    for (int i = 1; i <= branches; ++i)
      simple.unload_from.push_back(i == branches ? settings.delta_bar_max
                                                 : settings.delta_bar_max * i / branches);
    return {material(wanted.values), 1e-3, simple};
  }

  std::string words(const Wanted& wanted) const {
    std::string words;
    for (std::size_t k = 0; k < wanted.values.size(); ++k)
      words += fmt::format("{}{} = {:.4g}", k ? ", " : "", sought.free()[k].key, wanted.values[k]);
    return words;
  }

  /// All together through the store, which presses what it does not have.
  std::vector<LogCurve> pressed(const std::vector<Wanted>& all) {
    study::Study study;
    for (const auto& wanted : all) {
      study.runs.push_back({{}, press_case(wanted)});
      const bool there = settings.store.state(settings.store.key(study.runs.back().press_case)) !=
                         study::Store::State::missing;
      settings.say(fmt::format("press {}: {} ({} elements){}", ++presses, words(wanted), wanted.elements,
                               there ? ", from the store" : ""));
    }
    for (const auto& what : study::forget_damaged(study, settings.store)) settings.say("note: " + what);
    study::work(study, settings.store, std::min(settings.workers, static_cast<int>(all.size())),
                [](const study::Tally&) {});
    std::vector<LogCurve> curves;
    for (std::size_t i = 0; i < all.size(); ++i)
      curves.push_back(read(settings.store.key(study.runs[i].press_case), words(all[i])));
    return curves;
  }

  LogCurve read(const std::string& key, const std::string& of) {
    if (const auto why = settings.store.failure(key); !why.empty())
      throw core::ConvergenceError(fmt::format("the press of {} stopped: {}", of, why), 0, 0, 0);
    last = press::read_curve(settings.store.run(key) / "curve.csv");
    auto curve = log_curve(last, settings.delta_bar_max);
    if (curve.alpha.size() != branches)
      throw core::ConvergenceError(fmt::format("the press of {} unloads too steeply to be fitted", of), 0, 0,
                                   0);
    return curve;
  }

  /// As `values` moved by h along a direction of what is searched.
  std::vector<double> moved(const std::vector<double>& values, const VectorXd& direction, double h) const {
    auto result = values;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double by = h * direction[static_cast<Eigen::Index>(k)];
      result[k] = sought.free()[k].logarithmic ? values[k] * std::exp(by) : values[k] + by;
    }
    return result;
  }

  void begin(const std::vector<double>& values) {
    y0 = dimensionless(material(values));
    const auto n = static_cast<Eigen::Index>(values.size());
    MatrixXd D(y0.size(), n);
    for (Eigen::Index k = 0; k < n; ++k) {
      constexpr double small = 1e-4;
      D.col(k) = (dimensionless(material(moved(values, VectorXd::Unit(n, k), small))) - y0) / small;
    }
    const Eigen::JacobiSVD<MatrixXd> svd(D, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const auto& s = svd.singularValues();
    Eigen::Index rank = 0;
    while (rank < s.size() && s[rank] > 1e-6 * std::max(1.0, s[0])) ++rank;
    to_z = s.head(rank).cwiseInverse().asDiagonal() * svd.matrixU().leftCols(rank).transpose();
    z = VectorXd::Zero(rank);
    std::vector<Wanted> wanted = {{values, settings.coarse_elements}};
    for (Eigen::Index r = 0; r < rank; ++r)
      wanted.push_back({moved(values, svd.matrixV().col(r), step), settings.coarse_elements});
    wanted.push_back({values, settings.elements});
    const auto curves = pressed(wanted);
    const VectorXd coarse = stacked(curves.front());
    slopes.resize(coarse.size(), rank);
    for (Eigen::Index r = 0; r < rank; ++r)
      slopes.col(r) = (stacked(curves[static_cast<std::size_t>(r) + 1]) - coarse) / step;
    shape = curves.back();
    centre = stacked(shape);
    mesh = mesh_share * (centre - coarse);
  }
};

PressCurves::PressCurves(const FreeMaterial& sought, const std::vector<double>& values,
                         PressSettings settings)
    : local_(std::make_shared<Local>(Local{sought, std::move(settings)})) {
  local_->begin(values);
}
PressCurves::~PressCurves() = default;

Curves PressCurves::curves() const {
  const auto at = [local = local_](const material::Material& m, double of_mesh) {
    const VectorXd by = local->coordinates(m) - local->z;
    if (by.size() > 0 && by.cwiseAbs().maxCoeff() > reach)
      throw core::InvalidInput("too far from what was pressed");
    return curve_of(taken_apart(local->shape, local->centre + local->slopes * by + of_mesh * local->mesh), m,
                    material::reference_stress(m.model));
  };
  return {[at](const material::Material& m) { return at(m, 0); },
          [at](const material::Material& m) { return std::vector{at(m, 1)}; }};
}

double PressCurves::press(const std::vector<double>& values) {
  Local& l = *local_;
  const VectorXd z = l.coordinates(l.material(values)), by = z - l.z;
  const VectorXd expected = l.centre + l.slopes * by,
                 found = stacked(l.pressed({{values, l.settings.elements}}).front());
  const VectorXd off = found - expected;
  if (by.squaredNorm() > 1e-6) l.slopes += off * by.transpose() / by.squaredNorm();
  l.centre = found, l.z = z;
  const auto n = static_cast<Eigen::Index>(knots);
  return std::sqrt(off.head(n).squaredNorm() / static_cast<double>(n));
}

const press::Curve& PressCurves::last() const { return local_->last; }
int PressCurves::presses() const { return local_->presses; }

} // namespace platen::calibrate
