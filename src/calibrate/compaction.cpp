#include "calibrate/compaction.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "material/card.hpp"
#include "material/point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace platen::calibrate {
namespace {

using core::InvalidInput;

const double root_13 = std::sqrt(13.0);

struct Point {
  double x, y;
};

/// Least squares of a straight line; of the logarithm where the trend is exponential.
Trend fitted(std::string key, std::string growth_key, bool exponential, std::vector<Point> points,
             double rho_r0) {
  Trend t{std::move(key), std::move(growth_key), exponential, 0, 0, 0, 1, 0, static_cast<int>(points.size())};
  for (auto& [x, y] : points) {
    t.low = std::min(t.low, x), t.high = std::max(t.high, x);
    if (exponential) y = std::log(y);
  }
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, yy = 0;
  for (const auto& [x, y] : points) mean_x += x / t.points, mean_y += y / t.points;
  for (const auto& [x, y] : points)
    xx += (x - mean_x) * (x - mean_x), xy += (x - mean_x) * (y - mean_y), yy += (y - mean_y) * (y - mean_y);
  t.growth = xx > 0 ? xy / xx : 0;
  const double at_start = mean_y + t.growth * (rho_r0 - mean_x);
  t.value = exponential ? std::exp(at_start) : at_start;
  t.R2 = yy > 0 && xx > 0 ? xy * xy / (xx * yy) : 1;
  return t;
}

/// Slope of y over x, and how many rows say so.
double slope(const std::vector<Point>& points) {
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0;
  const double n = static_cast<double>(points.size());
  for (const auto& [x, y] : points) mean_x += x / n, mean_y += y / n;
  for (const auto& [x, y] : points) xx += (x - mean_x) * (x - mean_x), xy += (x - mean_x) * (y - mean_y);
  return xy / xx;
}

class Reduction {
 public:
  Reduction(const std::vector<CompactionRow>& rows, const std::vector<StrengthRow>& strengths, double rho_r0)
      : rows_(rows), rho_r0_(rho_r0) {
    for (const auto& s : strengths)
      if (!(s.compressive_Pa > 0) || !(s.tensile_Pa > 0))
        throw InvalidInput(
            fmt::format("at rho_r = {:.4g} the strengths are {:.4g} and {:.4g} Pa; both must be above 0",
                        s.rho_r, s.compressive_Pa, s.tensile_Pa));
      else if (!(s.compressive_Pa > root_13 * s.tensile_Pa))
        throw InvalidInput(
            fmt::format("at rho_r = {:.4g} the compressive strength {:.4g} Pa is not above sqrt(13) times "
                        "the tensile one, "
                        "{:.4g} Pa: no line of shear failure goes through both; are the columns right?",
                        s.rho_r, s.compressive_Pa, root_13 * s.tensile_Pa));
    if (strengths.size() < 2)
      throw InvalidInput(
          "strengths at two densities are needed at least: Gamma and Lambda grow with density, and "
          "die compaction alone does not show them");
    std::vector<Point> compressive, tensile;
    for (const auto& s : strengths)
      compressive.push_back({s.rho_r, s.compressive_Pa}), tensile.push_back({s.rho_r, s.tensile_Pa});
    compressive_ = fitted("compressive", "", true, compressive, rho_r0);
    tensile_ = fitted("tensile", "", true, tensile, rho_r0);
  }

  Compaction run() {
    find_stages();
    fit_elasticity();
    fit_strengths();
    return std::move(found_);
  }

