#include "fuzz.hpp"

#include "measure/specimen.hpp"
#include "measure/text.hpp"

using namespace platen;

PLATEN_FUZZ {
  return fuzz::allow_refusal(
      [&] { (void)measure::read_measurement(measure::decode(fuzz::text_of(data, size), "file")); });
}
