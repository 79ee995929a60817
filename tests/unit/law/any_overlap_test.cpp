// Every law answers every finite overlap with finite numbers and a force that never falls as overlap grows.

#include "platen/law/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace platen::law;

struct Named {
  const char* name;
  const char* variant;
  const char* parameters;
};

constexpr const char* body = "radius_m=1e-3 E_Pa=5e8 nu=0.3 ";
const Named every_law[] = {
    {"hertz", "", ""},
    {"similarity", "published", "kappa_Pa=1e7 inverse_m=0.3"},
    {"similarity", "curvature-corrected", "kappa_Pa=1e7 inverse_m=0.3"},
    {"edmans-sinka", "published", "sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5"},
    {"edmans-sinka", "c1", "sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5"},
    {"edmans-sinka", "hertz-like", "sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5"},
    {"edmans-sinka", "published",
     "sigma_ref_Pa=8.61e6 k=4.2 delta_t=0.09 a=3.5 unload_delta_bar=0.1,0.3 alpha=1.4,1.2 beta=1.3,1.6"},
    {"wang", "generic", "phi_deg=25 sigma_c_Pa=15e6"},
    {"wang", "fitted", "phi_deg=25 sigma_c_Pa=15e6 a=1.06 b=1.42 m=1.2 n=1.47"},
    {"agarwal", "", "sigma_y_Pa=1e6"},
    {"agarwal", "published", "sigma_y_Pa=1e6 loading=die"},
    {"agarwal", "", "sigma_y_Pa=1e6 loading=hydrostatic"},
    {"shahin", "", "kappa_Pa=1e6 inverse_m=0.3"},
    {"shahin", "", "kappa_Pa=1e6 inverse_m=0.3 loading=die"},
    {"shahin", "", "kappa_Pa=1e6 inverse_m=1 loading=hydrostatic"},
    {"thornton-ning", "", "p_y_Pa=1.6e6"},
    {"kogut-etsion", "joined", "sigma_y_Pa=1e6"},
    {"kogut-etsion", "published", "sigma_y_Pa=1e6"},
    {"kogut-etsion", "published", "sigma_y_Pa=1e6 nu=0.49"},
    {"etsion-unloading", "joined", "sigma_y_Pa=1e6"},
    {"etsion-unloading", "published", "sigma_y_Pa=1e6"},
    {"jackson-green", "joined", "sigma_y_Pa=1e6"},
    {"jackson-green", "published", "sigma_y_Pa=1e6"},
    {"jackson-green", "published", "sigma_y_Pa=1e6 nu=0.49"},
    {"mdr", "stiffened", "sigma_y_Pa=1e6"},
    {"mdr", "published", "sigma_y_Pa=1e6"},
    {"luding", "", "radius_m=1e-3 k_1_N_per_m=1e5 k_2_N_per_m=5e5 phi_f=0.1"},
    {"eepa", "", "lambda_p=0.6"},
    {"eepa", "", "lambda_p=0.9 n=1"},
};

Law make(const Named& n) {
  const std::string_view own = n.parameters;
  if (own.starts_with("radius_m")) return make_law(n.name, n.variant, parameter_texts(own));
  const std::string_view shared = own.find("nu=") == own.npos ? body : "radius_m=1e-3 E_Pa=5e8 ";
  return make_law(n.name, n.variant, parameter_texts(std::string(shared) + n.parameters));
}

/// Negative, zero, denormal, and 2000 overlaps from the smallest number to 1e300.
std::vector<double> all_overlaps() {
  std::vector<double> overlaps{-1e300, -1.0, -1e-300, -0.0, 0.0, std::numeric_limits<double>::denorm_min()};
  for (int i = 0; i <= 2000; ++i) overlaps.push_back(std::pow(10.0, -323 + i * (623.0 / 2000)));
  for (double x = 1e-6; x < 3; x *= 1.003) overlaps.push_back(2e-3 * x); // closer where the law is made for
  std::sort(overlaps.begin(), overlaps.end());
  return overlaps;
}

void expect_finite(const Response& r) {
  EXPECT_TRUE(std::isfinite(r.force) && r.force >= 0);
  EXPECT_TRUE(std::isfinite(r.stiffness) && r.stiffness >= 0);
  EXPECT_TRUE(std::isfinite(r.contact_radius) && std::isfinite(r.mean_pressure));
  EXPECT_TRUE(std::isfinite(r.dissipated_work));
}

TEST(AnyOverlap, ForceNeverFallsAsTheOverlapGrows) {
  for (const Named& n : every_law) {
    const Law law = make(n);
    double last = 0;
    for (double gamma : all_overlaps()) {
      const Response r = evaluate(law, State{}, gamma);
      expect_finite(r);
      EXPECT_GE(r.force, last) << n.name << ' ' << n.variant << ' ' << n.parameters << ' ' << gamma;
      if (gamma <= 0) { EXPECT_EQ(r.force, 0); }
      last = r.force;
      if (HasFailure()) return;
    }
    EXPECT_GT(last, 0);
    EXPECT_FALSE(evaluate(law, State{}, 1e300).in_range);
  }
}

TEST(AnyOverlap, UnloadingFromAnywhereToAnywhereIsFinite) {
  const double far[] = {-1e300, -1e-3, 0.0, 5e-324, 1e-310, 1e-200, 1e-12, 1e-5, 3e-4, 1e-3, 1.0, 1e300};
  for (const Named& n : every_law) {
    const Law law = make(n);
    for (double top : far) {
      const State state = evaluate(law, State{}, top).state;
      double last = 0;
      for (double gamma : far) {
        if (gamma > top) break;
        const Response r = evaluate(law, state, gamma);
        expect_finite(r);
        EXPECT_GE(r.force, last) << n.name << ' ' << n.variant << ' ' << top << ' ' << gamma;
        last = r.force;
        if (HasFailure()) return;
      }
    }
  }
}

} // namespace
