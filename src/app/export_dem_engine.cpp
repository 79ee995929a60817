#include "app/export_dem_engine.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "dem/device_law.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace platen::app {

void add_export_dem_engine(Command command) {
  struct Options {
    std::string law, folder;
    double restitution = 1, friction = 0;
  };
  auto engine =
      command.add_subcommand("dem-engine", "a force model as source text, with its memory, for DEM-Engine");
  auto o = std::make_shared<Options>();
  engine.add_option("LAW", o->law, "law card of the particles").required();
  engine.add_option("-o", o->folder, "folder for functions.cu, model.cu and platen_model.py")
      .required()
      .type_name("DIR");
  engine
      .add_option("--restitution", o->restitution,
                  "of an elastic contact, in (0, 1]: viscous damping gives it")
      .type_name("NUMBER")
      .capture_default_str();
  engine.add_option("--friction", o->friction, "Coulomb's coefficient")
      .type_name("NUMBER")
      .capture_default_str();
  engine.footer("Example: platen export dem-engine mcc.toml --friction 0.3 --restitution 0.5 -o mcc-model");
  engine.callback([o] {
    const auto model = dem::engine_model(fit::find_law_card(o->law), o->restitution, o->friction);
    const core::OutputFolder folder(o->folder);
    core::write_file(folder / "functions.cu", model.functions);
    core::write_file(folder / "model.cu", model.model);
    core::write_file(folder / "platen_model.py", model.use);
    fmt::print("force model in {}: `from platen_model import use_platen`, then use_platen(solver)\n",
               folder.path().string());
  });
}

} // namespace platen::app
