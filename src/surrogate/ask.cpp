#include "core/catalogue.hpp"
#include "core/error.hpp"
#include "surrogate/assess.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace platen::surrogate {
namespace {

namespace fs = std::filesystem;

/// Files of a folder "pools" in the order of their names, each pool once.
std::vector<fs::path> surrogate_files() {
  std::vector<fs::path> files;
  for (const auto& catalogue : core::catalogues()) {
    std::error_code error;
    std::vector<fs::path> here;
    for (const auto& pool : fs::directory_iterator(catalogue / "pools", error))
      if (fs::is_regular_file(pool.path() / "surrogate.txt", error))
        here.push_back(pool.path() / "surrogate.txt");
    std::sort(here.begin(), here.end());
    for (const auto& file : here)
      if (std::none_of(files.begin(), files.end(), [&](const fs::path& other) {
            return other.parent_path().filename() == file.parent_path().filename();
          }))
        files.push_back(file);
  }
  return files;
}

} // namespace

std::vector<Surrogate> catalogue_surrogates(const std::string& model) {
  std::vector<Surrogate> all;
  for (const auto& file : surrogate_files())
    if (Surrogate s = read_surrogate(file); s.model == model) all.push_back(std::move(s));
  return all;
}

Answer ask_catalogue(const Description& d) {
  std::optional<Answer> best;
  for (const auto& s : catalogue_surrogates(d.model))
    if (auto better = ask(s, d, best)) best = std::move(better);
  if (!best)
    throw core::InvalidInput(fmt::format("the catalogue has no surrogate of {} materials; `platen study "
                                         "surrogate` makes one of a pool, `platen derive` "
                                         "presses the material",
                                         d.model));
  return std::move(*best);
}

} // namespace platen::surrogate
