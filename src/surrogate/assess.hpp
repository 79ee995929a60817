#pragma once
// Whether a surrogate may be asked about a material.

#include "surrogate/surrogate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace platen::surrogate {

enum class Verdict { inside, near_the_edge, outside };
std::string_view name_of(Verdict);

struct Assessment {
  Verdict verdict = Verdict::inside;
  std::vector<std::string> reasons; ///< why it is not inside
  std::size_t knots = 0;            ///< how many the law may have
  bool in_ranges = true;            ///< every number lies in the range that was pressed
};

/// Outside: a number beyond those of the pool, or other than the one that all of them have; a curve that
/// locks. Inside: a curve expected to be less than 3 % off. Near the edge: others, up to the knot where it is
/// expected to be a tenth off, unless that is below delta/R0 = 0.1: then outside.
Assessment assess(const Surrogate&, const Description&, const Prediction&);

/// The runs of the pool that weigh most: nearest first, distances in the lengths of the first component of
/// the force.
struct Near {
  std::size_t index; ///< in Surrogate::runs
  double distance;
};
std::vector<Near> nearest(const Surrogate&, const Description&, std::size_t count);
/// "powders-17: rho_r0 = 0.5, …", with what varies.
std::string words(const Surrogate&, const Near&);

struct Answer {
  Surrogate surrogate;
  Prediction prediction;
  Assessment assessment;
  double sigma_ref = 0; ///< of the material [Pa]
  bool guided = false;  ///< by a press on few elements
};

/// What a surrogate says of a material, where it knows it better than the other answer; equal is not better.
std::optional<Answer> ask(const Surrogate&, const Description&, const std::optional<Answer>& other);

/// Those of the catalogues for a model.
std::vector<Surrogate> catalogue_surrogates(const std::string& model);
/// Of these the one that knows the material best. InvalidInput where there is none
/// of its model.
Answer ask_catalogue(const Description&);

} // namespace platen::surrogate
