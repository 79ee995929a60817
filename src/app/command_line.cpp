#include "app/command_line.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"
#include "core/say.hpp"
#include "core/unit.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <type_traits>

namespace platen::app {

Option Option::required() { return option_->required(), *this; }
Option Option::type_name(const std::string& name) { return option_->type_name(name), *this; }
Option Option::capture_default_str() { return option_->capture_default_str(), *this; }
Option Option::excludes(Option other) { return option_->excludes(other.option_), *this; }
Option Option::needs(Option other) { return option_->needs(other.option_), *this; }
Option Option::value_optional() { return option_->expected(0, 1), *this; }
Option Option::range(int from, int to) { return option_->check(CLI::Range(from, to)), *this; }
Option Option::range(double from, double to) { return option_->check(CLI::Range(from, to)), *this; }
bool Option::given() const { return option_->count() > 0; }
std::string Option::name() const { return option_->get_name(); }

Command Command::add_subcommand(const std::string& name, const std::string& what) {
  auto* command = app_->add_subcommand(name, what);
  command->fallthrough(); // --quiet is the program's, and may stand anywhere
  return Command(*command);
}
void Command::require_subcommand() { app_->require_subcommand(1); }
namespace {

/// "0.5 mm,0.6 mm" in the unit of the key, as numbers with commas.
std::string numbers_in_si(const std::string& option, const std::string& text, const std::string& key) {
  std::string result;
  for (std::size_t from = 0; from <= text.size();) {
    const auto comma = std::min(text.find(',', from), text.size());
    const auto part = text.substr(from, comma - from);
    if (core::number_from(part))
      throw core::InvalidInput(fmt::format("{} {} has no unit; write it, or --{} {}, which is in SI units",
                                           option, text, key, text));
    result += (from ? "," : "") + core::number_text(core::value_in_si(option, part, key));
    from = comma + 1;
  }
  return result;
}

void assign(std::string& value, const std::string& numbers) { value = numbers; }
void assign(double& value, const std::string& numbers) { value = core::number_from(numbers).value_or(NAN); }
void assign(std::optional<double>& value, const std::string& numbers) { value = core::number_from(numbers); }
template <class T>
constexpr bool measures =
    std::is_same_v<T, std::string> || std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>;

constexpr const char* unlisted = ""; // a group that help leaves out

/// CLI11's get_option_no_throw allocates, and ends the program where there is no memory.
bool is_known(const CLI::App& app, const std::string& name) {
  const auto all = app.get_options();
  return std::any_of(all.begin(), all.end(), [&](const auto* option) { return option->check_name(name); });
}

/// --radius "0.5 mm" beside --radius_m 0.5e-3.
template <class T> void add_with_unit(CLI::App& app, CLI::Option& option, T& value) {
  for (const std::string& key : option.get_lnames()) {
    const std::vector<std::string> known{key};
    for (auto end = key.find('_'); end != key.npos; end = key.find('_', end + 1)) {
      const std::string bare = key.substr(0, end), name = "--" + bare;
      if (core::si_key(bare, known).empty() || is_known(app, name)) continue;
      const auto take = [&value, &option, name, key](const std::string& text) {
        if (option.count() > 0)
          throw core::InvalidInput(fmt::format("{} and --{} are the same; give one of the two", name, key));
        assign(value, numbers_in_si(name, text, key));
      };
      app.add_option_function<std::string>(name, take)->group(unlisted);
    }
  }
}

} // namespace

template <class T> Option Command::add_option(const std::string& names, T& value, const std::string& what) {
  auto* option = app_->add_option(names, value, what);
  if constexpr (measures<T>) add_with_unit(*app_, *option, value);
  return Option(*option);
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

std::FILE* report_stream(const std::string& output) {
  return output == core::standard_stream ? stderr : stdout;
}

namespace {

Page page_of(const CLI::App& app, const std::string& above) {
  Page page{above + app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const auto* option : app.get_options()) {
    if (option->get_group() == unlisted) continue;
    Page::Entry entry;
    entry.positional = option->get_positional();
    if (entry.positional) entry.names.push_back(option->get_name());
    for (const auto& name : option->get_snames()) entry.names.push_back("-" + name);
    for (const auto& name : option->get_lnames()) entry.names.push_back("--" + name);
    if (!entry.positional && option->get_type_size() != 0) entry.value = option->get_type_name();
    entry.what = option->get_description();
    page.entries.push_back(std::move(entry));
  }
  for (const auto* command : app.get_subcommands({}))
    page.commands.push_back(page_of(*command, page.name + " "));
  return page;
}

std::vector<std::string> names_of_commands(const Page& page) {
  std::vector<std::string> names;
  for (const auto& command : page.commands) names.push_back(command.name.substr(page.name.size() + 1));
  return names;
}

/// What CLI11 says of a line that is no good, with a suggestion where a command or an option is misspelt.
[[noreturn]] void refuse(const Page& program, int argc, const char* const* argv, const std::string& reason) {
  const Page* page = &program;
  std::vector<std::string> options;
  int at = 1;
  for (; at <= argc; ++at) { // down to the command that was typed
    for (const auto& entry : page->entries)
      if (!entry.positional) options.insert(options.end(), entry.names.begin(), entry.names.end());
    if (at == argc || page->commands.empty()) break;
    const auto names = names_of_commands(*page);
    const auto found = std::ranges::find(names, argv[at]);
    if (found == names.end()) break;
    page = &page->commands[found - names.begin()];
  }
  const std::string help = fmt::format("; {} --help says more", page->name);
  if (!page->commands.empty()) {
    const auto names = names_of_commands(*page);
    if (at >= argc)
      throw core::InvalidInput(
          fmt::format("{} needs one of: {}{}", page->name, fmt::join(names, ", "), help));
    if (argv[at][0] != '-')
      throw core::InvalidInput(fmt::format("there is no command '{} {}'{}", page->name, argv[at],
                                           core::suggestion(argv[at], names)));
  }
  for (int i = at; i < argc; ++i) {
    const std::string word = argv[i], name = word.substr(0, word.find('='));
    if (name.size() < 2 || name[0] != '-' || std::ranges::count(options, name)) continue;
    if (!std::isalpha(static_cast<unsigned char>(name[name[1] == '-' ? 2 : 1]))) continue; // a number
    if (name[1] != '-' && std::ranges::count(options, name.substr(0, 2))) continue;        // -ofile
    const std::string like = core::nearest(name, options);
    throw core::InvalidInput(fmt::format("{} has no option {}{}{}", page->name, name,
                                         like.empty() ? "" : fmt::format("; did you mean {}?", like),
                                         like.empty() ? help : ""));
  }
  throw core::InvalidInput(reason + help);
}

} // namespace

Program::Program(const std::string& name, const std::string& what, const std::string& version)
    : app_(std::make_unique<CLI::App>(what, name)) {
  app_->set_version_flag("--version", version);
  app_->add_flag_callback("--quiet", core::be_quiet,
                          "no notes and no progress; what goes wrong is still said");
}
Program::~Program() = default;

Command Program::command() { return Command(*app_); }

Page Program::page() const { return page_of(*app_, ""); }

void Program::parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) { // --help, --version
    app_->exit(asked);
  } catch (const CLI::ParseError& error) { refuse(page(), argc, argv, error.what()); }
}

} // namespace platen::app
