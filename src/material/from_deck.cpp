#include "core/error.hpp"
#include "material/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace platen::material {
namespace {

using core::InvalidInput;
using Numbers = std::vector<double>;

constexpr double degree = std::numbers::pi / 180;

double tan_deg(double angle) { return std::tan(angle * degree); }

/// y = at_0 + slope x by least squares, with R2.
struct Line {
  double at_0 = 0, slope = 0, R2 = 1;
};
Line regression(const Numbers& x, const Numbers& y) {
  const double n = static_cast<double>(x.size());
  double mx = 0, my = 0, sxx = 0, sxy = 0, syy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx), sxy += (x[i] - mx) * (y[i] - my), syy += (y[i] - my) * (y[i] - my);
  }
  Line line;
  line.slope = sxx > 0 ? sxy / sxx : 0;
  line.at_0 = my - line.slope * mx;
  line.R2 = syy > 0 && sxx > 0 ? sxy * sxy / (sxx * syy) : 1;
  return line;
}

double six_digits(double value) { return value == 0 ? 0 : std::stod(fmt::format("{:.6g}", value)); }

class Converter {
 public:
  Converter(const DeckMaterial& deck, const DeckUnits& units, std::optional<double> rho_r0)
      : deck_(deck), units_(units), rho_r0_(rho_r0) {}

