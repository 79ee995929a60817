#include "measure/text.hpp"

#include "core/error.hpp"
#include "core/file.hpp"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace platen::measure {
namespace {

using core::InvalidInput;

struct Foreign {
  std::string_view begins, what;
};
constexpr std::array foreign = {
    Foreign{"\x89PNG", "a picture (PNG)"},
    Foreign{"\xFF\xD8\xFF", "a picture (JPEG)"},
    Foreign{"GIF8", "a picture (GIF)"},
    Foreign{"II*", "a picture (TIFF)"},
    Foreign{"%PDF", "a PDF document"},
    Foreign{"\xD0\xCF\x11\xE0", "a spreadsheet or document of old Microsoft Office"},
    Foreign{"\x1F\x8B", "a compressed file (gzip)"},
    Foreign{"SQLite format 3", "a database (SQLite)"},
    Foreign{"\x89HDF", "a binary file (HDF5)"},
    Foreign{"{\\rtf", "a document (RTF)"},
};

[[noreturn]] void refuse(const std::string& file, std::string_view what) {
  throw InvalidInput(fmt::format(
      "{}: this is {}, not a table of numbers; save or export the readings as text (CSV)", file, what));
}

void refuse_foreign(std::string_view bytes, const std::string& file) {
  for (const auto& kind : foreign)
    if (bytes.starts_with(kind.begins)) refuse(file, kind.what);
  if (!bytes.starts_with("PK\x03\x04")) return;
  const bool sheet = bytes.find("xl/") != bytes.npos || bytes.find("spreadsheet") != bytes.npos;
  refuse(file, sheet ? "a spreadsheet (Excel or OpenDocument)" : "an archive (ZIP) or a document");
}

/// Nothing where the bytes are no text in this encoding.
std::optional<std::string> converted(std::string_view bytes, const char* from) {
  const iconv_t converter = iconv_open("UTF-8", from);
  if (converter == reinterpret_cast<iconv_t>(-1)) return {};
  std::string text(3 * bytes.size() + 16, '\0');
  char* in = const_cast<char*>(bytes.data());
  char* out = text.data();
  std::size_t in_left = bytes.size(), out_left = text.size();
  const bool done = iconv(converter, &in, &in_left, &out, &out_left) != static_cast<std::size_t>(-1);
  iconv_close(converter);
  if (!done) return {};
  text.resize(text.size() - out_left);
  return text;
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    const std::size_t more = c < 0x80 ? 0 : (c >> 5) == 6 ? 1 : (c >> 4) == 14 ? 2 : (c >> 3) == 30 ? 3 : 9;
    if (more == 9 || i + more >= bytes.size() + (more == 0)) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(bytes[i + k]) & 0xC0) != 0x80) return false;
    i += more + 1;
  }
  return true;
}

/// Lead bytes of Japanese words are no letters of Western Europe.
bool looks_japanese(std::string_view bytes) {
  return std::ranges::count_if(bytes, [](char c) {
           const auto u = static_cast<unsigned char>(c);
           return u >= 0x81 && u <= 0x9F;
         }) >= 2;
}

} // namespace

Text decode(std::string bytes, const std::string& file) {
  const auto some = bytes.find_first_not_of(" \t\r\n");
  if (some == bytes.npos) throw InvalidInput(fmt::format("{}: the file is empty", file));
  refuse_foreign(bytes, file);
  const std::string_view all = bytes;
  if (all.starts_with("\xEF\xBB\xBF") && is_utf8(all))
    return {file, bytes.substr(3), "UTF-8 with byte-order mark"};
  for (const auto& [mark, name, words] : {std::tuple{"\xFF\xFE", "UTF-16LE", "UTF-16, little end first"},
                                          std::tuple{"\xFE\xFF", "UTF-16BE", "UTF-16, big end first"}})
    if (all.starts_with(mark))
      if (auto text = converted(all.substr(2, (all.size() - 2) / 2 * 2), name)) return {file, *text, words};
  if (const auto zeros = std::ranges::count(all, '\0'); zeros > 0) {
    if (static_cast<std::size_t>(zeros) * 5 > all.size() * 2) // UTF-16 of digits, its mark lost
      if (auto text = converted(all.substr(0, all.size() / 2 * 2), all[0] ? "UTF-16LE" : "UTF-16BE"))
        return {file, *text, "UTF-16 without byte-order mark"};
    refuse(file, "a binary file");
  }
  if (is_utf8(all)) {
    const bool ascii = std::ranges::all_of(all, [](char c) { return c > 0; });
    return {file, std::move(bytes), ascii ? "ASCII" : "UTF-8"};
  }
  if (looks_japanese(all))
    if (auto text = converted(all, "CP932")) return {file, *text, "Shift-JIS"};
  if (auto text = converted(all, "WINDOWS-1252")) return {file, *text, "Latin-1"};
  if (auto text = converted(all, "ISO-8859-1")) return {file, *text, "Latin-1"};
  refuse(file, "a binary file");
}

Text read_text(const std::filesystem::path& path) {
  if (!core::is_there(path)) throw InvalidInput(fmt::format("{}: there is no such file", path.string()));
  return decode(core::read_file(path), path.string());
}

} // namespace platen::measure
