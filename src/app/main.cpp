#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/nearest.hpp"
#include "core/say.hpp"
#include "core/version.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <system_error>

namespace {

using namespace platen;

// The exit codes, in this one place.
enum Exit { done = 0, fault = 1, bad_input = 2, not_converged = 3, input_output = 4, interrupted = 130 };

int give_up(Exit code, std::string_view why) {
  core::say(fmt::format("platen: {}\n", why));
  return code;
}

void print_commands(const CLI::App& program) {
  fmt::print("{}\n\n", program.get_description());
  for (const auto* command : program.get_subcommands({}))
    fmt::print("  platen {:<10} {}\n", command->get_name(), command->get_description());
  fmt::print("\nplaten COMMAND --help says more, with an example.\n");
}

void refuse_unknown_command(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const auto* command : program.get_subcommands({})) names.push_back(command->get_name());
  for (const auto& name : names)
    if (name == argv[1]) return;
  throw core::InvalidInput(
      fmt::format("there is no command '{}'{}", argv[1], core::suggestion(argv[1], names)));
}

int run(int argc, char** argv) {
  CLI::App program("Contact laws for plastic particles: material card, virtual press, fitted law.", "platen");
  program.set_version_flag("--version", fmt::format("platen {} (engine {})", core::version, core::engine));
  program.footer("Example: platen derive mcc-ph-200 -o out");
  app::add_materials(program);
  app::add_point(program);
  app::add_press(program);
  app::add_fit(program);
  app::add_derive(program);
  app::add_laws(program);
  app::add_eval(program);
  app::add_compare(program);
  app::add_export(program);
  app::add_study(program);
  try {
    refuse_unknown_command(program, argc, argv);
    program.parse(argc, argv); // runs the command's callback
    if (argc < 2) print_commands(program);
  } catch (const CLI::ParseError& error) { return program.exit(error) == 0 ? done : bad_input; }
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
