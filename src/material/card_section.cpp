#include "material/card_section.hpp"

#include <fmt/format.h>

namespace platen::material {

std::string card_lines(const std::vector<CardEntry>& entries) {
  std::string lines, inner, section;
  for (const auto& [key, value, meaning] : entries) {
    const auto dot = key.find('.');
    if (dot == std::string::npos) lines += core::card_line(key, value);
    else {
      const std::string line = core::card_line(key.substr(dot + 1), value);
      inner += (inner.empty() ? "" : ", ") + line.substr(0, line.size() - 1);
      section = key.substr(0, dot);
    }
  }
  return inner.empty() ? lines : lines + fmt::format("{} = {{ {} }}\n", section, inner);
}

std::vector<Parameter> parameters(const std::vector<CardEntry>& entries) {
  std::vector<Parameter> list;
  for (const auto& [key, value, meaning] : entries) {
    if (const auto* number = std::get_if<double>(&value))
      list.push_back({key, *number, std::string(meaning)});
    else if (const auto* choice = std::get_if<bool>(&value))
      list.push_back({key, 1.0 * *choice, std::string(meaning)});
    else if (const auto* numbers = std::get_if<std::vector<double>>(&value))
      for (std::size_t i = 0; i < numbers->size(); ++i)
        list.push_back({fmt::format("{}[{}]", key, i), (*numbers)[i], std::string(meaning)});
  }
  return list;
}

} // namespace platen::material
