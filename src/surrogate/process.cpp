#include "surrogate/process.hpp"

#include "core/lanes.hpp"
#include "core/vector_clones.hpp"
#include "surrogate/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace platen::surrogate {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr std::size_t most_for_variance = 160;

/// Numbers of the inputs at these distances, those that are asked first: nearest, and of equals the first.
std::vector<std::pair<double, std::size_t>> nearest_first(const Eigen::ArrayXd& r, std::size_t& asked) {
  std::vector<std::pair<double, std::size_t>> order;
  for (Eigen::Index i = 0; i < r.size(); ++i) order.emplace_back(r(i), static_cast<std::size_t>(i));
  asked = std::min(order.size(), most_for_variance);
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(asked), order.end());
  return order;
}

Inputs rows_at(const Inputs& inputs, const std::vector<Eigen::Index>& which) {
  Inputs some{inputs.dimensions, {}};
  for (const auto i : which) {
    const auto row = inputs.row(static_cast<std::size_t>(i));
    some.values.insert(some.values.end(), row.begin(), row.end());
  }
  return some;
}

} // namespace

namespace {

/// R = L L^T over the nearest inputs, a row an input. From place to place few of them change, and those were
/// the farthest: the rows before the first one that has gone stay.
class NearFactor {
 public:
  /// k^T R^-1 k.
  double explained(const MatrixXd& R, std::vector<std::size_t> near, const Eigen::ArrayXd& k) {
    keep(near, R.rows());
    for (const std::size_t input : near) append(R, input);
    solution_.clear();
    double sum = 0;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      const double z = (k(index(order_[i])) - product(row(i), solution_.data(), i)) / row(i)[i];
      solution_.push_back(z);
      sum += z * z;
    }
    return sum;
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
    for (std::size_t i = 0; i < n; ++i)
      own[i] = (R(index(order_[i]), index(input)) - product(row(i), own, i)) / row(i)[i];
    own[n] = std::sqrt(R(index(input), index(input)) - product(own, own, n));
    order_.push_back(input);
  }

  static double product(const double* x, const double* y, std::size_t count) {
    using T = core::Lanes;
    constexpr std::size_t width = core::lanes<T>;
    T sum{}, a, b;
    std::size_t i = 0;
    for (; i + width <= count; i += width) {
      std::memcpy(&a, x + i, sizeof a);
      std::memcpy(&b, y + i, sizeof b);
      sum += a * b;
    }
    double all = 0;
    for (; i < count; ++i) all += x[i] * y[i];
    for (std::size_t n = 0; n < width; ++n) all += sum[n];
    return all;
  }

  std::vector<std::size_t> order_;
  std::vector<double> L_, solution_;
};

} // namespace

/// R = L L^T of all inputs; of so many that the nearest are the smaller part, R alone.
struct Known {
  MatrixXd L_inverse, inverse, R;
  mutable NearFactor near;
};

namespace {

/// k^T R^-1 k over the inputs that are asked: over all of them, less what the others T add. With q = R^-1 k
/// that is q_T^T (R^-1)_TT^-1 q_T, the closed form of leaving out.
double explained_by_known(const Process& p, const Inputs& inputs, std::span<const double> at) {
  std::size_t asked = 0;
  const Eigen::ArrayXd r = distances(p, inputs, at);
  const auto order = nearest_first(r, asked);
  const VectorXd z = p.known->L_inverse.triangularView<Eigen::Lower>() * kernels(p, inputs, at, r).matrix();
  const auto left = static_cast<Eigen::Index>(order.size() - asked);
  if (left == 0) return z.squaredNorm();
  MatrixXd P(left, left);
  VectorXd q(left);
  for (Eigen::Index a = 0; a < left; ++a) {
    const auto i = static_cast<Eigen::Index>(order[asked + static_cast<std::size_t>(a)].second);
    q(a) = p.known->L_inverse.col(i).dot(z);
    for (Eigen::Index b = 0; b <= a; ++b)
      P(a, b) =
          p.known->inverse(static_cast<Eigen::Index>(order[asked + static_cast<std::size_t>(b)].second), i);
  }
  return z.squaredNorm() - P.llt().matrixL().solve(q).squaredNorm();
}

} // namespace

