// What ./run demo runs: the program with `derive` alone, a third of what there is to compile.

#include "app/commands.hpp"
#include "app/run_program.hpp"

int main(int argc, char** argv) {
  using namespace platen::app;
  return run_program(argc, argv, [](Program& program) { add_derive(program.command()); });
}
