#include "app/study_methods.hpp"

#include "surrogate/words.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace platen::app {
namespace {

struct Options {
  std::string pool, file;
  std::vector<std::string> with;
};

void compare(const Options& o) {
  if (surrogate::is_of_rock(o.pool)) {
    const auto rock = surrogate::rock_of_pool(o.pool);
    fmt::print("{}", words_of(rock, surrogate::rock_methods(rock)));
    return;
  }
  const auto pools = surrogate::read_pools(o.pool, o.with);
  const auto s = o.file.empty() ? surrogate::fit_surrogate(pools.all()) : surrogate::read_surrogate(o.file);
  fmt::print("{}", words_of(surrogate::methods_side_by_side(s, pools.fine), pools.fine.name));
}

} // namespace

void add_study_methods(Command study) {
  auto command = study.add_subcommand("methods", "ways to predict the materials of a pool, side by side");
  auto o = std::make_shared<Options>();
  command.add_option("POOL", o->pool, "folder with study.toml, runs.csv, curves.csv").required();
  command.add_option("--with", o->with, "pools of other materials that were pressed alike").type_name("POOL");
  command
      .add_option("--surrogate", o->file,
                  "the surrogate of these pools, as `platen study surrogate` wrote it; default: made anew")
      .type_name("FILE");
  command.footer("Example: platen study methods catalogue/pools/wang");
  command.callback([o] { compare(*o); });
}

} // namespace platen::app