 private:
  /// Loading: density above all before. Unloading: from a peak of axial stress down, to seven tenths of it.
  void find_stages() {
    double most = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].rho_r > most) {
        loading_.push_back(i), most = rows_[i].rho_r;
        continue;
      }
      if (i == 0 || rows_[i - 1].rho_r < most) continue; // inside of an unloading
      const std::size_t peak = i - 1;
      std::vector<std::size_t> back;
      constexpr double until = 0.7;
      for (std::size_t k = peak; k < rows_.size() && rows_[k].axial_Pa > until * rows_[peak].axial_Pa; ++k) {
        if (k > peak && !(rows_[k].rho_r < rows_[k - 1].rho_r)) break;
        back.push_back(k);
      }
      if (back.size() >= 3) unloadings_.push_back(std::move(back));
    }
    if (loading_.size() < 8) throw InvalidInput("fewer than 8 rows load: density must grow from row to row");
    if (unloadings_.empty())
      throw InvalidInput(
          "no row unloads, at least three in a row to 0.7 of the stress: E and nu cannot be seen");
  }

  double p(std::size_t i) const { return (rows_[i].axial_Pa + 2 * rows_[i].radial_Pa) / 3; }
  double q(std::size_t i) const { return rows_[i].axial_Pa - rows_[i].radial_Pa; }
  double E_at(double rho) const { return E_.at(std::min(rho, 1.0), rho_r0_); }
  double nu_at(double rho) const {
    return std::clamp(nu_.at(std::min(rho, 1.0), rho_r0_), 0.0, material::Porous::nu_max);
  }
  /// Without what is elastic of the density.
  double plastic_density(std::size_t i) const {
    double rho = rows_[i].rho_r;
    for (int again = 0; again < 4; ++again)
      rho = rows_[i].rho_r * std::exp(-p(i) * 3 * (1 - 2 * nu_at(rho)) / E_at(rho));
    return rho;
  }

  void fit_elasticity() {
    std::vector<Point> E, nu;
    for (const auto& back : unloadings_) {
      std::vector<Point> stiffness, share;
      // The moduli are between Hencky strain and Kirchhoff stress, J_e sigma; J_e goes as 1/rho.
      for (const auto i : back) {
        const double J = rows_[back.front()].rho_r / rows_[i].rho_r;
        stiffness.push_back({std::log(rows_[i].rho_r), J * rows_[i].axial_Pa});
        share.push_back({J * rows_[i].axial_Pa, J * rows_[i].radial_Pa});
      }
      const double M = slope(stiffness), of_radial = slope(share), nu_here = of_radial / (1 + of_radial);
      if (!(M > 0) || !(nu_here >= 0 && nu_here < 0.5))
        throw InvalidInput(
            fmt::format("the unloading from rho_r = {:.4g} is not elastic: d sigma_a/d ln rho = {:.3g} "
                        "Pa, d sigma_r/d sigma_a = {:.3g}",
                        rows_[back.front()].rho_r, M, of_radial));
      E.push_back({rows_[back.front()].rho_r, M * (1 + nu_here) * (1 - 2 * nu_here) / (1 - nu_here)});
      nu.push_back({rows_[back.front()].rho_r, nu_here});
    }
    const auto seen = E;
    for (int again = 0; again < 4; ++again) { // densities are plastic ones once E is known
      E_ = fitted("E_Pa", "xi", true, E, rho_r0_), nu_ = fitted("nu", "xi_1", false, nu, rho_r0_);
      for (std::size_t k = 0; k < unloadings_.size(); ++k)
        E[k].x = nu[k].x = plastic_density(unloadings_[k].front()),
        E[k].y = seen[k].y * E[k].x / rows_[unloadings_[k].front()].rho_r; // J_e at the peak
    }
    if (unloadings_.size() == 1)
      found_.said.emplace_back("one unloading does not show how E and nu grow with density: xi = xi_1 = 0");
    found_.unloadings = static_cast<int>(unloadings_.size());
  }

  /// d eps_v/d eps_q of the plastic strain about the k-th row of the loading; nothing where most of the
  /// strain is elastic, as at the beginning and behind an unloading.
  std::optional<double> flow(std::size_t k) const {
    const std::size_t width = std::max<std::size_t>(1, loading_.size() / 20);
    const std::size_t from = k < width ? 0 : k - width, to = std::min(loading_.size() - 1, k + width);
    std::vector<Point> axial, radial;
    for (std::size_t j = from; j <= to; ++j) {
      const auto& row = rows_[loading_[j]];
      const double rho = plastic_density(loading_[j]), E = E_at(rho), nu = nu_at(rho),
                   x = std::log(row.rho_r);
      axial.push_back({x, (row.axial_Pa - 2 * nu * row.radial_Pa) / E});
      radial.push_back({x, (row.radial_Pa * (1 - nu) - nu * row.axial_Pa) / E});
    }
    const double a = 1 - slope(axial), r = -slope(radial);
    constexpr double most = 0.5;
    if (!(a > most)) return {};
    return (a + 2 * r) / (2.0 / 3 * (a - r));
  }

  void fit_strengths() {
    std::vector<Point> sigma_y, Gamma, Lambda, epsilon;
    constexpr double begun = 0.02; // of the largest stress: below, dies and powders do other things
    double most = 0;
    for (const auto i : loading_) most = std::max(most, rows_[i].axial_Pa);
    for (std::size_t k = 0; k < loading_.size(); ++k) {
      const auto i = loading_[k];
      if (!(rows_[i].axial_Pa > begun * most) || !(q(i) > 0)) continue;
      const auto flowing = flow(k);
      if (!flowing) continue;
      const double rho = plastic_density(i), s = *flowing;
      const double c = compressive_.at(rho, rho_r0_), t = tensile_.at(rho, rho_r0_);
      const double friction = 3 * (c - root_13 * t) / (c - 2 * t), d = c * t * (root_13 - 2) / (c - 2 * t);
      // tan^2 beta p_a^2 + (2 d tan beta + s q) p_a + d^2 - s q p - q^2 = 0
      const double A = friction * friction, B = 2 * d * friction + s * q(i),
                   C = d * d - s * q(i) * p(i) - q(i) * q(i);
      if (!(s > 0) || !(C < 0) || !(friction > 0)) continue; // below the line: no cap goes through it
      const double p_a = 2 * -C / (B + std::sqrt(B * B - 4 * A * C));
      if (!(p_a < p(i))) continue;
      const double shape = std::sqrt((p(i) - p_a) / (s * q(i))), shear = d + p_a * friction;
      sigma_y.push_back({rho, p_a + shape * shear});
      Gamma.push_back({rho, shear});
      Lambda.push_back({rho, d / friction});
      epsilon.push_back({rho, shape});
    }
    if (sigma_y.size() < 8)
      throw InvalidInput(
          fmt::format("only {} of {} loading rows lie on a cap beyond the line of shear failure; are "
                      "stresses and strengths in the same unit?",
                      sigma_y.size(), loading_.size()));
    found_.loading_rows = static_cast<int>(sigma_y.size());
    found_.trends = {fitted("sigma_y_Pa", "eta", true, sigma_y, rho_r0_),
                     E_,
                     fitted("Gamma_Pa", "zeta", true, Gamma, rho_r0_),
                     fitted("Lambda_Pa", "omega", true, Lambda, rho_r0_),
                     nu_,
                     fitted("epsilon", "xi_2", false, epsilon, rho_r0_)};
    for (const auto& trend : found_.trends)
      if (rho_r0_ < trend.low - 0.02 || rho_r0_ > trend.high)
        found_.said.push_back(fmt::format("{} is extrapolated to rho_r0 = {:.4g} from {:.3g} to {:.3g}",
                                          trend.key, rho_r0_, trend.low, trend.high));
  }

  const std::vector<CompactionRow>& rows_;
  double rho_r0_;
  Trend compressive_, tensile_, E_, nu_;
  std::vector<std::size_t> loading_;
  std::vector<std::vector<std::size_t>> unloadings_;
  Compaction found_;
};

