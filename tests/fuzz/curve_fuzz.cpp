#include "fuzz.hpp"

#include "press/curve_csv.hpp"

using namespace platen;

PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto curve = press::parse_curve(fuzz::text_of(data, size), "curve");
    (void)press::curve_csv(curve);
  });
}
