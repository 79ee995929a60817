#pragma once
// Presses of Shahin's thesis with what the fits of its laws say of them.

#include "platen/law/agarwal_curve.hpp"
#include "platen/law/shahin_curve.hpp"
#include "reproduce/papers.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace platen::reproduce {

/// An elastic, perfectly plastic sphere.
struct Metal {
  law::LoadingCase loading;
  double lambda = 0, zeta = 0;
  BranchCurve curve; ///< F over pi R^2 sigma_y
  std::map<std::string, double>
      found; ///< D_1, …, Gamma, tau, by the names of the columns of runs.csv, without "agarwal."

  std::optional<double> operator[](const std::string& key) const;
  law::AgarwalCurve<double> published() const;
};

/// All of one loading, ascending in lambda; simple: also those of the pool von-mises from lambda = 117 on.
std::vector<Metal> metals(const Data&, law::LoadingCase);
/// Of the pool of the thesis's own rows alone.
std::vector<Metal> rows_of_table_a1(const Data&, law::LoadingCase);

/// A sphere that hardens as sigma = kappa epsilon^(1/m).
struct HardeningMetal {
  law::LoadingCase loading;
  double inverse_m = 0;
  BranchCurve curve; ///< F over pi R^2 kappa
};
std::vector<HardeningMetal> hardening_metals(const Data&, law::LoadingCase);

std::string name_of(law::LoadingCase);

/// Overlaps at which law and press are compared: 0.06 to 0.9 of the limit of the loading, as the fits of the
/// laws do.
std::vector<double> compared_overlaps(law::LoadingCase, const BranchCurve&);

/// Whether a chart draws the i-th of so many: four at most, the first and the last among them. Compared are
/// all.
bool is_drawn(std::size_t i, std::size_t of);

/// Force, radius and pressure over the overlap: press (full) and law (dashed) of each in turn.
struct Compared {
  std::string name;
  const BranchCurve* press;
  std::vector<double> x = {}, F = {}, a = {}, H = {}; ///< of the law; x may be empty
};
std::vector<Chart> three_charts(const std::vector<Compared>&, const std::string& title,
                                const std::string& stress);

} // namespace platen::reproduce
