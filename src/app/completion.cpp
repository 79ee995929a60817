#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

namespace platen::app {
namespace {

/// Visits the program and all commands below it.
template <class Visit> void walk(const Page& page, const Visit& visit) {
  visit(page);
  for (const auto& command : page.commands) walk(command, visit);
}

std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

/// What may follow the command: commands below it, and options.
std::vector<std::string> words_after(const Page& page, const Page& program) {
  std::vector<std::string> words;
  for (const auto& command : page.commands) words.push_back(last_word(command.name));
  for (const auto* of : {&page, &program}) {
    for (const auto& entry : of->entries)
      if (!entry.positional) words.push_back(entry.names.back());
    if (&page == &program) break;
  }
  return words;
}

std::string bash(const Page& program) {
  std::string text = "_platen_words() { # COMMAND: what may follow it\n  case $1 in\n";
  walk(program, [&](const Page& page) {
    text += fmt::format("  '{}') echo '{}' ;;\n", page.name, fmt::join(words_after(page, program), " "));
  });
  return text + R"shell(  *) return 1 ;;
  esac
}
_platen() {
  local command=platen i
  for ((i = 1; i < COMP_CWORD; i++)); do
    _platen_words "$command ${COMP_WORDS[i]}" >/dev/null && command="$command ${COMP_WORDS[i]}"
  done
  COMPREPLY=($(compgen -W "$(_platen_words "$command")" -- "${COMP_WORDS[COMP_CWORD]}"))
}
complete -o default -F _platen platen
)shell";
}

std::string fish(const Page& program) {
  std::string text = "complete -c platen -f -n __fish_use_subcommand\n";
  walk(program, [&](const Page& page) {
    std::string when = "__fish_use_subcommand";
    if (&page != &program) {
      when.clear();
      std::string name = page.name.substr(program.name.size() + 1);
      for (std::size_t at = 0; at < name.size();) {
        const auto end = std::min(name.find(' ', at), name.size());
        when += fmt::format("{}__fish_seen_subcommand_from {}", when.empty() ? "" : "; and ",
                            name.substr(at, end - at));
        at = end + 1;
      }
    }
    const auto quoted = [](std::string what) {
      for (std::size_t i = 0; (i = what.find('\'', i)) != std::string::npos; i += 2) what.insert(i, "\\");
      return what;
    };
    for (const auto& command : page.commands)
      text += fmt::format("complete -c platen -n '{}' -a {} -d '{}'\n", when, last_word(command.name),
                          quoted(command.what));
    for (const auto& entry : page.entries) {
      if (entry.positional) continue;
      text += fmt::format("complete -c platen -n '{}'", when);
      for (const auto& name : entry.names)
        text += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2))
                                       : fmt::format(" -s {}", name.substr(1));
      text += fmt::format("{} -d '{}'\n", entry.value.empty() ? "" : " -r", quoted(entry.what));
    }
  });
  return text;
}

/// Bash's own, which zsh takes.
std::string zsh(const Page& program) {
  return "autoload -U +X bashcompinit && bashcompinit\n" + bash(program);
}

const std::vector<std::string> shells = {"bash", "zsh", "fish"};

} // namespace

void add_completion(Command program, const Program& all) {
  auto command = program.add_subcommand("completion", "what a shell needs to complete commands and options");
  auto shell = std::make_shared<std::string>();
  command.add_option("SHELL", *shell, "bash, zsh or fish").required();
  command.footer("Example: source <(platen completion bash)");
  command.callback([shell, &all] {
    const Page page = all.page();
    if (*shell == "bash") fmt::print("{}", bash(page));
    else if (*shell == "zsh") fmt::print("{}", zsh(page));
    else if (*shell == "fish") fmt::print("{}", fish(page));
    else
      throw core::InvalidInput(
          fmt::format("there is no completion for '{}'{}", *shell, core::suggestion(*shell, shells)));
  });
}

} // namespace platen::app
