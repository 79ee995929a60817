// The table that runs (table.hpp) beside the formulas that it was made from, for every law of the list.

#include "platen/law/every_law.hpp"
#include "random_material.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

#if defined(__SANITIZE_ADDRESS__) || !defined(__OPTIMIZE__)
constexpr int share = 10; // enough for memory and undefined behaviour
#else
constexpr int share = 1;
#endif

double partner(double R, Random& random) {
  const double which = random.unit();
  return which < 0.5 ? R : which < 0.6 ? infinity : R * random.log_between(0.1, 10);
}

/// Nothing where there is no such material.
std::optional<Law> made(const LawChoice& one, double R, double R2, const TableAccuracy& accuracy = {}) {
  try {
    return make_law(one, R, one, R2, accuracy);
  } catch (const BadParameter&) { return {}; }
}

struct Worst {
  double force = 0, stiffness = 0, radius = 0, unloading = 0;
};

/// Largest deviations over random overlaps in the law's validity, and 0 is none.
template <class Formulas>
void compare(const Formulas& formulas, const Law& law, Random& random, Worst& worst) {
  const double end = std::min(law.table->valid[0][1], 1.0);
  for (int k = 0; k < 50; ++k) {
    const double x = end * random.log_between(1e-5, 1), gamma = x / law.scale.x_per_gamma;
    if (!law.table->in_range(x)) continue;
    const Response fast = evaluate(law, State{}, gamma), exact = evaluate(formulas, State{}, gamma);
    const auto note = [&](double& most, double a, double b, double of) {
      most = std::max(most, std::abs(a - b) / of);
    };
    note(worst.force, fast.force, exact.force, exact.force);
    note(worst.stiffness, fast.stiffness, exact.stiffness, exact.stiffness);
    note(worst.radius, fast.contact_radius, exact.contact_radius, exact.contact_radius);
    const double back = gamma * random.unit();
    note(worst.unloading, evaluate(law, fast.state, back).force, evaluate(formulas, exact.state, back).force,
         exact.force);
  }
}

