#pragma once
// The 160 granules of Edmans & Sinka.

#include "reproduce/papers.hpp"

#include <string>
#include <vector>

namespace platen::reproduce {

constexpr const char* overlap_label = "overlap  δ̄ = δ/R₀";
constexpr const char* force_label = "force  F̄ = F/(πR₀²σ_y)";

/// One of them, with its law.
struct Granule {
  int run;
  double E_bar, Gamma_bar, Lambda_bar;
  double k, delta_t, a, e_p, e_a;

  double law(double x) const;
};

std::vector<Granule> granules(const Pool&);
/// InvalidInput where the pool has none.
Granule granule(const Pool&, double E_bar, double Gamma_bar, double Lambda_bar);

std::string name_of(double E_bar, double Gamma_bar, double Lambda_bar);

/// A corner of their ranges.
struct Corner {
  double E_bar, Gamma_bar, Lambda_bar;
  std::string press() const; ///< as its press is called
  std::string words() const { return name_of(E_bar, Gamma_bar, Lambda_bar); }
};
std::vector<Corner> corners();

Series force(const std::string& name, const BranchCurve&, double factor = 1, Mark = Mark::line);

} // namespace platen::reproduce
