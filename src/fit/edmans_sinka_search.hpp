#pragma once
// The search behind fit_edmans_sinka(): three parameters of one variant, for given samples.

#include "fit/samples.hpp"
#include "platen/law/edmans_sinka_curve.hpp"

#include <array>
#include <optional>
#include <vector>

namespace platen::fit {

/// k, delta_t, a.
using EdmansSinkaParameters = std::array<double, 3>;

struct EdmansSinkaBounds {
  EdmansSinkaParameters low, high;
};

class EdmansSinkaSearch {
 public:
  struct Found {
    EdmansSinkaParameters parameters{};
    double relative_l2 = 0;
  };

  EdmansSinkaSearch(const Samples&, law::EdmansSinkaVariant);

  /// The global minimum of the relative L2 error.
  Found best() const;

  /// Smallest error with one parameter held at a value, found from a point near it.
  Found best_with(std::size_t held, double value, EdmansSinkaParameters near) const;

  const EdmansSinkaBounds& bounds() const { return bounds_; }

 private:
  struct Projected {
    double k = 0, relative_squares = 1;
  };

  Projected projected(double delta_t, double a) const;
  Found polished(EdmansSinkaParameters start, const EdmansSinkaBounds&,
                 std::optional<std::size_t> held) const;
  Found polished_between(double low, double high, const Found& start) const;
  Found profile(double delta_t, const std::vector<double>& log_rates) const;
  std::vector<double> candidate_kinks() const;

  const Samples& samples_;
  law::EdmansSinkaVariant variant_;
  double force_squares_ = 0; ///< int F^2 d delta_bar
  EdmansSinkaBounds bounds_;
};

} // namespace platen::fit