void remember(Process& p, const Inputs& inputs) {
  const auto n = static_cast<Eigen::Index>(inputs.size());
  auto known = std::make_shared<Known>();
  known->R = matrix_of(p, inputs);
  if (inputs.size() <= 2 * most_for_variance) {
    known->L_inverse = known->R.llt().matrixL().solve(MatrixXd::Identity(n, n));
    known->inverse = known->L_inverse.transpose() * known->L_inverse;
    known->R.resize(0, 0);
  }
  p.known = std::move(known);
}

namespace {

/// What the kernels of all processes have in common at a place: columns of inputs, filled up to whole
/// vectors.
struct Place {
  std::size_t length;
  std::vector<double> squares; ///< 5 (x_i - at_i)^2, a column a coordinate
  std::vector<double> plane;   ///< 1 + (x - 1/2).(at - 1/2)

  Place(const Inputs& inputs, std::span<const double> at)
      : length((inputs.size() + width - 1) / width * width), squares(length * inputs.dimensions),
        plane(length) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const auto x = inputs.row(i);
      for (std::size_t k = 0; k < x.size(); ++k)
        squares[k * length + i] = 5 * (x[k] - at[k]) * (x[k] - at[k]);
      plane[i] = plane_product(x, at);
    }
  }
  static constexpr std::size_t width = core::lanes<core::Lanes>;
};

/// Sum of kernel times weight; `weights` as long as the columns.
PLATEN_VECTOR_CLONES [[gnu::flatten]] double weighted(const Process& p, const Place& place,
                                                      const double* weights) {
  using T = core::Lanes;
  const auto load = [](const double* from, T& x) { std::memcpy(&x, from, sizeof x); };
  T sum{}, x, w;
  for (std::size_t i = 0; i < place.length; i += Place::width) {
    T square{};
    for (std::size_t k = 0; k < p.w.size(); ++k) {
      load(&place.squares[k * place.length + i], x);
      square += p.w[k] * p.w[k] * x;
    }
    const T r = core::sqrt(square);
    load(&place.plane[i], x);
    load(weights + i, w);
    sum += w * ((1 + r + r * r / 3) * core::exp(-r) + p.plane * x);
  }
  double all = 0;
  for (std::size_t n = 0; n < Place::width; ++n) all += sum[n];
  return all;
}

} // namespace

std::vector<double> means(std::span<const Process> processes, const Inputs& inputs,
                          std::span<const double> at) {
  const Place place(inputs, at);
  std::vector<double> weights(place.length), result;
  for (const Process& p : processes) {
    std::copy(p.weights.begin(), p.weights.end(), weights.begin());
    result.push_back(p.variance * weighted(p, place, weights.data()));
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

double variance_at(const Process& p, const Inputs& inputs, std::span<const double> at) {
  const auto variance = [&](double explained) {
    return p.variance * std::max(0.0, 1 + p.plane * plane_product(at, at) - explained);
  };
  if (p.known && p.known->R.size() == 0) return variance(explained_by_known(p, inputs, at));
  std::size_t asked = 0;
  const Eigen::ArrayXd r = distances(p, inputs, at), all = kernels(p, inputs, at, r);
  auto order = nearest_first(r, asked);
  order.resize(asked);
  if (p.known) {
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> near;
    for (const auto& [distance, i] : order) near.push_back(i);
    return variance(p.known->near.explained(p.known->R, std::move(near), all));
  }
  std::vector<Eigen::Index> near;
  for (const auto& [distance, i] : order) near.push_back(static_cast<Eigen::Index>(i));
  std::sort(near.begin(), near.end());
  return variance(matrix_of(p, rows_at(inputs, near)).llt().matrixL().solve(VectorXd(all(near))).squaredNorm());
}

} // namespace platen::surrogate
