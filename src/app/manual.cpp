#include "app/commands.hpp"
#include "app/exit_codes.hpp"
#include "core/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace platen::app {
namespace {

/// As roff takes it: man-pages(7).
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else if (c == '\n') out += out.ends_with('\n') ? "" : "\n.br\n";
    else if ((c == '.' || c == '\'') && (out.empty() || out.ends_with('\n'))) out += fmt::format("\\&{}", c);
    else out += c;
  }
  return out;
}

std::string entry_text(const Page::Entry& entry) {
  const std::string value = entry.value.empty() ? "" : fmt::format(" \\fI{}\\fR", escaped(entry.value));
  return fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", escaped(fmt::format("{}", fmt::join(entry.names, ", "))),
                     value, escaped(entry.what));
}

std::string command_text(const Page& page) {
  if (!page.commands.empty()) {
    std::string text;
    for (const auto& command : page.commands) text += command_text(command);
    return text;
  }
  std::string text = fmt::format(".SS {}\n{}\n", escaped(page.name), escaped(page.what));
  for (const bool positional : {true, false})
    for (const auto& entry : page.entries)
      if (entry.positional == positional && entry.names.back() != "--help") text += entry_text(entry);
  if (!page.footer.empty()) text += fmt::format(".PP\n{}\n", escaped(page.footer));
  return text;
}

std::string manual(const Page& program) {
  std::string text =
      fmt::format(".TH PLATEN 1 \"\" \"platen {}\"\n.SH NAME\nplaten \\- contact laws for plastic particles\n"
                  ".SH SYNOPSIS\n\\fBplaten\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n.SH DESCRIPTION\n{}\n"
                  "A file named \\- is standard input, or standard output.\n.SH COMMANDS\n",
                  core::version, escaped(program.what));
  for (const auto& command : program.commands) text += command_text(command);
  text += ".SH OPTIONS OF EVERY COMMAND\n";
  for (const auto& entry : program.entries) text += entry_text(entry);
  text += ".SH EXIT STATUS\n";
  for (const auto& [code, what] : exit_codes)
    text += fmt::format(".TP\n{}\n{}\n", static_cast<int>(code), what);
  return text + ".SH ENVIRONMENT\n.TP\nPLATEN_CATALOGUE\nfolder of cards, looked into before the catalogue\n";
}

} // namespace

void add_manual(Command program, const Program& all) {
  auto command = program.add_subcommand("manual", "this program as a page for man");
  command.footer("Example: platen manual | man -l -");
  command.callback([&all] { fmt::print("{}", manual(all.page())); });
}

} // namespace platen::app
