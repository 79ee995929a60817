#include "surrogate/process.hpp"

#include "core/vector_clones.hpp"
#include "platen/lanes.hpp"
#include "surrogate/kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::size_t most_for_variance = 160;

/// Numbers of the inputs at these distances that are asked, nearest first, and of equals the first.
std::vector<std::size_t> nearest(const double* r, std::size_t count) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < count; ++i) order.emplace_back(r[i], i);
  const auto asked = order.begin() + static_cast<std::ptrdiff_t>(std::min(count, most_for_variance));
  std::nth_element(order.begin(), asked, order.end());
  std::sort(order.begin(), asked);
  std::vector<std::size_t> near;
  std::for_each(order.begin(), asked, [&](const auto& one) { near.push_back(one.second); });
  return near;
}

Inputs rows_at(const Columns& inputs, const std::vector<std::size_t>& which) {
  Inputs some{inputs.dimensions(), {}};
  for (const std::size_t i : which)
    for (std::size_t k = 0; k < inputs.dimensions(); ++k) some.values.push_back(inputs.column(k)[i]);
  return some;
}

/// R = L L^T over the nearest inputs, a row an input. From place to place few of them change, and those were
/// the farthest: the rows before the first one that has gone stay.
class NearFactor {
 public:
  /// k^T R^-1 k.
  double explained(const MatrixXd& R, std::vector<std::size_t> near, const double* k) {
    keep(near, R.rows());
    for (const std::size_t input : near) append(R, input);
    std::array<double, most_for_variance> z{};
    for (std::size_t i = 0; i < order_.size(); ++i)
      z[i] = (k[order_[i]] - product(row(i), z.data(), i)) / row(i)[i];
    return product(z.data(), z.data(), order_.size());
  }

 private:
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  double* row(std::size_t i) { return L_.data() + i * most_for_variance; }

  /// What of `near`, nearest first, is there already goes from it.
  void keep(std::vector<std::size_t>& near, Eigen::Index inputs) {
    std::vector<char> wanted(static_cast<std::size_t>(inputs));
    for (const std::size_t input : near) wanted[input] = 1;
    order_.erase(std::find_if(order_.begin(), order_.end(), [&](std::size_t i) { return !wanted[i]; }),
                 order_.end());
    for (const std::size_t input : order_) wanted[input] = 0;
    std::erase_if(near, [&](std::size_t i) { return !wanted[i]; });
  }

  void append(const MatrixXd& R, std::size_t input) {
    L_.resize(most_for_variance * most_for_variance);
    const std::size_t n = order_.size();
    double* own = row(n);
    std::fill(own, own + most_for_variance, 0);
    for (std::size_t i = 0; i < n; ++i)
      own[i] = (R(index(order_[i]), index(input)) - product(row(i), own, i)) / row(i)[i];
    own[n] = std::sqrt(R(index(input), index(input)) - product(own, own, n));
    order_.push_back(input);
  }

  /// Of the first numbers, where beyond them zeros stand in one of the two.
  static double product(const double* x, const double* y, std::size_t count) {
    using T = core::Lanes;
    static_assert(core::lanes<T> == 8 && most_for_variance % 8 == 0);
    T sum{}, a, b;
    for (std::size_t i = 0; i < count; i += 8) {
      std::memcpy(&a, x + i, sizeof a);
      std::memcpy(&b, y + i, sizeof b);
      sum += a * b;
    }
    return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }

  std::vector<std::size_t> order_;
  std::vector<double> L_;
};

} // namespace

struct Known {
  MatrixXd R; ///< of all inputs
  mutable NearFactor near;
};

void remember(Process& p, const Inputs& inputs) {
  p.known = std::make_shared<Known>(Known{matrix_of(p, inputs), {}});
}

namespace {

constexpr std::size_t width = core::lanes<core::Lanes>;

/// What the kernels of all processes have in common at a place, of some of the inputs.
struct Place {
  std::size_t length;
  std::vector<double> squares; ///< 5 (x_i - at_i)^2, a column a coordinate
  std::vector<double> plane;   ///< 1 + (x - 1/2).(at - 1/2)
};

PLATEN_VECTOR_CLONES void look(Place& place, const Columns& inputs, std::size_t first,
                               std::span<const double> at) {
  std::fill_n(place.plane.begin(), place.length, 1);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double* const x = inputs.column(k) + first;
    double *const square = place.squares.data() + k * place.length, *const plane = place.plane.data();
    const double here = at[k], from_middle = here - 0.5;
    for (std::size_t i = 0; i < place.length; ++i) {
      square[i] = 5 * (x[i] - here) * (x[i] - here);
      plane[i] += (x[i] - 0.5) * from_middle;
    }
  }
}

Place place_for(const Columns& inputs, std::size_t length) {
  return {length, std::vector<double>(length * inputs.dimensions()), std::vector<double>(length)};
}

std::vector<double> squared(std::vector<double> w) {
  for (double& one : w) one *= one;
  return w;
}

