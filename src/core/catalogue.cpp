#include "core/catalogue.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <set>

namespace platen::core {
namespace {

namespace fs = std::filesystem;

/// Installed: beside the library that this is part of (the Python package), or share/platen beside the bin
/// folder of the program. Not installed: the source tree's.
fs::path own_catalogue() {
  std::error_code error;
  static const int here = 0;
  if (Dl_info library; dladdr(&here, &library) != 0 && library.dli_fname) {
    const fs::path beside = fs::path(library.dli_fname).parent_path() / "catalogue";
    if (fs::is_directory(beside, error)) return beside;
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share/platen/catalogue";
    if (fs::is_directory(installed, error)) return installed;
  }
  return PLATEN_SOURCE_CATALOGUE;
}

} // namespace

std::vector<fs::path> catalogues() {
  std::vector<fs::path> folders;
  if (const char* own = std::getenv("PLATEN_CATALOGUE"); own && *own) folders.emplace_back(own);
  folders.push_back(own_catalogue());
  std::erase_if(folders, [](const fs::path& folder) {
    std::error_code error;
    return !fs::is_directory(folder, error);
  });
  return folders;
}

fs::path find_card(std::string_view folder, std::string_view what) {
  const std::string asked(what);
  std::error_code error;
  if (asked == standard_stream || fs::is_regular_file(asked, error)) return asked;
  if (what.ends_with(".toml") || what.find('/') != std::string_view::npos)
    throw InvalidInput(fmt::format("{}: there is no such file", asked));
  if (!asked.empty())
    for (const auto& catalogue : catalogues())
      if (const fs::path card = catalogue / folder / (asked + ".toml"); fs::is_regular_file(card, error))
        return card;
  const auto names = card_names(folder);
  throw InvalidInput(fmt::format("'{}' is neither a file nor a card in {} of the catalogue{}", asked, folder,
                                 suggestion(asked, names)));
}

std::vector<std::string> card_names(std::string_view folder) {
  std::set<std::string> names;
  for (const auto& catalogue : catalogues()) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(catalogue / folder, error))
      if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
  }
  return {names.begin(), names.end()};
}

} // namespace platen::core
