#include "fuzz.hpp"

#include "core/toml.hpp"
#include "press/case_card.hpp"

using namespace platen;

PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto one = press::read_case(core::parse_toml(fuzz::text_of(data, size), "card"));
    const std::string text = press::case_text(one);
    if (press::case_text(press::read_case(core::parse_toml(text, "again"))) != text) __builtin_trap();
  });
}
