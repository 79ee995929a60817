#include "fuzz.hpp"

#include "core/toml.hpp"
#include "study/card.hpp"

using namespace platen;

namespace {

/// Random designs take their time, and large ones much: that is no fault.
bool takes_long(const core::Table& card) {
  const auto* design = card.find("design");
  const auto* table = design ? std::get_if<core::Table>(&design->data) : nullptr;
  const auto* runs = table ? table->find("runs") : nullptr;
  const auto* number = runs ? std::get_if<std::int64_t>(&runs->data) : nullptr;
  return number && *number > 4;
}

} // namespace

PLATEN_FUZZ {
  return fuzz::allow_refusal([&] {
    const auto file = fuzz::file_of(data, size, ".toml");
    if (!takes_long(core::read_toml(file))) (void)study::read_study(file);
  });
}
