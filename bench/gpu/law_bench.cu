// What a contact costs on a GPU, and whether it gets the host's numbers: every law, its table made on the
// host and copied, 3e7 contacts that load, unload, reload and part. Ends with 1 where force, contact radius
// or memory is off by more than 1e-9.
//
//   law_bench [CONTACTS]

#define PLATEN_FUNCTION __host__ __device__ inline
#ifdef __clang__
#undef __noinline__ // CUDA's headers make a macro of what libstdc++ writes as __attribute__((__noinline__))
#endif
#include "../law_cases.hpp"
#include "path.hpp"
#include "platen/law/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <utility>

namespace {

using namespace platen;
using bench::Answer;
using bench::Laws;
using bench::Path;

constexpr double allowed = 1e-9;
constexpr std::uint32_t compared = 200'000, on_host = 500'000;

void check(cudaError_t status) {
  if (status == cudaSuccess) return;
  std::fprintf(stderr, "%s\n", cudaGetErrorString(status));
  std::exit(2);
}

/// Memory of the device.
template <class T> class Array {
 public:
  explicit Array(std::size_t n) { check(cudaMalloc(reinterpret_cast<void**>(&data_), n * sizeof(T))); }
  explicit Array(const std::vector<T>& host) : Array(host.size()) {
    check(cudaMemcpy(data_, host.data(), host.size() * sizeof(T), cudaMemcpyHostToDevice));
  }
  Array(Array&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}
  Array(const Array&) = delete;
  ~Array() { cudaFree(data_); }
  [[nodiscard]] T* data() const { return data_; }
  void read(std::vector<T>& host) const {
    check(cudaMemcpy(host.data(), data_, host.size() * sizeof(T), cudaMemcpyDeviceToHost));
  }

 private:
  T* data_ = nullptr;
};

template <class Body> __global__ void each(Body body, std::uint32_t n) {
  const std::uint32_t i = blockIdx.x * blockDim.x + threadIdx.x;
  if (i < n) body(i);
}

template <class Body> void run(const Body& body, std::uint32_t n) {
  each<<<(n + 255) / 256, 256>>>(body, n);
  check(cudaGetLastError());
}

/// Milliseconds.
template <class Body> double timed(const Body& body, std::uint32_t n) {
  cudaEvent_t begin, end;
  float ms = 0;
  check(cudaEventCreate(&begin));
  check(cudaEventCreate(&end));
  check(cudaEventRecord(begin));
  run(body, n);
  check(cudaEventRecord(end));
  check(cudaEventSynchronize(end));
  check(cudaEventElapsedTime(&ms, begin, end));
  check(cudaEventDestroy(begin));
  check(cudaEventDestroy(end));
  return ms;
}

/// A law as a kernel needs it: its table without ownership, and the size of the two bodies.
struct Prepared {
  law::TableView table;
  law::Scale scale;
};

/// One law for all contacts.
struct One {
  Prepared law;
  __device__ const Prepared& of(std::uint32_t) const { return law; }
};

/// Drawn at random: no two neighbours need have the same.
struct Drawn {
  const Prepared* laws;
  const std::uint8_t* kind;
  __device__ const Prepared& of(std::uint32_t i) const { return laws[kind[i % bench::sorts]]; }
};

struct Contacts {
  double* overlap;
  law::State* state;
  double *force, *radius;
};

struct SetOverlaps {
  Path path;
  int t;
  double* overlap;
  __device__ void operator()(std::uint32_t i) const { overlap[i] = path.overlap(i, t); }
};

template <class Pick> struct Step {
  Pick pick;
  Contacts at;
  __device__ void operator()(std::uint32_t i) const {
    const Prepared& law = pick.of(i);
    const law::Response now = law::evaluate(law.table, law.scale, at.state[i], at.overlap[i]);
    at.state[i] = now.state;
    at.force[i] = now.force;
    at.radius[i] = now.contact_radius;
  }
};

/// The same memory read and written, and no law.
struct Traffic {
  Contacts at;
  __device__ void operator()(std::uint32_t i) const {
    const law::State old = at.state[i];
    const double gamma = at.overlap[i];
    at.state[i] = {gamma, law::larger(gamma, old.gamma_max)};
    at.force[i] = gamma - old.gamma;
    at.radius[i] = gamma;
  }
};

/// Largest difference from the host over a sample; of force and radius relative to the contact's largest so
/// far.
struct Deviation {
  double force = 0, radius = 0, memory = 0;

