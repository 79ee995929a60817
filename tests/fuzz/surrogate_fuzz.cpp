#include "fuzz.hpp"

#include "surrogate/surrogate.hpp"

using namespace platen;

PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto s = surrogate::read_surrogate(fuzz::file_of(data, size, ".txt"));
    (void)surrogate::text_of(s);
    const auto d = surrogate::describe(material::Elastic{1e9, 0.3});
    if (s.model == d.model && !s.guide) (void)surrogate::predict(s, d);
  });
}
