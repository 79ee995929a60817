// Spheres in blocks beside the same spheres one by one, in words of their own.

#include "dem/contact_block.hpp"

#include "../law/random_material.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace platen::dem {
namespace {

using namespace law;
using namespace law::testing;
using fit::LawCard;

Laws random_laws(const char* name, Random& random, double restitution, double friction, const Units& units) {
  const LawChoice one = random_material(find_law(name), random);
  const LawCard card{name, name, one.variant, one.parameters, {}, {}, {}};
  return {{card, card, false, restitution, friction}, 0, units};
}

Vec any(Random& random, double size) {
  const auto number = [&] { return size * (2 * random.unit() - 1); };
  return {number(), number(), number()};
}

struct Touching {
  double R[2], mass;
  Vec apart, velocity, spin;
  Memory memory;
};

/// Overlaps up to a tenth of the radii, some contacts loading, some unloading, some about to part.
Touching random_contact(const Laws& laws, Random& random, bool alike) {
  Touching c{};
  c.R[0] = random.log_between(0.5, 2), c.R[1] = alike ? c.R[0] : random.log_between(0.5, 2);
  const double reach = c.R[0] + c.R[1], overlap = reach * random.log_between(1e-4, 0.1);
  const Vec d = any(random, 1);
  c.apart = (reach - overlap) / std::sqrt(dot(d, d)) * d;
  c.velocity = any(random, 100), c.spin = any(random, 100), c.mass = random.log_between(1e-6, 1e-5);
  c.memory.gamma_max = overlap * random.log_between(0.5, 2) * 1e-3;
  c.memory.k_t = laws.shear * random.log_between(1e-3, 1) * 1e-3;
  c.memory.tangential = any(random, c.memory.k_t * overlap);
  return c;
}

struct Answer {
  double normal, limit;
  Vec push, turn;
  Memory memory;
};

/// Sqrt, if and else.
Answer one_by_one(Laws& laws, const Touching& c, const Units& u, double dt) {
  Answer a{};
  const double d = std::sqrt(dot(c.apart, c.apart)), reach = c.R[0] + c.R[1];
  const Response now = respond(laws.at(c.R[0], c.R[1]), c.memory.gamma_max, (reach - d) * u.length);
  const std::array<double, 3> n = {c.apart.x / d, c.apart.y / d, c.apart.z / d};
  const std::array<double, 3> v = {c.velocity.x, c.velocity.y, c.velocity.z};
  const std::array<double, 3> w = {c.spin.x * d / reach, c.spin.y * d / reach, c.spin.z * d / reach};
  const double v_n = v[0] * n[0] + v[1] * n[1] + v[2] * n[2];
  double F = now.force / u.force;
  if (F > 0) {
    F -= laws.damping * std::sqrt(now.stiffness * u.length / u.force * c.mass) * v_n;
    if (F < 0) F = 0;
  }
  const double k_t = laws.shear * now.contact_radius;
  std::array<double, 3> s = {c.memory.tangential.x, c.memory.tangential.y, c.memory.tangential.z};
  if (dt > 0) {
    const double along = s[0] * n[0] + s[1] * n[1] + s[2] * n[2];
    const double keep = k_t < c.memory.k_t ? k_t / c.memory.k_t : 1;
    double size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t p = (k + 1) % 3, q = (k + 2) % 3;
      const double slip = v[k] - v_n * n[k] + n[p] * w[q] - n[q] * w[p];
      s[k] = (s[k] - along * n[k]) * keep - k_t * dt * slip;
      size += s[k] * s[k];
    }
    size = std::sqrt(size);
    if (const double limit = laws.contact.friction * F; size > limit)
      for (double& part : s) part *= limit / size;
  }
  a.normal = F;
  a.push = {F * n[0] + s[0], F * n[1] + s[1], F * n[2] + s[2]};
  a.turn = d / reach * cross({n[0], n[1], n[2]}, {s[0], s[1], s[2]});
  a.memory = {now.state.gamma_max, {s[0], s[1], s[2]}, dt > 0 ? k_t : c.memory.k_t};
  return a;
}

