#include "app/run_program.hpp"

#include "app/exit_codes.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/say.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

namespace platen::app {
namespace {

constexpr const char* description =
    "Contact laws for plastic particles: material card, virtual press, fitted law.";

void print_commands(const Program& program) {
  fmt::print("{}\n\n", description);
  for (const auto& command : program.page().commands) fmt::print("  {:<17} {}\n", command.name, command.what);
  fmt::print("\nplaten COMMAND --help says more, with an example.\n");
}

int give_up(Exit code, std::string_view why) {
  core::say_last(fmt::format("platen: {}", why));
  return code;
}

constexpr std::string_view no_memory = "the memory of this machine does not suffice; ask for fewer elements";

/// Values of JSON allocate as they are destroyed, where no exception may pass: what is caught elsewhere ends
/// here.
[[noreturn]] void end_of_all() {
  try {
    if (const auto error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) { std::_Exit(give_up(input_output, no_memory)); } catch (...) {
    std::abort();
  }
  std::abort();
}

} // namespace

int run_program(int argc, char** argv, const std::function<void(Program&)>& add) {
  core::watch_for_interrupts();
  const auto before = std::set_terminate(end_of_all);
  int status = done;
  try {
    Program program("platen", description, fmt::format("platen {} (engine {})", core::version, core::engine));
    program.command().footer("Example: platen derive mcc-ph-200 -o out");
    add(program);
    program.parse(argc, argv);
    if (argc < 2) print_commands(program);
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
    status = give_up(input_output, no_memory);
  } catch (const std::exception& error) {
    status = give_up(fault, fmt::format("a fault in platen itself, please report it: {}", error.what()));
  }
  if (std::fflush(stdout) != 0 && status == done)
    status = give_up(input_output, "the output could not be written; is the disk full?");
  std::set_terminate(before);
  return status;
}

} // namespace platen::app
