#include "app/commands.hpp"
#include "app/run_program.hpp"

int main(int argc, char** argv) {
  using namespace platen::app;
  return run_program(argc, argv, [](Program& program) {
    const Command command = program.command();
    add_materials(command);
    add_point(command);
    add_press(command);
    add_fit(command);
    add_derive(command);
    add_laws(command);
    add_eval(command);
    add_compare(command);
    add_export(command);
    add_study(command);
    add_import(command);
    add_calibrate(command);
    add_compaction(command);
    add_convert(command);
    add_predict(command);
    add_reproduce(command);
    add_manual(command, program);
    add_completion(command, program);
  });
}