/// A material point along the densities of the loading; relative L2 of both stresses.
void compare(Compaction& c, const std::vector<CompactionRow>& rows, double rho_r0) {
  material::MaterialPoint point;
  double reached = rho_r0, off_a = 0, all_a = 0, off_r = 0, all_r = 0;
  for (const auto& row : rows) {
    if (!(row.rho_r > reached)) continue;
    constexpr double step = 2e-3;
    const double way = std::log(row.rho_r / reached);
    const int parts = std::max(1, static_cast<int>(std::ceil(way / step)));
    for (int k = 0; k < parts; ++k) {
      point = strained(c.material.model, point, {-way / parts, 0, 0});
      if (material::is_refused(point.last.status)) {
        c.said.push_back(
            fmt::format("a material point of the card cannot be led beyond rho_r = {:.3g}", reached));
        return;
      }
    }
    reached = row.rho_r;
    off_a += std::pow(-point.last.sigma[0] - row.axial_Pa, 2), all_a += row.axial_Pa * row.axial_Pa;
    off_r += std::pow(-point.last.sigma[1] - row.radial_Pa, 2), all_r += row.radial_Pa * row.radial_Pa;
  }
  if (all_a > 0 && all_r > 0) c.axial_l2 = std::sqrt(off_a / all_a), c.radial_l2 = std::sqrt(off_r / all_r);
}

} // namespace

double Trend::at(double rho_r, double rho_r0) const {
  return exponential ? value * std::exp(growth * (rho_r - rho_r0)) : value + growth * (rho_r - rho_r0);
}

Compaction compaction(const std::vector<CompactionRow>& rows, const std::vector<StrengthRow>& strengths,
                      double rho_r0, const std::string& model, const std::string& name) {
  Compaction c = Reduction(rows, strengths, rho_r0).run();
  std::string card = fmt::format("platen = 1\nname = {}\nmodel = {}\n[parameters]\nrho_r0 = {}\n",
                                 core::in_quotes(name), core::in_quotes(model), core::number_text(rho_r0));
  const auto rounded = [](double x) {
    return core::number_text(*core::number_from(fmt::format("{:.6g}", x)));
  };
  for (const auto& t : c.trends)
    card += fmt::format("{} = {}\n{} = {}\n", t.key, rounded(t.value), t.growth_key, rounded(t.growth));
  c.material = material::read_card(core::parse_toml(card, "the card of " + name)).material;
  compare(c, rows, rho_r0);
  return c;
}

} // namespace platen::calibrate