  [[nodiscard]] double worst() const { return std::max({force, radius, memory}); }
};

double off(double ours, double host, double size) {
  if (ours == host) return 0;
  const double d = std::abs(ours - host) / std::abs(size);
  return d >= 0 ? d : std::numeric_limits<double>::infinity(); // no number
}

class Compared {
 public:
  Compared() : answer(compared), top_force(compared), top_radius(compared) {}

  void step(const Laws& laws, const Path& host_path, int t, const Array<law::State>& state,
            const Array<double>& force, const Array<double>& radius) {
    bench::host_step(laws, host_path, 0, t, answer);
    state.read(states), force.read(forces), radius.read(radii);
    for (std::size_t i = 0; i < compared; ++i) {
      const Answer& host = answer[i];
      top_force[i] = std::max(top_force[i], host.force);
      top_radius[i] = std::max(top_radius[i], host.radius);
      worst.force = std::max(worst.force, off(forces[i], host.force, top_force[i]));
      worst.radius = std::max(worst.radius, off(radii[i], host.radius, top_radius[i]));
      worst.memory = std::max({worst.memory, off(states[i].gamma, host.state.gamma, host.state.gamma),
                               off(states[i].gamma_max, host.state.gamma_max, host.state.gamma_max)});
      touching += host.force > 0;
    }
  }
  Deviation worst;
  double touching = 0;

 private:
  std::vector<Answer> answer;
  std::vector<double> top_force, top_radius, forces = std::vector<double>(compared), radii = forces;
  std::vector<law::State> states = std::vector<law::State>(compared);
};

/// Contacts on the device, and what measures with them.
class Bench {
 public:
  explicit Bench(std::uint32_t n) : n_(n), overlap(n), state(n), force(n), radius(n) {}

  /// [ns] of a contact and step.
  double traffic(const Path& path) {
    for (const bool warm : {true, false}) {
      (void)warm;
      ms_ = 0;
      for (int t = 0; t < bench::steps; ++t) {
        run(SetOverlaps{path, t, overlap.data()}, n_);
        ms_ += timed(Traffic{contacts()}, n_);
      }
    }
    return ns();
  }

  /// All steps once to compare, which warms up too, and once to time.
  template <class Pick>
  double law(const Pick& pick, const Laws& laws, const Path& path, const Path& host_path, Compared& compare) {
    for (const bool comparing : {true, false}) {
      check(cudaMemset(state.data(), 0, n_ * sizeof(law::State)));
      ms_ = 0;
      for (int t = 0; t < bench::steps; ++t) {
        run(SetOverlaps{path, t, overlap.data()}, n_);
        ms_ += timed(Step<Pick>{pick, contacts()}, n_);
        if (comparing) compare.step(laws, host_path, t, state, force, radius);
      }
    }
    return ns();
  }

 private:
  [[nodiscard]] Contacts contacts() const {
    return {overlap.data(), state.data(), force.data(), radius.data()};
  }
  [[nodiscard]] double ns() const { return ms_ * 1e6 / (double(n_) * bench::steps); }
  std::uint32_t n_;
  double ms_ = 0;
  Array<double> overlap;
  Array<law::State> state;
  Array<double> force, radius;
};

/// Tables on the device, for as long as this lives.
class OnDevice {
 public:
  explicit OnDevice(const Laws& laws) {
    for (const law::Law& law : laws.list) {
      Prepared one{*law.table, law.scale};
      one.table.cells = cells.emplace_back(law.table->cell_list).data();
      one.table.slot = slots.emplace_back(law.table->slot_list).data();
      list.push_back(one);
    }
  }
  std::vector<Prepared> list;

