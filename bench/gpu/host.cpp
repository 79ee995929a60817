// The host's side of the bench, by the compiler that programs without a GPU use.
#include "path.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

namespace platen::bench {

void host_step(const Laws& laws, const Path& path, std::uint32_t first, int t,
               std::vector<Answer>& contacts) {
  for (std::uint32_t i = 0; i < contacts.size(); ++i) {
    const law::Response now =
        law::evaluate(laws.of(first + i), contacts[i].state, path.overlap(first + i, t));
    contacts[i] = {now.state, now.force, now.contact_radius};
  }
}

namespace {

/// Seconds that the law takes; overlaps are made between the steps, as on the GPU.
double one_thread(const Laws& laws, const Path& path, std::uint32_t first, std::uint32_t count) {
  std::vector<law::State> state(count);
  std::vector<double> overlap(count), force(count), radius(count);
  std::chrono::duration<double> spent{};
  const law::Law* one = laws.list.size() == 1 ? laws.list.data() : nullptr;
  for (int t = 0; t < steps; ++t) {
    for (std::uint32_t i = 0; i < count; ++i) overlap[i] = path.overlap(first + i, t);
    const auto begin = std::chrono::steady_clock::now();
    for (std::uint32_t i = 0; i < count; ++i) {
      const law::Response now = law::evaluate(one ? *one : laws.of(first + i), state[i], overlap[i]);
      state[i] = now.state;
      force[i] = now.force;
      radius[i] = now.contact_radius;
    }
    spent += std::chrono::steady_clock::now() - begin;
  }
  return spent.count();
}

} // namespace

double host_time(const Laws& laws, const Path& path, std::uint32_t each, unsigned threads) {
  std::vector<double> spent(threads);
  std::vector<std::thread> running;
  for (unsigned k = 0; k < threads; ++k)
    running.emplace_back([&, k] { spent[k] = one_thread(laws, path, k * each, each); });
  for (std::thread& thread : running) thread.join();
  return *std::max_element(spent.begin(), spent.end()) * 1e9 / (double(steps) * each * threads);
}

} // namespace platen::bench
