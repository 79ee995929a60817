// The loop over contacts that a C++ code would write, beside contacts.py: nanoseconds a contact.
//   bench_python_contacts LAW.toml RADIUS COUNT

#include "fit/law_card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <vector>

using namespace platen;

namespace {

/// The smallest of many times, of the processor: the machine may have other work.
template <class Work> double least_ns(std::size_t count, Work work) {
  double least = 1e300;
  for (int i = 0; i < 15; ++i) {
    const std::clock_t start = std::clock();
    work();
    const double took = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    least = std::min(least, took / static_cast<double>(count));
  }
  return least;
}

} // namespace

int main(int, char** argv) {
  const law::Law law = fit::make_law(fit::read_law_card(argv[1]), {{"radius_m", argv[2]}});
  const double end = 0.2 / law.scale.x_per_gamma;
  const auto count = static_cast<std::size_t>(std::atoll(argv[3]));
  std::vector<law::State> states(count);
  std::vector<double> overlap(count), force(count), stiffness(count), radius(count), pressure(count),
      work(count);
  std::vector<unsigned char> branch(count), in_range(count);
  std::uint64_t seed = 1;
  for (double& x : overlap) { // as contacts.py draws them
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    x = end * (static_cast<double>(seed >> 11) * 0x1p-53);
  }
  const law::TableView table = *law.table;
  fmt::print("{:.3f} ", least_ns(count, [&] {
               for (std::size_t i = 0; i < count; ++i) {
                 const auto now = law::evaluate(table, law.scale, states[i], overlap[i]);
                 states[i] = now.state;
                 force[i] = now.force;
               }
             }));
  fmt::print("{:.3f}\n", least_ns(count, [&] {
               for (std::size_t i = 0; i < count; ++i) {
                 const auto now = law::evaluate(table, law.scale, states[i], overlap[i]);
                 states[i] = now.state;
                 force[i] = now.force;
                 stiffness[i] = now.stiffness;
                 radius[i] = now.contact_radius;
                 pressure[i] = now.mean_pressure;
                 work[i] = now.dissipated_work;
                 branch[i] = static_cast<unsigned char>(now.branch);
                 in_range[i] = now.in_range;
               }
             }));
}