  Converted run() {
    out_.material.name = deck_.name.empty() ? "material" : deck_.name;
    if (deck_.find("CAP PLASTICITY")) out_.material.model = cap();
    else if (deck_.find("DRUCKER PRAGER")) out_.material.model = drucker_prager();
    else if (deck_.find("MOHR COULOMB")) out_.material.model = mohr_coulomb();
    else if (deck_.find("PLASTIC")) out_.material.model = von_mises();
    else {
      const auto [E, nu] = elastic();
      out_.material.model = Elastic{E, nu};
    }
    if (const auto* density = deck_.find("DENSITY")) {
      used_.insert("DENSITY");
      one_row_only(*density);
      out_.material.density = six_digits(needed(*density, 0, 0, "density") * units_.density);
    }
    for (const auto& keyword : deck_.keywords)
      if (!used_.contains(keyword.name))
        out_.left_over.push_back(fmt::format("line {}: *{}", keyword.line, keyword.name));
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(const Keyword& keyword, std::string_view why) const {
    throw InvalidInput(fmt::format("{}, line {}, *{}: {}", deck_.file, keyword.line, keyword.name, why));
  }
  void leave(const Keyword& keyword, std::string_view what) {
    out_.left_over.push_back(fmt::format("line {}: *{}: {}", keyword.line, keyword.name, what));
  }

  void say(std::string_view sentence) { out_.said.emplace_back(sentence); }

  const Keyword& keyword(const std::string& name) {
    const auto* found = deck_.find(name);
    if (!found)
      throw InvalidInput(fmt::format("{}: the material {} has no *{}", deck_.file, deck_.name, name));
    used_.insert(name);
    return *found;
  }
  double needed(const Keyword& k, std::size_t row, std::size_t column, const char* what) const {
    if (row >= k.rows.size() || column >= k.rows[row].size() || !k.rows[row][column])
      refuse(k, fmt::format("its {} is missing", what));
    return *k.rows[row][column];
  }
  double stress(const Keyword& k, std::size_t row, std::size_t column, const char* what) const {
    return needed(k, row, column, what) * units_.stress;
  }
  static double or_zero(const Keyword& k, std::size_t row, std::size_t column) {
    return row < k.rows.size() && column < k.rows[row].size() ? k.rows[row][column].value_or(0) : 0;
  }
  void one_row_only(const Keyword& k) {
    if (k.rows.size() > 1)
      leave(k,
            fmt::format("{} more rows, over temperature or a field; the first is taken", k.rows.size() - 1));
  }

  void check_elastic_type(const Keyword& k) const {
    const std::string type = k.parameter("TYPE");
    if (!type.empty() && type != "ISOTROPIC" && type != "isotropic" && type != "ISO")
      refuse(k, fmt::format("TYPE={} has no counterpart; elasticity is isotropic here", type));
  }
  std::pair<double, double> elastic() {
    const Keyword& k = keyword("ELASTIC");
    check_elastic_type(k);
    one_row_only(k);
    return {six_digits(stress(k, 0, 0, "modulus")), needed(k, 0, 1, "Poisson's ratio")};
  }

  /// An angle of a yield surface: what is below 1.6 is hardly in degrees.
  double angle(const Keyword& k, std::size_t column, const char* what) const {
    const double value = needed(k, 0, column, what);
    if (value > 0 && value < 1.6)
      refuse(k, fmt::format(
                    "{} = {:.6g}: Abaqus has it in degrees; read as radians it would be {:.4g} degrees, as a "
                    "tangent {:.4g}",
                    what, value, value / degree, std::atan(value) / degree));
    return value;
  }

  VonMises von_mises() {
    const auto [E, nu] = elastic();
    const Keyword& k = keyword("PLASTIC");
    const std::string hardening = k.parameter("HARDENING");
    if (!hardening.empty() && hardening != "ISOTROPIC" && hardening != "isotropic")
      refuse(k, fmt::format("HARDENING={} has no counterpart; hardening is isotropic here", hardening));
    if (!k.parameter("RATE").empty()) leave(k, "RATE: the law knows no rate");
    Numbers strain, sigma;
    std::size_t left = 0;
    for (std::size_t row = 0; row < k.rows.size(); ++row) {
      const double eps = or_zero(k, row, 1);
      if (left > 0 || or_zero(k, row, 2) != or_zero(k, 0, 2) || (row > 0 && eps <= strain.back())) {
        ++left;
        continue;
      }
      strain.push_back(eps);
      sigma.push_back(six_digits(stress(k, row, 0, "yield stress")));
    }
    if (left > 0) leave(k, fmt::format("{} rows of other temperatures, fields or rates", left));
    if (strain.empty()) refuse(k, "it has no rows");
    if (strain.front() != 0) refuse(k, "the first plastic strain must be 0, where yield begins");
    if (strain.size() > HardeningTable::size_max)
      refuse(k, fmt::format("{} rows; a hardening table has {} at most", strain.size(),
                            HardeningTable::size_max));
    VonMises m{E, nu, sigma.front()};
    if (strain.size() > 1) m.hardening = HardeningTable(strain, sigma);
    return m;
  }

  DruckerPrager drucker_prager() {
    const auto [E, nu] = elastic();
    const Keyword& k = keyword("DRUCKER PRAGER");
    const std::string criterion = k.parameter("SHEAR CRITERION");
    if (!criterion.empty() && criterion != "LINEAR" && criterion != "linear")
      refuse(k, fmt::format("SHEAR CRITERION={} has no counterpart; the yield line is straight here",
                            criterion));
    one_row_only(k);
    const double beta = angle(k, 0, "beta"), K = or_zero(k, 0, 1) > 0 ? or_zero(k, 0, 1) : 1;
    if (K < 7.0 / 9 || K > 1)
      refuse(k, fmt::format("K = {:.4g}: it must be in [7/9, 1], where the section is convex", K));
    const double psi = or_zero(k, 0, 2);
    const Keyword& h = keyword("DRUCKER PRAGER HARDENING");
    std::string type = h.parameter("TYPE");
    if (type.empty()) type = "COMPRESSION";
    for (char& c : type) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const double sigma = stress(h, 0, 0, "yield stress");
    if (h.rows.size() > 1)
      leave(h, fmt::format("{} more rows: the strength does not harden here; the first is taken",
                           h.rows.size() - 1));
    // d of q + p tan(beta) = d, by the test that gives the hardening
    const double d = type == "TENSION" ? (1 / K + tan_deg(beta) / 3) * sigma
                     : type == "SHEAR" ? std::numbers::sqrt3 / 2 * (1 + 1 / K) * sigma
                                       : (1 - tan_deg(beta) / 3) * sigma;
    if (type != "COMPRESSION" && type != "TENSION" && type != "SHEAR")
      refuse(h, fmt::format("TYPE={} is none of COMPRESSION, TENSION, SHEAR", type));
    out_.said.push_back(
        fmt::format("linear Drucker-Prager {} + p tan(beta) = d in (p, q), p tension positive: d = {:.4g} "
                    "Pa, from TYPE={}",
                    K == 1 ? "q" : "t", d, type));
    const double sigma_c = d / (1 - tan_deg(beta) / 3);
    if (!(sigma_c > 0))
      refuse(k, fmt::format("beta = {:.4g}: it must be below atan 3 = 71.57 degrees", beta));
    return {E, nu, beta, six_digits(sigma_c), psi, K};
  }

  MohrCoulomb mohr_coulomb() {
    const auto [E, nu] = elastic();
    const Keyword& k = keyword("MOHR COULOMB");
    one_row_only(k);
    leave(k, "its smooth flow potential, hyperbolic in the meridian and rounded in section: flow is of "
             "Mohr-Coulomb's own shape with psi here");
    const double phi = angle(k, 0, "phi"), psi = or_zero(k, 0, 1);
    const Keyword& h = keyword("MOHR COULOMB HARDENING");
    const double cohesion = six_digits(stress(h, 0, 0, "cohesion"));
    if (h.rows.size() > 1)
      leave(h, fmt::format("{} more rows: the cohesion does not harden here; the first is taken",
                           h.rows.size() - 1));
    const double apex = cohesion / tan_deg(phi);
    double cutoff = six_digits(0.999 * apex);
    if (deck_.find("TENSION CUTOFF")) {
      const Keyword& t = keyword("TENSION CUTOFF");
      if (t.rows.size() > 1)
        leave(t, fmt::format("{} more rows: the cut-off does not soften here", t.rows.size() - 1));
      cutoff = six_digits(stress(t, 0, 0, "cut-off"));
    } else say("no *TENSION CUTOFF: the cut-off is put at 0.999 of the apex, where it cuts nothing");
    return {E, nu, phi, cohesion, psi, cutoff};
  }

  /// Rows over a field variable: where the last number of each row grows within (0, 1].
  Numbers densities(const Keyword& k, std::size_t values) const {
    Numbers rho;
    for (const auto& row : k.rows) {
      if (row.size() < values + 2 || !row.back()) return {};
      if (!(*row.back() > 0 && *row.back() <= 1) || (!rho.empty() && *row.back() <= rho.back())) return {};
      rho.push_back(*row.back());
    }
    return rho;
  }

  /// DPC of the paper from the cap model: d = Lambda tan(beta), R = epsilon, p_b = sigma_y,
  /// p_a = (p_b - R d)/(1 + R tan(beta)) = pi_3, Gamma = d + p_a tan(beta).
  Dpc cap() {
    const Keyword& e = keyword("ELASTIC");
    check_elastic_type(e);
    const Keyword& c = keyword("CAP PLASTICITY");
    const Keyword& h = keyword("CAP HARDENING");
    const Numbers rho_c = densities(c, 6), rho_e = densities(e, 2);
    if (!rho_r0_ && !rho_c.empty()) {
      rho_r0_ = rho_c.front();
      out_.said.push_back(
          fmt::format("the field variable is taken as relative density; volumetric plastic strain is 0 "
                      "at its first value, rho_r0 = {:.6g}",
                      *rho_r0_));
    }
    if (!rho_r0_)
      refuse(c,
             "which relative density belongs to volumetric plastic strain 0? Give it with --rho_r0 NUMBER");
    if (!(*rho_r0_ > 0 && *rho_r0_ <= 1))
      refuse(c, fmt::format("rho_r0 = {:.6g} must be in (0, 1]", *rho_r0_));
    if (h.rows.empty()) refuse(h, "it has no rows");
    const double rho_0 = *rho_r0_;
    const auto change = [&](const Numbers& rho) {
      Numbers x;
      for (double r : rho) x.push_back(r - rho_0);
      return x;
    };
    // sigma_y over density: rho = rho_r0 exp(volumetric plastic strain)
    Numbers x_h, ln_p;
    for (std::size_t row = 0; row < h.rows.size(); ++row) {
      const double rho = rho_0 * std::exp(or_zero(h, row, 1));
      if (rho > 1.0001) {
        leave(h, fmt::format("rows from {} on: beyond relative density 1", row + 1));
        break;
      }
      x_h.push_back(rho - rho_0);
      ln_p.push_back(std::log(stress(h, row, 0, "hydrostatic yield stress")));
    }
    const Line sigma_y = regression(x_h, ln_p);
    Numbers ln_E, nu, ln_Gamma, ln_Lambda, epsilon;
    for (std::size_t row = 0; row < e.rows.size(); ++row) {
      ln_E.push_back(std::log(stress(e, row, 0, "modulus")));
      nu.push_back(needed(e, row, 1, "Poisson's ratio"));
    }
    const Numbers x_c = rho_c.empty() ? Numbers(c.rows.size(), 0.0) : change(rho_c);
    const Numbers x_e = rho_e.empty() ? Numbers(e.rows.size(), 0.0) : change(rho_e);
    for (std::size_t row = 0; row < c.rows.size(); ++row) {
      const double d = stress(c, row, 0, "cohesion d"),
                   tan_b = tan_deg(row == 0 ? angle(c, 1, "beta") : needed(c, row, 1, "beta"));
      const double R = needed(c, row, 2, "cap eccentricity R");
      const double p_b = std::exp(sigma_y.at_0 + sigma_y.slope * x_c[row]);
      const double p_a = (p_b - R * d) / (1 + R * tan_b);
      if (!(d > 0 && tan_b > 0 && p_a > 0))
        refuse(c, fmt::format("row {}: cohesion, beta and cap leave no cone", row + 1));
      ln_Lambda.push_back(std::log(d / tan_b));
      ln_Gamma.push_back(std::log(d + p_a * tan_b));
      epsilon.push_back(R);
    }
    cap_left_over(c);
    if (rho_c.empty() && c.rows.size() > 1)
      leave(c, "its rows are not over relative density in (0, 1]: only their mean is taken");
    const Line E = regression(x_e, ln_E), poisson = regression(x_e, nu), Gamma = regression(x_c, ln_Gamma),
               Lambda = regression(x_c, ln_Lambda), shape = regression(x_c, epsilon);
    for (const auto& [line, what] :
         {std::pair{sigma_y, "sigma_y"}, std::pair{E, "E"}, std::pair{Gamma, "Gamma"},
          std::pair{Lambda, "Lambda"}, std::pair{poisson, "nu"}, std::pair{shape, "epsilon"}})
      out_.said.push_back(fmt::format("{} over relative density: R2 = {:.6f}", what, line.R2));
    Dpc m{};
    m.rho_r0 = six_digits(rho_0);
    m.sigma_y = six_digits(std::exp(sigma_y.at_0)), m.eta = six_digits(sigma_y.slope);
    m.E = six_digits(std::exp(E.at_0)), m.xi = six_digits(E.slope);
    m.nu = six_digits(poisson.at_0), m.xi_1 = six_digits(poisson.slope);
    m.Gamma = six_digits(std::exp(Gamma.at_0)), m.zeta = six_digits(Gamma.slope);
    m.Lambda = six_digits(std::exp(Lambda.at_0)), m.omega = six_digits(Lambda.slope);
    m.epsilon = six_digits(shape.at_0), m.xi_2 = six_digits(shape.slope);
    return m;
  }

  void cap_left_over(const Keyword& c) {
    if (or_zero(c, 0, 3) != 0)
      leave(c, fmt::format("initial volumetric plastic strain {:.4g}: rho_r0 is the density where it is 0",
                           or_zero(c, 0, 3)));
    leave(c, fmt::format("the transition alpha = {:.4g}: here an arc of A = {:.2g} joins line and cap",
                         or_zero(c, 0, 4), Dpc::A));
    const double K = or_zero(c, 0, 5);
    if (K > 0 && K != 1) leave(c, fmt::format("K = {:.4g}: the section is a circle here, K = 1", K));
  }

  const DeckMaterial& deck_;
  const DeckUnits& units_;
  std::optional<double> rho_r0_;
  std::set<std::string> used_;
  Converted out_;
};

} // namespace

Converted convert(const DeckMaterial& deck, const DeckUnits& units, std::optional<double> rho_r0) {
  if (rho_r0 && !deck.find("CAP PLASTICITY"))
    throw core::InvalidInput(
        fmt::format("{}: rho_r0 goes with *CAP PLASTICITY, which is not there", deck.file));
  return Converter(deck, units, rho_r0).run();
}

} // namespace platen::material
