#pragma once
// Parameters as texts, `key=value`, read by the table of a law.

#include "platen/law/law_info.hpp"

#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <string>

namespace platen::law {

/// "key" -> text of its value, as in `key=value`.
using ParameterTexts = std::map<std::string, std::string, std::less<>>;

/// "key=value key=value ..." as in the C interface.
inline ParameterTexts parameter_texts(std::string_view text) {
  ParameterTexts texts;
  std::istringstream in{std::string(text)};
  for (std::string word; in >> word;) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw BadParameter("'" + word + "' is not of the form key=value");
    if (!texts.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
      throw BadParameter("'" + word.substr(0, equals) + "' is given twice");
  }
  return texts;
}

namespace detail {

inline std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  while (true) {
    const auto end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

inline double number_of(std::string_view law, std::string_view key, const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0;
  if (text == "inf") return infinity;
  if (!(in >> value) || !(in >> std::ws).eof())
    throw BadParameter(std::string(law) + ": " + std::string(key) + " = '" + text + "' is not a number");
  return value;
}

/// The texts of one law, read by its table.
class Reader {
 public:
  Reader(const LawInfo& info, const ParameterTexts& texts) : info_(info), texts_(texts) {
    std::vector<std::string> known;
    for (const auto& p : info.parameters) known.emplace_back(p.key);
    for (const auto& w : info.words) known.emplace_back(w.key);
    for (const auto& [key, text] : texts) {
      bool found = false;
      for (const auto& k : known) found = found || k == key;
      if (!found)
        throw BadParameter(std::string(info.name) + ": there is no parameter '" + key +
                           "'; known are: " + listed(known));
    }
  }
  [[nodiscard]] bool given(std::string_view key) const { return texts_.find(key) != texts_.end(); }

  [[nodiscard]] double operator()(std::string_view key) const {
    for (const auto& p : info_.parameters) {
      if (p.key != key) continue;
      const auto text = texts_.find(key);
      if (text == texts_.end()) {
        if (std::isnan(p.fallback))
          throw BadParameter(std::string(info_.name) + ": " + std::string(key) + " is missing (" +
                             std::string(p.meaning) + ")");
        return p.fallback;
      }
      const double value = number_of(info_.name, key, text->second);
      require(info_.name, key, value, p.range);
      return value;
    }
    throw BadParameter(std::string(info_.name) + ": no parameter " + std::string(key));
  }
  /// A value of the second body, which is that of the first where it is not given.
  [[nodiscard]] double second(std::string_view key, double first) const {
    return given(key) ? (*this)(key) : first;
  }

  [[nodiscard]] std::string word(std::string_view key) const {
    for (const auto& w : info_.words) {
      if (w.key != key) continue;
      const auto allowed = split(w.values, '|');
      const auto text = texts_.find(key);
      if (text == texts_.end()) return allowed.front();
      for (const auto& a : allowed)
        if (a == text->second) return a;
      throw BadParameter(std::string(info_.name) + ": " + std::string(key) + " = '" + text->second +
                         "' is none of: " + listed(allowed));
    }
    return {};
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const {
    std::vector<double> values;
    if (const auto text = texts_.find(key); text != texts_.end())
      for (const auto& part : split(text->second, ',')) values.push_back(number_of(info_.name, key, part));
    return values;
  }

 private:
  const LawInfo& info_;
  const ParameterTexts& texts_;
};

} // namespace detail

} // namespace platen::law
