// Many contacts at once (batch.hpp) beside one by one.

#include "platen/law/batch.hpp"
#include "platen/law/catalogue.hpp"
#include "random_material.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace {

using namespace platen::law;
using namespace platen::law::testing;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Asked {
  const Law* law = nullptr;
  double gamma_max = 0, overlap = 0;
};

/// Loading, unloading, apart, and what nobody should ask for.
Asked random_contact(const Law& law, Random& random) {
  const double end = std::min(law.table->valid[0][1], 1.0) / law.scale.x_per_gamma;
  const double top = end * random.log_between(1e-6, 2), which = random.unit();
  if (which < 0.4) return {&law, top, top * random.unit()};
  if (which < 0.8) return {&law, top * random.unit(), top};
  const double odd[] = {0, -top, none, 1e300, std::numeric_limits<double>::infinity(), 1e-320};
  const auto one_of = [&] { return odd[static_cast<int>(random.unit() * 6)]; };
  return {&law, which < 0.9 ? top : one_of(), one_of()};
}

/// As near as the powers of both are right, over what the number is where the loading curve was left, and as
/// a last bit of the overlap moves it, which is much where the force ends.
void expect_near(double fast, double Response::*what, const Response& now, const Response& top,
                 const Response& before, const Response& after, const char* name) {
  const double exact = now.*what;
  if (std::isnan(exact)) {
    EXPECT_TRUE(std::isnan(fast)) << name;
  } else if (fast != exact) {
    const double bit = std::abs(before.*what - now.*what) + std::abs(after.*what - now.*what);
    EXPECT_NEAR(fast, exact, 1e-11 * std::max(std::abs(top.*what), std::abs(exact)) + bit) << name;
  }
}

using Way = void(Batch&, int);

template <Want want> void expect_as_one_by_one(const std::vector<Asked>& asked, Way* way) {
  static Batch b;
  const int count = static_cast<int>(asked.size());
  for (int c = 0; c < count; ++c) {
    const Asked& a = asked[static_cast<std::size_t>(c)];
    b.law(c, *a.law->table, a.law->scale);
    b.gamma_max[c] = a.gamma_max, b.overlap[c] = a.overlap;
  }
  way(b, count);
  for (int c = 0; c < count; ++c) {
    const auto& [law, gamma_max, overlap] = asked[static_cast<std::size_t>(c)];
    SCOPED_TRACE(::testing::Message()
                 << "contact " << c << " of " << count << ", " << overlap << " of " << gamma_max);
    const State old{0, gamma_max};
    const Response now = evaluate(*law, old, overlap), top = evaluate(*law, State{}, now.state.gamma_max);
    const double bit = 4e-16 * now.state.gamma_max;
    const Response before = evaluate(*law, old, overlap - bit), after = evaluate(*law, old, overlap + bit);
    const auto expect = [&](double fast, double Response::*what, const char* name) {
      expect_near(fast, what, now, top, before, after, name);
    };
    EXPECT_TRUE(b.gamma_max[c] == now.state.gamma_max || std::isnan(now.state.gamma_max));
    expect(b.force[c], &Response::force, "force");
    if (want == Want::force) continue;
    if (overlap < gamma_max || gamma_max < overlap) // else a last bit decides between loading and unloading
      expect(b.stiffness[c], &Response::stiffness, "stiffness");
    expect(b.contact_radius[c], &Response::contact_radius, "radius");
    if (want == Want::contact) continue;
    expect(b.mean_pressure[c], &Response::mean_pressure, "pressure");
    expect(b.dissipated_work[c], &Response::dissipated_work, "lost work");
    EXPECT_EQ(b.in_range[c], now.in_range);
  }
}

/// By the way of this processor, and of those before it.
template <Want want> void expect_as_one_by_one(const std::vector<Asked>& asked) {
  expect_as_one_by_one<want>(asked, evaluate<want>);
#ifdef PLATEN_BATCH_VECTORS
  if (__builtin_cpu_supports("x86-64-v3")) expect_as_one_by_one<want>(asked, detail::evaluate_by_four<want>);
#endif
  expect_as_one_by_one<want>(asked, detail::evaluate_in_turn);
}

void expect_as_one_by_one(const std::vector<Asked>& asked) {
  expect_as_one_by_one<Want::force>(asked);
  expect_as_one_by_one<Want::contact>(asked);
  expect_as_one_by_one<Want::everything>(asked);
}

/// Of random materials and radii.
std::vector<Law> some_laws(const LawInfo& info, int count, Random& random) {
  std::vector<Law> made;
  while (static_cast<int>(made.size()) < count) try {
      const LawChoice one = random_material(info, random);
      const double R = random.log_between(1e-5, 1e-1);
      made.push_back(make_law(one, R, one, random.unit() < 0.5 ? R : R * random.log_between(0.1, 10)));
    } catch (const BadParameter&) {} // no such material
  return made;
}

TEST(Batch, OfEveryLawIsAsOneByOne) {
  Random random;
  for (const LawInfo& info : laws()) {
    SCOPED_TRACE(info.name);
    for (const Law& law : some_laws(info, 20, random)) {
      std::vector<Asked> asked(static_cast<std::size_t>(1 + random.unit() * Batch::size));
      for (Asked& a : asked) a = random_contact(law, random);
      expect_as_one_by_one(asked);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(Batch, MayMixLaws) {
  Random random;
  std::vector<Law> made;
  for (const LawInfo& info : laws())
    for (Law& law : some_laws(info, 3, random)) made.push_back(std::move(law));
  for (int i = 0; i < 300; ++i) {
    std::vector<Asked> asked(static_cast<std::size_t>(random.unit() * (Batch::size + 1)));
    for (Asked& a : asked)
      a = random_contact(made[static_cast<std::size_t>(random.unit() * static_cast<double>(made.size()))],
                         random);
    expect_as_one_by_one(asked);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Batch, KeepsLawsBeyondWhatIsAsked) {
  const Law law = make_law("hertz", "", parameter_texts("radius_m=1e-3 E_Pa=1e9 nu=0.3"));
  Batch b;
  const auto forces = [&](int count) {
    for (int c = 0; c < Batch::size; ++c) b.overlap[c] = 1e-6 * (c + 1), b.gamma_max[c] = 0;
    evaluate<Want::force>(b, count);
    return std::vector<double>(b.force, b.force + Batch::size);
  };
  for (int c = 0; c < Batch::size; ++c) b.law(c, *law.table, law.scale);
  const auto all = forces(Batch::size);
  (void)forces(3);
  EXPECT_EQ(forces(Batch::size), all);
  EXPECT_GT(all.back(), 0);
}

} // namespace
