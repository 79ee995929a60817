#include "app/study_surrogate.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "surrogate/words.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::string pool, coarse, output;
  std::vector<std::string> with, beside;
};

std::filesystem::path file_of(const Options& o, const char* name) {
  return o.output.empty() ? std::filesystem::path(o.pool) / name : std::filesystem::path(o.output);
}

void make_rock(const Options& o) {
  if (!o.with.empty() || !o.coarse.empty())
    throw core::InvalidInput(o.pool + ": grains of rock take neither --with nor --coarse");
  const auto rock = surrogate::rock_of_pool(o.pool);
  const auto file = file_of(o, "grains.csv");
  core::write_file(file, surrogate::text_of(rock));
  fmt::print("{}", words_of(rock, file.string()));
  for (const auto& pool : o.beside) fmt::print("{}", words_beside(rock, surrogate::rock_of_pool(pool)));
}

void make(const Options& o) {
  if (surrogate::is_of_rock(o.pool)) return make_rock(o);
  const auto read = surrogate::read_pools(o.pool, o.with, o.coarse);
  const auto pools = read.all();
  const auto s = surrogate::fit_surrogate(pools);
  const auto file = file_of(o, "surrogate.txt");
  core::write_file(file, surrogate::text_of(s));
  fmt::print("{}", words_of(s, file.string(), &pools));
  for (const auto& pool : o.beside)
    fmt::print("{}", words_beside(s, surrogate::read_pool_data(pool, surrogate::Take::all)));
}

} // namespace

void add_study_surrogate(Command study) {
  auto command = study.add_subcommand("surrogate", "interpolate a data pool, for `platen predict`");
  auto o = std::make_shared<Options>();
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv").required();
  command.add_option("--with", o->with, "pools of other materials that were pressed alike").type_name("POOL");
  command
      .add_option("--coarse", o->coarse,
                  "pool of the same study, and more of it, on fewer elements; `platen predict` presses on as "
                  "many first")
      .type_name("POOL");
  command.add_option("-o", o->output, "the file; default surrogate.txt in its folder, of rock grains.csv")
      .type_name("FILE");
  command
      .add_option("--beside", o->beside, "pools that it is not made of: how well it says what they pressed")
      .type_name("POOL");
  command.footer("Example: platen study surrogate catalogue/pools/von-mises -o out/von-mises.txt");
  command.callback([o] { make(*o); });
}

} // namespace platen::app
