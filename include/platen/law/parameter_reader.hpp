#pragma once
// Parameters as texts, `key=value`, read by what a law says about itself.

#include "platen/law/law_info.hpp"
#include "platen/law/loading_case.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

namespace platen::law {

/// "key" -> text of its value, as in `key=value`.
using ParameterTexts = std::map<std::string, std::string, std::less<>>;

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

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000 // without from_chars for numbers with a point
inline bool reads_whole(std::string_view text, double& value) {
  if (text.find_first_not_of("0123456789.eE+-") != text.npos) return false; // no hexadecimals
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  return stream >> value && stream.peek() == std::istringstream::traits_type::eof();
}
#else
inline bool reads_whole(std::string_view text, double& value) {
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), value);
  return wrong == std::errc{} && end == text.data() + text.size();
}
#endif

inline double number_of(std::string_view law, std::string_view key, std::string_view text) {
  const std::string given(text);
  const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  while (!text.empty() && space(text.front())) text.remove_prefix(1);
  while (!text.empty() && space(text.back())) text.remove_suffix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text == "inf") return infinity;
  double value = 0;
  if (!reads_whole(text, value) || !std::isfinite(value))
    throw BadParameter(std::string(law) + ": " + std::string(key) + " = '" + given + "' is not a number");
  return value;
}

/// Keys with which other codes ask for adhesion.
inline bool asks_for_adhesion(std::string_view key) {
  for (const std::string_view word :
       {"adh", "cohes", "surface_energy", "work_of_adhesion", "k_c", "f_0", "pull_off"})
    if (key.find(word) != std::string_view::npos) return true;
  return false;
}

} // namespace detail

/// "key=value key=value ..." as in the C interface.
inline ParameterTexts parameter_texts(std::string_view text) {
  ParameterTexts texts;
  for (std::string& word : detail::split(text, ' ')) {
    while (!word.empty() && (word.back() == '\n' || word.back() == '\t' || word.back() == '\r'))
      word.pop_back();
    while (!word.empty() && (word.front() == '\n' || word.front() == '\t')) word.erase(0, 1);
    if (word.empty()) continue;
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw BadParameter("'" + word + "' is not of the form key=value");
    if (!texts.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
      throw BadParameter("'" + word.substr(0, equals) + "' is given twice");
  }
  return texts;
}

/// The texts of one body, read by the law's own table.
class Reader {
 public:
  /// Throws BadParameter for a key that the law does not have.
  Reader(const LawInfo& info, const ParameterTexts& texts, std::string variant_)
      : variant(std::move(variant_)), info_(info), texts_(texts) {
    std::vector<std::string> known;
    for (const auto& p : info.parameters) known.push_back(p.key);
    for (const auto& w : info.words) known.push_back(w.key);
    for (const auto& [key, text] : texts) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      if (detail::asks_for_adhesion(key))
        throw BadParameter(info.name + ": " + key +
                           ": no law here has adhesion; forces between particles are never "
                           "below zero");
      throw BadParameter(info.name + ": there is no parameter '" + key +
                         "'; known are: " + detail::listed(known));
    }
  }
  const std::string variant;
  [[nodiscard]] const std::string& law() const { return info_.name; }
  [[nodiscard]] bool given(std::string_view key) const { return texts_.find(key) != texts_.end(); }

  [[nodiscard]] double operator()(std::string_view key) const {
    for (const auto& p : info_.parameters) {
      if (p.key != key) continue;
      const auto text = texts_.find(key);
      if (text == texts_.end()) {
        if (std::isnan(p.fallback))
          throw BadParameter(info_.name + ": " + std::string(key) + " is missing (" + p.meaning + ")");
        return p.fallback;
      }
      const double value = detail::number_of(info_.name, key, text->second);
      require(info_.name, key, value, p.range);
      return value;
    }
    throw BadParameter(info_.name + ": no parameter " + std::string(key));
  }

  [[nodiscard]] std::string word(std::string_view key) const {
    for (const auto& w : info_.words) {
      if (w.key != key) continue;
      const auto allowed = detail::split(w.values, '|');
      const auto text = texts_.find(key);
      if (text == texts_.end()) return allowed.front();
      for (const auto& a : allowed)
        if (a == text->second) return a;
      throw BadParameter(info_.name + ": " + std::string(key) + " = '" + text->second +
                         "' is none of: " + detail::listed(allowed));
    }
    return {};
  }
  [[nodiscard]] LoadingCase loading() const {
    const std::string chosen = word("loading");
    return chosen == "die"           ? LoadingCase::die
           : chosen == "hydrostatic" ? LoadingCase::hydrostatic
                                     : LoadingCase::simple;
  }
  [[nodiscard]] std::vector<double> numbers(std::string_view key) const {
    std::vector<double> values;
    if (const auto text = texts_.find(key); text != texts_.end())
      for (const auto& part : detail::split(text->second, ','))
        values.push_back(detail::number_of(info_.name, key, part));
    return values;
  }

 private:
  const LawInfo& info_;
  const ParameterTexts& texts_;
};

} // namespace platen::law
