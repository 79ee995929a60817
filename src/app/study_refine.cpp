#include "app/study_refine.hpp"

#include "surrogate/refine_study.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace platen::app {
namespace {

struct Options {
  std::string card, file, output;
  double target = 0.01;
  int most = 50;
};

void refine(const Options& o) {
  const auto s = study::read_study(o.card);
  const auto surrogate = surrogate::find_surrogate(o.file);
  fmt::print("{}", words_of(surrogate::refine_study(s, surrogate, o.target, static_cast<std::size_t>(o.most),
                                                    o.output),
                            o.target));
}

} // namespace

void add_study_refine(Command study) {
  auto command = study.add_subcommand(
      "refine", "which materials to press next: those of which a surrogate is least sure");
  auto o = std::make_shared<Options>();
  command.add_option("STUDY.toml", o->card, "its runs are the candidates; the more, the better").required();
  command.add_option("--surrogate", o->file, "what is to become surer: a pool with a surrogate, or its file")
      .type_name("POOL")
      .required();
  command.add_option("--target", o->target, "until no candidate's curve is expected to be further off")
      .range(1e-5, 1.0)
      .type_name("SHARE")
      .capture_default_str();
  command.add_option("--most", o->most, "presses").range(1, 100000).capture_default_str();
  command.add_option("-o", o->output, "the study to run; default STUDY-refined.toml beside it, with a table")
      .type_name("FILE");
  command.footer(
      "Example: platen study refine candidates.toml --surrogate catalogue/pools/edmans-sinka --target 0.01");
  command.callback([o] { refine(*o); });
}

} // namespace platen::app
