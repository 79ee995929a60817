#pragma once
// What an instrument wrote, as UTF-8 text.

#include <filesystem>
#include <string>

namespace platen::measure {

struct Text {
  std::string file; ///< as messages name it
  std::string utf8;
  std::string encoding; ///< "UTF-8 with byte-order mark", "Latin-1", ...
};

/// UTF-8, UTF-16, Shift-JIS or Latin-1 (with the letters of Windows-1252) by what the bytes are. InvalidInput
/// for files that are no text: a picture, a spreadsheet, an archive, a binary test file, an empty one.
Text decode(std::string bytes, const std::string& file);
/// InvalidInput when there is no such file.
Text read_text(const std::filesystem::path&);

} // namespace platen::measure
