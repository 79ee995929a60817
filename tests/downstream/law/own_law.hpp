#pragma once
// A law outside the tree, as a user would add one: a spring of overlap^2. own_law.sh runs it by command line
// and C.

#include <platen/law/hertz.hpp>

#include <tuple>

namespace platen::law {

struct SquareSpring { // F = k gamma^2/R_e, unloading 3 times as steep
  using Scalar = double;
  Pair pair;
  double k = 0, gamma_elastic = 0, gamma_limit = 0;
  [[nodiscard]] Loading<double> loading(double gamma) const {
    return {k * gamma * gamma / pair.R_e, 2 * k * gamma / pair.R_e, std::sqrt(gamma / pair.A), 2, 0.5};
  }
  [[nodiscard]] bool in_range(double gamma) const { return gamma * pair.x_per_gamma <= 0.1; }
  [[nodiscard]] double work(double gamma) const { return loading(gamma).F * gamma / 3; }
  [[nodiscard]] Unloading<double> unloading(double gamma, const Loading<double>&) const {
    return {3 / gamma, 2};
  }
};

struct SquareSpringMaterial {
  double k = 0; ///< [Pa]
  static LawInfo info() {
    return {"square-spring", "a spring of overlap^2",
            "this test",     "delta/R <= 0.1",
            "only",          {{"k_Pa", "stiffness", positive, Of::body}}};
  }
  static SquareSpringMaterial read(const Reader& p) { return {p("k_Pa")}; }
};

inline SquareSpring prepare(const SquareSpringMaterial& m1, double R1, const SquareSpringMaterial& m2,
                            double R2) {
  SquareSpring law;
  law.pair = make_pair({1 / R1, 1 / m1.k, 0}, {1 / R2, 1 / m2.k, 0});
  law.k = smaller(m1.k, m2.k);
  law.gamma_limit = 1000 / law.pair.x_per_gamma;
  return law;
}
inline SquareSpring prepare_on_rigid_plane(const SquareSpringMaterial& m, double R) {
  return prepare(m, R, m, infinity);
}

using OwnLaws = std::tuple<SquareSpringMaterial>;

} // namespace platen::law
