#include "app/study_sobol.hpp"

#include "core/say.hpp"
#include "material/card.hpp"
#include "plot/surrogate/sobol_picture.hpp"
#include "surrogate/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

namespace platen::app {
namespace {

struct Options {
  std::string material, picture;
  double within = 0.2;
};

void print(const Options& o) {
  const auto material = material::read_card(o.material).material;
  const auto s = surrogate::sobol_of_catalogue(material, o.within);
  fmt::print("{}", words_of(s, material.name, o.within));
  if (!s.held.empty())
    core::say_line(
        fmt::format("note: held, because the pool does not vary them: {}", fmt::join(s.held, ", ")));
  if (!o.picture.empty()) plot::sobol_picture(s, o.picture);
}

} // namespace

void add_study_sobol(Command study) {
  auto command = study.add_subcommand("sobol", "which number of a material matters, through the surrogates");
  auto o = std::make_shared<Options>();
  command.add_option("MATERIAL", o->material, "material card, or a name in the catalogue").required();
  command
      .add_option("--within", o->within,
                  "how far each number goes to either side, over itself, as far as the pool reaches")
      .range(0.001, 0.9)
      .type_name("SHARE")
      .capture_default_str();
  command.add_option("-o", o->picture, "picture, .svg or .png").type_name("FILE");
  command.footer("Example: platen study sobol mcc-ph-200 -o sobol.svg");
  command.callback([o] { print(*o); });
}

} // namespace platen::app
