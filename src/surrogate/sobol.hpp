#pragma once
// Which number of a material matters: Sobol indices of its curve and energies through the surrogate.
//
//   f = f_0 + sum_i f_i(x_i) + sum_ij f_ij(x_i, x_j) + ...,   S_i = V(f_i)/V(f),   T_i: all terms with x_i
//
// S_i: the share of the variance that goes when x_i is known; T_i: what is left when all others are. With
// places A and B, and A_i, that is A with x_i of B,
//   V S_i = <(f(B) - <f>) (f(A_i) - f(A))>         Saltelli et al. (2010)
//   V T_i = <(f(A) - f(A_i))^2>/2                  Jansen (1999)

#include "surrogate/surrogate.hpp"

#include <functional>
#include <string>
#include <vector>

namespace platen::surrogate {

struct SobolIndices {
  std::string key;                  ///< number of the material
  double low = 0, high = 0;         ///< between which it was varied
  std::vector<double> alone, total; ///< S, T of each output
};

/// Sets alone and total of numbers that vary evenly between low and high, from samples (numbers + 2) values
/// of f; gives the standard deviation of each output over its mean. Deterministic.
std::vector<double> sobol_indices(const std::function<std::vector<double>(const std::vector<double>&)>& f,
                                  std::vector<SobolIndices>& numbers, int samples, int seed);

struct Sensitivity {
  std::string pool;
  std::vector<std::string> outputs;
  std::vector<double> deviation; ///< standard deviation of each over its mean
  std::vector<SobolIndices> numbers;
  std::vector<std::string> held; ///< numbers that the pool does not vary, and which are held
};

/// Each number that the pool varies anywhere within so much of itself to either side (0.2: a fifth) as far as
/// the pool reaches, evenly and on its own; force and energies over pi R0^2 sigma_ref. InvalidInput for
/// models of which the numbers do not give back a material (metals that harden), and where the material is
/// not in the ranges of the pool.
Sensitivity sobol(const Surrogate&, const material::Model&, double within, int samples = 1024, int seed = 1);

/// Of the catalogues' surrogates that one in whose ranges the material is and in which most numbers vary.
/// InvalidInput where there is none. Throws Interrupted.
Sensitivity sobol_of_catalogue(const material::Material&, double within);

} // namespace platen::surrogate