/// each(i, r, k): distances of so many inputs from i on, and their kernels over v. `w2`: squared(p.w).
template <class Each>
void for_kernels(const Process& p, const std::vector<double>& w2, const Place& place, Each each) {
  using T = core::Lanes;
  T x;
  const double* const scales = w2.data();
  const std::size_t dimensions = w2.size();
  for (std::size_t i = 0; i < place.length; i += width) {
    T square{};
    const double* column = place.squares.data() + i;
    for (std::size_t k = 0; k < dimensions; ++k, column += place.length) {
      std::memcpy(&x, column, sizeof x);
      square += scales[k] * x;
    }
    const T r = core::sqrt(square);
    std::memcpy(&x, &place.plane[i], sizeof x);
    each(i, r, (1 + r + r * r / 3) * core::exp(-r) + p.plane * x);
  }
}

/// Sum of kernel times weight; `weights` as long as the columns.
PLATEN_VECTOR_CLONES [[gnu::flatten]] double weighted(const Process& p, const std::vector<double>& w2,
                                                      const Place& place, const double* weights) {
  using T = core::Lanes;
  T sum{}, w;
  for_kernels(p, w2, place, [&](std::size_t i, const T&, const T& kernel) {
    std::memcpy(&w, weights + i, sizeof w);
    sum += w * kernel;
  });
  double all = 0;
  for (std::size_t n = 0; n < width; ++n) all += sum[n];
  return all;
}

/// Distances and kernels themselves, as long as the columns.
PLATEN_VECTOR_CLONES [[gnu::flatten]] void kernels(const Process& p, const std::vector<double>& w2,
                                                   const Place& place, double* distances, double* over_v) {
  using T = core::Lanes;
  for_kernels(p, w2, place, [&](std::size_t i, const T& r, const T& kernel) {
    std::memcpy(distances + i, &r, sizeof r);
    std::memcpy(over_v + i, &kernel, sizeof kernel);
  });
}

} // namespace

Columns::Columns(const Inputs& inputs)
    : count_(inputs.size()), dimensions_(inputs.dimensions), length_((count_ + width - 1) / width * width),
      values_(length_ * dimensions_) {
  for (std::size_t i = 0; i < count_; ++i)
    for (std::size_t k = 0; k < dimensions_; ++k) values_[k * length_ + i] = inputs.row(i)[k];
}

std::vector<double> means(std::span<const Process> processes, const Columns& inputs,
                          std::span<const double> at) {
  constexpr std::size_t part = 128; // of the inputs at a time, which the first cache holds
  Place place = place_for(inputs, std::min(part, inputs.length()));
  std::vector<double> result(processes.size());
  std::vector<std::vector<double>> w2;
  for (const Process& p : processes) w2.push_back(squared(p.w));
  for (std::size_t first = 0; first < inputs.length(); first += part) {
    place.length = std::min(part, inputs.length() - first);
    look(place, inputs, first, at);
    const std::size_t count = std::min(part, inputs.size() - first);
    for (std::size_t c = 0; c < processes.size(); ++c) {
      std::array<double, part> weights{};
      std::copy_n(processes[c].weights.begin() + static_cast<std::ptrdiff_t>(first), count, weights.begin());
      result[c] += processes[c].variance * weighted(processes[c], w2[c], place, weights.data());
    }
  }
  return result;
}

LeftOut left_out(const Process& p, const Inputs& inputs, std::span<const double> values) {
  const auto n = static_cast<Eigen::Index>(inputs.size());
  const Eigen::LLT<MatrixXd> factor(matrix_of(p, inputs));
  const VectorXd z = factor.solve(Eigen::Map<const VectorXd>(values.data(), n));
  const MatrixXd inverse = factor.solve(MatrixXd::Identity(n, n));
  LeftOut out;
  for (Eigen::Index i = 0; i < n; ++i) {
    out.mean.push_back(values[static_cast<std::size_t>(i)] - z(i) / inverse(i, i));
    out.variance.push_back(p.variance / inverse(i, i));
  }
  return out;
}

void pass_through(Process& p, const Inputs& inputs, std::span<const double> values) {
  const auto n = static_cast<Eigen::Index>(inputs.size());
  const VectorXd y = Eigen::Map<const VectorXd>(values.data(), n);
  const VectorXd z = matrix_of(p, inputs).llt().solve(y);
  p.variance = y.dot(z) / static_cast<double>(n);
  p.weights.clear();
  for (Eigen::Index i = 0; i < n; ++i) p.weights.push_back(z(i) / p.variance);
}

std::vector<double> variances(std::span<const Process> processes, const Columns& inputs,
                              std::span<const double> at) {
  Place place = place_for(inputs, inputs.length());
  look(place, inputs, 0, at);
  std::vector<double> r(place.length), k(place.length), result;
  for (const Process& p : processes) {
    kernels(p, squared(p.w), place, r.data(), k.data());
    auto near = nearest(r.data(), inputs.size());
    double explained = 0;
    if (p.known) explained = p.known->near.explained(p.known->R, std::move(near), k.data());
    else {
      VectorXd asked(near.size());
      for (std::size_t i = 0; i < near.size(); ++i) asked(static_cast<Eigen::Index>(i)) = k[near[i]];
      explained = matrix_of(p, rows_at(inputs, near)).llt().matrixL().solve(asked).squaredNorm();
    }
    result.push_back(p.variance * std::max(0.0, 1 + p.plane * plane_product(at, at) - explained));
  }
  return result;
}

} // namespace platen::surrogate
