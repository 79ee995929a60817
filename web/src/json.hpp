#pragma once
// Writes JSON: the page reads it.

#include "core/number.hpp"
#include "core/toml.hpp"

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace platen::web {

class Json {
 public:
  Json& put(std::string_view key, const Json& value) { return raw(key, value.text()); }
  Json& put(std::string_view key, const std::string& value) { return raw(key, quoted(value)); }
  Json& put(std::string_view key, const char* value) { return raw(key, quoted(value)); }
  Json& put(std::string_view key, bool value) { return raw(key, value ? "true" : "false"); }
  template <std::integral T> Json& put(std::string_view key, T value) {
    return put(key, static_cast<double>(value));
  }
  Json& put(std::string_view key, double value) {
    return raw(key, std::isfinite(value) ? core::number_text(value) : "null");
  }
  template <class T> Json& put(std::string_view key, const std::vector<T>& values) {
    std::string list = "[";
    for (const auto& value : values) {
      Json one;
      one.put("", value);
      list += (list.size() > 1 ? "," : "") + one.body_.substr(3);
    }
    return raw(key, list + "]");
  }
  std::string text() const { return "{" + body_ + "}"; }

 private:
  Json& raw(std::string_view key, const std::string& value) {
    body_ += (body_.empty() ? "\"" : ",\"") + std::string(key) + "\":" + value;
    return *this;
  }
  static std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') result += '\\';
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return result + '"';
  }
  std::string body_;
};

} // namespace platen::web