void expect_near(const Vec& a, const Vec& b, double size, const char* what) {
  EXPECT_NEAR(a.x, b.x, 1e-9 * size) << what;
  EXPECT_NEAR(a.y, b.y, 1e-9 * size) << what;
  EXPECT_NEAR(a.z, b.z, 1e-9 * size) << what;
}

TEST(ContactBlock, IsAsOneByOne) {
  Random random;
  const Units units{1e-3, 1};
  static Block b;
  int slipped = 0, stuck = 0;
  for (const double dt : {1e-6, 0.0})
    for (const bool alike : {true, false})
      for (int round = 0; round < 5; ++round) {
        std::vector<Laws> laws; // of spheres of any radii, of a force that goes with another power, mixed
        for (const char* name : {"hertz", "agarwal", "mdr", "edmans-sinka", "luding"})
          laws.push_back(random_laws(name, random, 0.5, name == std::string("luding") ? 0 : 0.3, units));
        if (round % 2 == 1) laws.pop_back();
        std::array<Touching, Block::size> asked;
        std::array<Memory, Block::size> memory;
        b.count = round == 0 ? 5 : Block::size;
        for (int c = 0; c < b.count; ++c) {
          const auto at = static_cast<std::size_t>(c);
          Laws& of = laws[at % laws.size()];
          asked[at] = random_contact(of, random, alike), memory[at] = asked[at].memory;
          b.laws[c] = &of, b.memory[c] = &memory[at];
          b.R1[c] = asked[at].R[0], b.R2[c] = asked[at].R[1], b.mass[c] = asked[at].mass;
          b.distance2[c] = dot(asked[at].apart, asked[at].apart), b.apart.set(c, asked[at].apart);
          b.velocity.set(c, asked[at].velocity), b.spin.set(c, asked[at].spin);
        }
        normal_forces<Want::contact>(b, units, [](int) {});
        step<true, true>(b, units, dt);
        for (int c = 0; c < b.count; ++c) {
          const auto at = static_cast<std::size_t>(c);
          const Answer a = one_by_one(*b.laws[c], asked[at], units, dt);
          const Vec& s = a.memory.tangential;
          const double size = a.normal + std::sqrt(dot(s, s)), limit = b.laws[c]->contact.friction * a.normal;
          expect_near(b.push[c], a.push, size, "force");
          expect_near(b.turn[c], a.turn, size, "torque");
          expect_near(memory[at].tangential, s, size, "memory");
          EXPECT_EQ(memory[at].gamma_max, a.memory.gamma_max);
          EXPECT_NEAR(memory[at].k_t, a.memory.k_t, 1e-9 * a.memory.k_t);
          (dot(s, s) < 0.999 * limit * limit ? stuck : slipped)++;
        }
      }
  EXPECT_GT(slipped, 50); // else a way was not tried
  EXPECT_GT(stuck, 50);
}

TEST(ContactBlock, TellsOnceWhenAContactLeavesWhatItsCardCovers) {
  Random random;
  Laws laws = random_laws("hertz", random, 1, 0, {});
  laws.x_valid = 0.01; // as a card says
  static Block b;
  Memory memory{};
  const double R = 1e-3;
  std::vector<double> told;
  for (const double x : {0.005, 0.009, 0.011, 0.02, 0.009, 0.03}) {
    const double d = 2 * R * (1 - x);
    b.count = 1, b.laws[0] = &laws, b.memory[0] = &memory;
    b.R1[0] = b.R2[0] = R, b.distance2[0] = d * d, b.apart.set(0, {d, 0, 0});
    normal_forces<Want::force>(b, {}, [&](int) { told.push_back(x); });
  }
  EXPECT_EQ(told, std::vector<double>{0.011});
}

} // namespace
} // namespace platen::dem
