#include "app/command_line.hpp"

#include <CLI/CLI.hpp>

#include <optional>

namespace platen::app {

Option Option::required() { return option_->required(), *this; }
Option Option::type_name(const std::string& name) { return option_->type_name(name), *this; }
Option Option::capture_default_str() { return option_->capture_default_str(), *this; }
Option Option::excludes(Option other) { return option_->excludes(other.option_), *this; }
Option Option::value_optional() { return option_->expected(0, 1), *this; }
Option Option::range(int from, int to) { return option_->check(CLI::Range(from, to)), *this; }
Option Option::range(double from, double to) { return option_->check(CLI::Range(from, to)), *this; }
bool Option::given() const { return option_->count() > 0; }
std::string Option::name() const { return option_->get_name(); }

Command Command::add_subcommand(const std::string& name, const std::string& what) {
  return Command(*app_->add_subcommand(name, what));
}
void Command::require_subcommand() { app_->require_subcommand(1); }
template <class T> Option Command::add_option(const std::string& names, T& value, const std::string& what) {
  return Option(*app_->add_option(names, value, what));
}
template Option Command::add_option(const std::string&, std::string&, const std::string&);
template Option Command::add_option(const std::string&, int&, const std::string&);
template Option Command::add_option(const std::string&, double&, const std::string&);
template Option Command::add_option(const std::string&, std::vector<double>&, const std::string&);
template Option Command::add_option(const std::string&, std::vector<std::string>&, const std::string&);
template Option Command::add_option(const std::string&, std::optional<double>&, const std::string&);
Option Command::add_flag(const std::string& names, bool& value, const std::string& what) {
  return Option(*app_->add_flag(names, value, what));
}
Command Command::footer(const std::string& text) { return app_->footer(text), *this; }
void Command::callback(std::function<void()> action) { app_->callback(std::move(action)); }

void refuse_missing(const std::string& argument) { throw CLI::RequiredError(argument); }

Program::Program(const std::string& name, const std::string& what, const std::string& version)
    : app_(std::make_unique<CLI::App>(what, name)) {
  app_->set_version_flag("--version", version);
}
Program::~Program() = default;

Command Program::command() { return Command(*app_); }

std::vector<std::pair<std::string, std::string>> Program::commands() const {
  std::vector<std::pair<std::string, std::string>> list;
  for (const auto* command : std::as_const(*app_).get_subcommands({}))
    list.emplace_back(command->get_name(), command->get_description());
  return list;
}

bool Program::parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) { return app_->exit(error) == 0; }
  return true;
}

} // namespace platen::app