 private:
  std::vector<Array<law::Cell>> cells;
  std::vector<Array<std::uint16_t>> slots;
};

struct Named {
  std::string name;
  Laws laws;
  std::vector<double> size; ///< of each sort
};

law::Law made(const bench::LawCase& c, const std::string& radii) {
  return law::make_law(c.law, "", law::parameter_texts(radii + " " + c.parameters));
}

/// Log-uniform over the range of the law that each sort has.
Named named(std::string name, std::vector<law::Law> list, const std::vector<const bench::LawCase*>& from) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> u(0, 1);
  Named one{std::move(name), {std::move(list), std::vector<std::uint8_t>(bench::sorts)}, {}};
  for (std::uint32_t i = 0; i < bench::sorts; ++i) {
    const std::size_t k = random() % one.laws.list.size();
    one.laws.kind[i] = static_cast<std::uint8_t>(k);
    const bench::LawCase& c = *from[k];
    const double x = c.x_low * std::pow(c.x_high / c.x_low, u(random));
    one.size.push_back(x / 2.25 / one.laws.list[k].scale.x_per_gamma); // 2.25: the highest level
  }
  return one;
}

std::vector<Named> all_cases() {
  std::vector<Named> list;
  std::vector<law::Law> every;
  std::vector<const bench::LawCase*> from;
  for (const bench::LawCase& c : bench::law_cases) {
    list.push_back(named(c.name(), {made(c, "radius_m=1e-3")}, {&c}));
    every.push_back(made(c, "radius_m=1e-3 radius2_m=0.4e-3"));
    from.push_back(&c);
  }
  for (const char* law : {"hertz", "edmans-sinka", "pressed", "mdr"})
    for (std::size_t k = 0; k < from.size(); ++k)
      if (from[k]->law == std::string(law))
        list.push_back(named(law + std::string(", 1 : 0.4"), {every[k]}, {from[k]}));
  list.push_back(named("all, drawn", std::move(every), from));
  return list;
}

} // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::uint32_t>(argc > 1 ? std::atof(argv[1]) : 3e7);
  if (n < compared) return std::fprintf(stderr, "at least %u contacts\n", compared), 2;
  cudaDeviceProp device;
  int driver = 0;
  check(cudaGetDeviceProperties(&device, 0));
  check(cudaDriverGetVersion(&driver));
  const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::printf("# %s, CUDA %d.%d; host: %u threads; %u contacts, %d steps\n", device.name, driver / 1000,
              driver % 1000 / 10, threads, n, bench::steps);
  std::printf(
      "# ns of a contact and step; / hertz, / traffic: over the law hertz, over its memory read and written "
      "alone, on the GPU\n# off: force, radius (of the contact's largest so far) and memory, from the "
      "host's, "
      "largest of %u contacts\n",
      compared);
  std::printf("%-24s %8s %8s %9s %8s %9s %9s %7s %9s %9s %9s\n", "law", "GPU", "/ hertz", "/ traffic",
              "1 core", "all cores", "all/GPU", "touch", "force", "radius", "memory");
  Bench bench(n);
  double hertz = 0, traffic = 0;
  bool wrong = false;
  for (const Named& one : all_cases()) {
    const OnDevice device_laws(one.laws);
    const Array<double> sizes(one.size);
    const Path path{sizes.data()}, host_path{one.size.data()};
    Compared compare;
    double gpu = 0;
    if (one.laws.list.size() == 1) {
      gpu = bench.law(One{device_laws.list[0]}, one.laws, path, host_path, compare);
    } else {
      const Array<Prepared> laws(device_laws.list);
      const Array<std::uint8_t> kind(one.laws.kind);
      gpu = bench.law(Drawn{laws.data(), kind.data()}, one.laws, path, host_path, compare);
    }
    if (hertz == 0) {
      hertz = gpu, traffic = bench.traffic(path);
      std::printf("%-24s %8.4f\n", "traffic", traffic);
    }
    const double core = bench::host_time(one.laws, host_path, on_host, 1);
    const double all = bench::host_time(one.laws, host_path, on_host, threads);
    const Deviation& d = compare.worst;
    std::printf("%-24s %8.4f %8.2f %9.2f %8.2f %9.3f %9.0f %7.2f %9.1e %9.1e %9.1e\n", one.name.c_str(), gpu,
                gpu / hertz, gpu / traffic, core, all, all / gpu,
                compare.touching / (double(compared) * bench::steps), d.force, d.radius, d.memory);
    std::fflush(stdout);
    wrong |= !(d.worst() <= allowed);
  }
  if (wrong) std::printf("off by more than %.0e\n", allowed);
  return wrong ? 1 : 0;
}
