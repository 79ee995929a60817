#pragma once
// The command line as the subcommands see it, with the names of CLI11, which stands behind. CLI11 is headers
// alone, and compiling it costs more than a subcommand of ours does: command_line.cpp alone includes it.

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace platen::app {

/// An option of a command; a copy is the same option.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required();
  Option type_name(const std::string&);
  Option capture_default_str(); ///< --help shows the value that the variable has now
  Option excludes(Option other);
  Option needs(Option other);
  Option value_optional(); ///< given alone, it leaves its variable empty
  Option range(int from, int to);
  Option range(double from, double to);

  bool given() const;
  std::string name() const;

 private:
  CLI::Option* option_;
};

/// A command or subcommand; a copy is the same command. What options write to must live as long as the
/// callback.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  Command add_subcommand(const std::string& name, const std::string& what);
  void require_subcommand();
  /// T: std::string, int, double, std::vector<std::string>, std::optional<double>
  template <class T> Option add_option(const std::string& names, T& value, const std::string& what);
  Option add_flag(const std::string& names, bool& value, const std::string& what);
  Command footer(const std::string&);
  void callback(std::function<void()>);

 private:
  CLI::App* app_;
};

/// For callbacks: an argument that is needed in this combination is not there.
[[noreturn]] void refuse_missing(const std::string& argument);

/// Where a command's words go: standard output, unless `output`, the file that it writes, is that.
std::FILE* report_stream(const std::string& output);

/// A command as --help shows it, for whoever writes it down otherwise.
struct Page {
  struct Entry {
    std::vector<std::string> names; ///< "--law", "-o"; of a positional argument its name alone
    std::string value, what;        ///< value: as help shows it; empty for a flag
    bool positional = false;
  };
  std::string name, what, footer; ///< name: with those of the commands above it, "platen study run"
  std::vector<Entry> entries;
  std::vector<Page> commands;
};

/// The program: its commands and the reading of what was typed.
class Program {
 public:
  Program(const std::string& name, const std::string& what, const std::string& version);
  ~Program();

  Command command();
  Page page() const;
  /// Runs the callback of the command that was typed. InvalidInput: the line was no good.
  void parse(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

} // namespace platen::app
