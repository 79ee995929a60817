#pragma once
// Rock: coefficients of the law of Wang et al. between the grains of a pool of local presses, by natural
// neighbours (their 4.3).
//
// They interpolate over E, nu, phi and sigma_c. But a small contact does not tell E and sigma_c apart: all it
// knows beside nu and phi is how far it is loaded beyond first yield. So the pool's 3 x 6 values of E and
// sigma_c are 18 of one number, F_y over the force, and grains lie much nearer to each other.

#include "core/csv.hpp"
#include "fit/law_card.hpp"
#include "material/models.hpp"
#include "surrogate/assess.hpp"
#include "surrogate/natural_neighbours.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace platen::surrogate {

/// a, b of (16), m, n of (17), in the law's convention.
using Coefficients = std::array<double, 4>;
inline constexpr Coefficients of_elastic = {1, 1.5, 1, 1.5};
inline constexpr std::array<const char*, 4> coefficient_names = {"a", "b", "m", "n"};

/// F over F_y at omega, as the law has it, and omega at such a force.
double force_at(const Coefficients&, double omega);
double omega_at(const Coefficients&, double force);

struct Grain {
  int run = 0; ///< in the runs.csv of its pool
  double E_Pa = 0, nu = 0, phi_deg = 0, sigma_c_Pa = 0;
  Coefficients of{}; ///< elastic where it does not yield on the axis, or hardly
};

/// Errors of predicted coefficients, relative, and of what follows from them.
struct RockErrors {
  std::array<Quantiles, 4> of;
  Quantiles force; ///< relative L2 of F over the loading
  Quantiles work;  ///< given back from the largest force
  int materials = 0;
};

struct Rock {
  std::string pool;
  int engine = 0;
  double radius_m = 0, force_N = 0; ///< all were pressed to this force
  std::vector<Grain> grains;
  RockErrors left_out;
};

/// Force at first yield over that to which the pool was pressed, for a grain of the pool's radius.
double yield_of(const Rock&, const Grain&);
/// What natural neighbours are taken in: nu and phi over the pool's ranges, the logarithm of yield_of() over
/// 4: of 1, 2, 4 and 8 the grains that are left out come out best with 4.
std::vector<double> coordinates_of(const Rock&, const Grain&);
/// The paper's: E, nu, phi and sigma_c over their ranges.
std::vector<double> four_coordinates_of(const Rock&, const Grain&);

/// ln a, b, ln m and n between grains; none outside of them.
class RockInterpolation {
 public:
  using CoordinatesOf = std::vector<double> (*)(const Rock&, const Grain&);
  explicit RockInterpolation(const Rock&, CoordinatesOf = coordinates_of);
  std::optional<Coefficients> at(const Grain&) const;
  std::vector<Share> shares(const Grain&) const;
  const Rock& rock() const { return rock_; }

 private:
  const Rock& rock_;
  CoordinatesOf coordinates_;
  NaturalNeighbours neighbours_;
};

/// Of predicted coefficients, by grain; none where a grain could not be predicted.
RockErrors errors_of(const Rock&, const std::vector<std::optional<Coefficients>>&);

/// Of grains that the rock is not made of. InvalidInput where they were pressed otherwise.
RockErrors errors_beside(const Rock&, const Rock& other);

/// What natural neighbours say of each grain from the others; none of those at the corners.
std::vector<std::optional<Coefficients>> left_out_by_neighbours(
    const Rock&, RockInterpolation::CoordinatesOf = coordinates_of);

/// A way to predict a grain from the others, with its errors.
struct RockMethod {
  std::string name;
  RockErrors errors;
};
/// Natural neighbours, Gaussian processes, regressions: each grain predicted without itself. Throws
/// Interrupted.
std::vector<RockMethod> rock_methods(const Rock&);

/// Whether the study of a pool fits the law wang: it is one of rock, then.
bool is_of_rock(const std::filesystem::path& folder);
/// With its errors. InvalidInput where the pool is none of local presses of drucker-prager, fitted with wang.
Rock rock_of_pool(const std::filesystem::path& folder);
/// The file that `platen predict` reads, grains.csv in the folder of the pool.
std::string text_of(const Rock&);
Rock read_rock(const std::filesystem::path&);
Rock read_rock(const core::Csv&);

struct PredictedRock {
  fit::LawCard card;
  Rock rock;
  Verdict verdict = Verdict::inside;
  std::vector<std::string> reasons;
  Coefficients of{};
  double yield = 0;              ///< as yield_of()
  std::vector<std::string> near; ///< the three grains with the greatest share
};
/// InvalidInput where the grains say nothing of the material: it advises to press the card.
PredictedRock predict_rock(const RockInterpolation&, const material::Material&,
                           const std::string& advised_card);
/// From the catalogues' pool of rock.
PredictedRock predict_rock(const material::Material&, const std::string& advised_card);
/// What else could be done about the material of a card.
std::string advice_to_press(const std::string& card);

} // namespace platen::surrogate
