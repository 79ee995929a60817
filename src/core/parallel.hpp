#pragma once
// Many small computations that do not know of each other.

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace platen::core {

/// One at least.
inline int processors() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

/// f(0) to f(n - 1), on all processors where they are many. Throws what the first that failed threw.
template <class F> void in_parallel(std::size_t n, const F& f) {
  constexpr std::size_t few = 1000, threads_max = 8;
  const std::size_t threads = n < few ? 1 : std::min(static_cast<std::size_t>(processors()), threads_max);
  std::vector<std::future<void>> parts;
  for (std::size_t t = 0; t < threads; ++t)
    parts.push_back(
        std::async(threads == 1 ? std::launch::deferred : std::launch::async, [&f, n, t, threads] {
          for (std::size_t i = n * t / threads; i < n * (t + 1) / threads; ++i) f(i);
        }));
  for (auto& part : parts) part.get();
}

} // namespace platen::core