template <class Material> void follows_its_formulas() {
  const LawInfo& info = find_law(Material::info().name);
  Random random;
  Worst worst;
  int count = 0;
  for (int i = 0; i < 2000 / share; ++i) { // 10^5 materials and overlaps
    const LawChoice one = random_material(info, random);
    const double R = random.log_between(1e-5, 1e-1), R2 = partner(R, random);
    const Material m = Material::read(one.reader());
    Worst here;
    try {
      const auto formulas = prepare(m, R, m, R2);
      compare(formulas, tabulate(formulas), random, here);
    } catch (const BadParameter&) { continue; } // no such material
    ++count;
    EXPECT_LE(here.force, 1e-4) << text_of(one) << " R " << R << " R2 " << R2;
    EXPECT_LE(here.unloading, 1e-4) << text_of(one) << " R " << R << " R2 " << R2;
    EXPECT_LE(here.stiffness, 1e-3) << text_of(one) << " R " << R << " R2 " << R2;
    EXPECT_LE(here.radius, 1e-3) << text_of(one) << " R " << R << " R2 " << R2;
    for (double Worst::*w : {&Worst::force, &Worst::stiffness, &Worst::radius, &Worst::unloading})
      worst.*w = std::max(worst.*w, here.*w);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(count, 1200 / share) << info.name; // nearly all that are drawn exist
  std::printf("%-18s %4d materials: force %.1e, unloading %.1e, stiffness %.1e, radius %.1e\n",
              info.name.c_str(), count, worst.force, worst.unloading, worst.stiffness, worst.radius);
}

TEST(Table, FollowsTheFormulasOfEveryLaw) {
  [&]<class... Material>(std::type_identity<std::tuple<Material...>>) {
    (follows_its_formulas<Material>(), ...);
  }(std::type_identity<LawTypes>{});
}

/// Where a published form is kept although it creates energy, its law says that it is not in range.
bool may_create_energy(const LawChoice& one) {
  return one.variant == "published" &&
         (one.name == "wang" || one.name == "etsion-unloading" || one.name == "mdr" ||
          one.name == "kogut-etsion" || one.name == "jackson-green");
}

/// Up and down four times.
void expect_sound_path(const Law& law, double scale, Random& random) {
  State state;
  double at = 0;
  for (int turn = 0; turn < 4; ++turn) {
    const double to = turn == 3 ? 0 : scale * random.log_between(1e-4, 1) * (turn % 2 ? random.unit() : 1);
    constexpr int steps = 16;
    const double from = at;
    for (int k = 1; k <= steps; ++k) {
      const double gamma = from + (to - from) * k / steps;
      const Response now = evaluate(law, state, gamma);
      ASSERT_TRUE(std::isfinite(now.force) && now.force >= 0 && std::isfinite(now.stiffness) &&
                  now.stiffness >= 0);
      ASSERT_LE(now.force, evaluate(law, State{}, gamma).force * (1 + 1e-9))
          << gamma << " from " << state.gamma_max;
      at = gamma, state = now.state;
    }
  }
  // Lost work grows with the largest overlap, and is less than the work of loading.
  const double top = state.gamma_max, more = top * (1 + 0.3 * random.unit());
  const double lost = evaluate(law, State{}, top).dissipated_work, W = loading_work(law, top);
  ASSERT_GE(lost, 0);
  ASSERT_LE(lost, W * (1 + 1e-12));
  ASSERT_GE(evaluate(law, State{}, more).dissipated_work, lost - 1e-9 * W) << top << " to " << more;
}

TEST(Table, NeverCreatesEnergyOrFallsBelowZero) {
  Random random;
  for (const LawInfo& info : laws())
    for (int i = 0; i < 400 / share; ++i) {
      const LawChoice one = random_material(info, random);
      const double R = random.log_between(1e-5, 1e-1), R2 = partner(R, random);
      const auto law = made(one, R, R2, i % 2 ? coarse_table : TableAccuracy{});
      if (!law || may_create_energy(one)) continue;
      for (int path = 0; path < 25; ++path)
        expect_sound_path(*law, std::min(1.0, law->table->valid[0][1]) / law->scale.x_per_gamma, random);
      ASSERT_FALSE(HasFailure()) << text_of(one) << " R " << R << " R2 " << R2;
    }
}

TEST(Table, OfUnlikeBodiesFollowsTheirRule) { // docs/laws/index.md
  Random random;
  Worst worst;
  for (int i = 0; i < 200 / share; ++i) {
    const LawChoice one = random_material(find_law("pressed"), random),
                    two = random_material(find_law("pressed"), random);
    const Law law = make_law(one, 1e-3, two, 1e-3 * (i % 2 ? 1 : random.log_between(0.2, 5)), joined_table);
    const double end = std::min(law.table->valid[0][1], 1.0);
    for (int k = 0; k < 50; ++k) {
      const double x = end * random.log_between(1e-5, 1), gamma = x / law.scale.x_per_gamma;
      const Response fast = evaluate(law, State{}, gamma), exact = law.formulas(State{}, gamma);
      worst.force = std::max(worst.force, std::abs(fast.force / exact.force - 1));
      worst.stiffness = std::max(worst.stiffness, std::abs(fast.stiffness / exact.stiffness - 1));
    }
  }
  std::printf("unlike bodies: force %.1e, stiffness %.1e\n", worst.force, worst.stiffness);
  EXPECT_LE(worst.force, 2e-3);
  EXPECT_LE(worst.stiffness, 6e-2);
}

TEST(Table, OfUnlikeBodiesNeverCreatesEnergyEither) { // coarse, as a DEM code makes it
  Random random;
  for (int i = 0; i < 300 / share; ++i) {
    const LawInfo& info = find_law(i % 3 ? "pressed" : "edmans-sinka");
    const LawChoice one = random_material(info, random), two = random_material(find_law("pressed"), random);
    const Law law = make_law(one, 1e-3, two, 1e-3 * (i % 2 ? 1 : random.log_between(0.2, 5)), joined_table);
    for (int path = 0; path < 50; ++path)
      expect_sound_path(law, std::min(1.0, law.table->valid[0][1]) / law.scale.x_per_gamma, random);
    ASSERT_FALSE(HasFailure()) << text_of(one) << '\n' << text_of(two);
  }
}

/// Loading and back by midpoints in sqrt(overlap), where the force is smooth at both ends.
TEST(Table, SaysHowMuchWorkIsLost) {
  Random random;
  for (const LawInfo& info : laws())
    for (int i = 0; i < 100 / share; ++i) {
      const LawChoice one = random_material(info, random);
      const auto law = made(one, 1e-3, 1e-3);
      if (!law || may_create_energy(one)) continue;
      const double top =
          std::min(0.5, law->table->valid[0][1]) * random.log_between(1e-2, 1) / law->scale.x_per_gamma;
      const State state = evaluate(*law, State{}, top).state;
      double up = 0, down = 0;
      constexpr int n = 4000;
      for (int k = 0; k < n; ++k) {
        const double v = (k + 0.5) / n, width = top * 2 * v / n;
        up += evaluate(*law, State{}, top * v * v).force * width;
        down += evaluate(*law, state, top * (1 - v * v)).force * width;
      }
      EXPECT_NEAR(up, loading_work(*law, top), 1e-3 * up) << text_of(one) << " top " << top;
      EXPECT_NEAR(up - down, evaluate(*law, state, top).dissipated_work, 1e-3 * up)
          << text_of(one) << " top " << top;
    }
}

TEST(Table, APartedContactHasNoForceRadiusPressureOrStiffness) {
  Random random;
  for (const LawInfo& info : laws()) {
    int parted = 0;
    for (int i = 0; i < 40; ++i) {
      const LawChoice one = random_material(info, random);
      const auto law = made(one, 1e-3, 1e-3);
      if (!law) continue;
      const double top =
          std::min(0.3, law->table->valid[0][1]) * random.log_between(1e-2, 1) / law->scale.x_per_gamma;
      const State state = evaluate(*law, State{}, top).state;
      for (const double part : {0.9, 0.5, 0.1, 1e-3, 0.0, -1.0}) {
        const Response now = evaluate(*law, state, part * top);
        if (now.branch != Branch::separated) continue;
        ++parted;
        EXPECT_EQ(now.force, 0) << text_of(one);
        EXPECT_EQ(now.contact_radius, 0) << text_of(one);
        EXPECT_EQ(now.mean_pressure, 0) << text_of(one);
        EXPECT_EQ(now.stiffness, 0) << text_of(one);
      }
    }
    EXPECT_GT(parted, 0) << info.name;
  }
}

TEST(Table, OfAnOverlapOrAMemoryThatIsNoneAnswersSoAndKeepsItsMemory) {
  Random random;
  for (const LawInfo& info : laws()) {
    std::optional<Law> law;
    while (!law) {
      const LawChoice one = random_material(info, random);
      law = made(one, 1e-3, 1e-3);
    }
    const State before = evaluate(*law, State{}, 1e-5).state;
    const Response lost = evaluate(*law, before, std::nan(""));
    EXPECT_TRUE(std::isnan(lost.force)) << info.name;
    EXPECT_FALSE(lost.in_range);
    EXPECT_EQ(lost.state.gamma_max, before.gamma_max);
    EXPECT_EQ(evaluate(*law, lost.state, 1e-5).force, evaluate(*law, before, 1e-5).force);
    for (const double top : {infinity, 1e305, std::nan(""), -1e-5}) // read from a file of who knows what
      for (const double overlap : {-1e-5, 1e-5, 1e3}) {
        const Response now = evaluate(*law, State{0, top}, overlap);
        EXPECT_TRUE(std::isnan(now.force) && !now.in_range) << info.name << ' ' << top << ' ' << overlap;
      }
  }
}

TEST(Table, IsSmall) {
  Random random;
  for (const LawInfo& info : laws()) {
    std::vector<double> sizes;
    for (int i = 0; i < 100; ++i) {
      const LawChoice one = random_material(info, random);
      if (const auto law = made(one, 1e-3, 1e-3)) sizes.push_back(static_cast<double>(law->table->bytes()));
    }
    std::sort(sizes.begin(), sizes.end());
    std::printf("%-18s %5.1f kB, at most %5.1f\n", info.name.c_str(), sizes[sizes.size() / 2] / 1e3,
                sizes.back() / 1e3);
    EXPECT_LE(sizes[sizes.size() / 2], 60'000) << info.name;
    EXPECT_LE(sizes.back(), 100'000) << info.name;
  }
}

} // namespace
