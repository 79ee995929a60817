#include "app/commands.hpp"
#include "app/exit_codes.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/say.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

namespace {

using namespace platen;

using namespace app; // the exit codes

constexpr const char* description =
    "Contact laws for plastic particles: material card, virtual press, fitted law.";

int give_up(Exit code, std::string_view why) {
  core::say_last(fmt::format("platen: {}", why));
  return code;
}

void print_commands(const app::Program& program) {
  fmt::print("{}\n\n", description);
  for (const auto& command : program.page().commands) fmt::print("  {:<17} {}\n", command.name, command.what);
  fmt::print("\nplaten COMMAND --help says more, with an example.\n");
}

int run(int argc, char** argv) {
  app::Program program("platen", description,
                       fmt::format("platen {} (engine {})", core::version, core::engine));
  app::Command command = program.command();
  command.footer("Example: platen derive mcc-ph-200 -o out");
  app::add_materials(command);
  app::add_point(command);
  app::add_press(command);
  app::add_fit(command);
  app::add_derive(command);
  app::add_laws(command);
  app::add_eval(command);
  app::add_compare(command);
  app::add_export(command);
  app::add_study(command);
  app::add_import(command);
  app::add_calibrate(command);
  app::add_compaction(command);
  app::add_convert(command);
  app::add_predict(command);
  app::add_reproduce(command);
  app::add_manual(command, program);
  app::add_completion(command, program);
  program.parse(argc, argv);
  if (argc < 2) print_commands(program);
  return done;
}

} // namespace

int main(int argc, char** argv) {
  core::watch_for_interrupts();
  int status = fault;
  try {
    status = run(argc, argv);
  } catch (const core::InvalidInput& error) {
    status = give_up(bad_input, error.what());
  } catch (const core::ConvergenceError& error) {
    status = give_up(not_converged, error.what());
  } catch (const core::IoError& error) {
    status = give_up(input_output, error.what());
  } catch (const core::Interrupted& error) {
    status = give_up(interrupted, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    status = give_up(input_output, error.what());
  } catch (const std::system_error& error) { // of fmt::print
    status = give_up(input_output, fmt::format("the output could not be written: {}", error.what()));
  } catch (const std::bad_alloc&) {
    status = give_up(input_output, "the memory of this machine does not suffice; ask for fewer elements");
  } catch (const std::exception& error) {
    status = give_up(fault, fmt::format("a fault in platen itself, please report it: {}", error.what()));
  }
  if (std::fflush(stdout) != 0 && status == done)
    status = give_up(input_output, "the output could not be written; is the disk full?");
  return status;
}
