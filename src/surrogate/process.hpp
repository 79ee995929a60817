#pragma once
// Kriging: a function of a few numbers as a Gaussian process through its values (Rasmussen & Williams 2006,
// chapter 2).
//
//   k(x, y) = v [ (1 + r + r^2/3) exp(-r) + b (1 + x.y) + n (x is y) ],   r^2 = 5 sum_i (w_i (x_i - y_i))^2
//
// Matern 5/2 with a length 1/w_i for each coordinate, on a plane whose slopes are part of it, and a nugget n.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace platen::surrogate {

/// Rows of coordinates, one after the other.
struct Inputs {
  std::size_t dimensions = 0;
  std::vector<double> values;

  std::size_t size() const { return dimensions ? values.size() / dimensions : 0; }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * dimensions, dimensions}; }
};

/// Inputs by coordinate, filled up to whole vectors: what is asked at many places.
class Columns {
 public:
  Columns() = default;
  Columns(const Inputs&); // NOLINT: implicit
  std::size_t size() const { return count_; }
  std::size_t dimensions() const { return dimensions_; }
  std::size_t length() const { return length_; } ///< of a column
  const double* column(std::size_t k) const { return values_.data() + k * length_; }

 private:
  std::size_t count_ = 0, dimensions_ = 0, length_ = 0;
  std::vector<double> values_;
};

/// What variances need of all inputs at once; for those who ask at many places (remember()).
struct Known;

struct Process {
  std::vector<double> w;       ///< inverse lengths
  double variance = 1;         ///< v
  double plane = 0;            ///< b
  double nugget = 0;           ///< n
  std::vector<double> weights; ///< of the inputs, K^-1 y
  std::shared_ptr<const Known> known = {};
};

/// What processes over the same inputs say at a place.
std::vector<double> means(std::span<const Process>, const Columns&, std::span<const double> at);

/// What the process says of each value when it is left out, the rest and the lengths as they are (closed
/// form).
struct LeftOut {
  std::vector<double> mean, variance; ///< the variance with the nugget
};

LeftOut left_out(const Process&, const Inputs&, std::span<const double> values);

/// Sets variance and weights so that the process of these lengths, plane and nugget goes through the values.
void pass_through(Process&, const Inputs&, std::span<const double> values);

/// Lengths, plane and nugget of the greatest posterior density, of many values that of the first ones;
/// coordinates are expected in about [0, 1], values about zero. Deterministic.
Process fit_process(const Inputs&, std::span<const double> values);

/// Of the functions at a place, without the nugget. Of many inputs the nearest alone are asked, so they are a
/// little too large.
std::vector<double> variances(std::span<const Process>, const Columns&, std::span<const double> at);

/// From now on variances() takes a part of the time, with the same result, the less the nearer places follow
/// each other. Wants the inputs as they stay, and one thread.
void remember(Process&, const Inputs&);

} // namespace platen::surrogate
