#include "app/commands.hpp"
#include "app/law_arguments.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/toml.hpp"
#include "fit/convert_deck.hpp"
#include "fit/rewrite_hardening.hpp"
#include "material/card.hpp"
#include "material/deck.hpp"

#include <fmt/format.h>

#include <memory>

namespace platen::app {
namespace {

struct Options {
  std::string deck, card, units, material, hardening, strain = "0:1";
  std::optional<double> rho_r0;
  bool force = false;
};

/// What was written, and on standard output what could not be.
void write(const Options& o, const std::string& text, const std::vector<std::string>& said,
           const std::vector<std::string>& left_over) {
  if (o.card.empty()) {
    fmt::print("{}", text);
    return;
  }
  core::write_file(o.card, text);
  std::FILE* report = report_stream(o.card);
  for (const auto& sentence : said) fmt::print(report, "{}\n", sentence);
  if (!left_over.empty()) fmt::print(report, "without counterpart there:\n");
  for (const auto& line : left_over) fmt::print(report, "  {}\n", line);
}

/// What says something of an input file says nothing of a card.
void refuse_options_of_decks(const Options& o) {
  for (const auto& [given, name] :
       {std::pair{!o.material.empty(), "--material"}, std::pair{o.rho_r0.has_value(), "--rho_r0"}})
    if (given)
      throw core::InvalidInput(
          fmt::format("{} is of an Abaqus input file, and {} is a material card", name, o.deck));
}

void write_deck(const Options& o) {
  refuse_options_of_decks(o);
  const auto card = material::read_card(o.deck);
  if (o.units.empty()) throw core::InvalidInput("in which units shall it be? Give --units, as mm-tonne-MPa");
  auto deck = material::deck_of(card.material, material::deck_units(o.units));
  std::string remarks;
  for (const auto& line : deck.left_over) remarks += fmt::format("** without counterpart: {}\n", line);
  write(o, deck.text + remarks, {}, deck.left_over);
}

fit::StrainRange strain_range(const std::string& text) {
  const auto ends = numbers_of_range("--strain", text);
  if (ends.size() != 2) throw core::InvalidInput(fmt::format("--strain {} is not of the form FROM:TO", text));
  return {ends[0], ends[1]};
}

void write_hardening(const Options& o) {
  refuse_options_of_decks(o);
  auto card = material::read_card(o.deck);
  const auto* metal = std::get_if<material::VonMises>(&card.material.model);
  if (!metal)
    throw core::InvalidInput(fmt::format("{}: hardening is of von-mises, this is {}", o.deck,
                                         material::model_name(card.material.model)));
  const auto rewritten = fit::rewrite_hardening(*metal, o.hardening, strain_range(o.strain));
  card.material.model = rewritten.material;
  const auto error = fmt::format("stress off by {:.3g} % rms, at most {:.3g} % (at plastic strain {:.3g})",
                                 100 * rewritten.relative_rms, 100 * rewritten.worst, rewritten.worst_at);
  const auto source =
      fmt::format("hardening of {} as {}: least squares of the stress over plastic strains {}; {}",
                  card.material.name, o.hardening, o.strain, error);
  const auto text = fmt::format("{}\n[source]\ndefault = {}\n", material::card_text(card.material),
                                core::in_quotes(source));
  (void)material::read_card(core::parse_toml(text, o.deck)); // what the model does not admit is said now
  write(o, text, {error}, {});
}

void convert(const Options& o) {
  if (!o.hardening.empty()) return write_hardening(o);
  const bool named = !core::is_there(o.deck);
  if (o.deck.ends_with(".toml") || (named && !o.deck.ends_with(".inp"))) return write_deck(o);
  if (named) throw core::InvalidInput(fmt::format("{}: there is no such file", o.deck));
  const auto decks = material::read_deck(core::read_file(o.deck), o.deck);
  const auto& deck = material::choose(decks, o.material);
  if (o.units.empty()) throw core::InvalidInput(material::which_units(deck));
  const auto converted = fit::convert_deck(deck, material::deck_units(o.units), o.rho_r0, o.force);
  write(o, converted.card, converted.said, converted.left_over);
}

} // namespace

void add_convert(Command program) {
  auto command = program.add_subcommand(
      "convert",
      "a material card from an Abaqus input file, or the other way round; another form of hardening");
  auto o = std::make_shared<Options>();
  command.add_option("DECK.inp", o->deck, "input file with a *MATERIAL; or a material card").required();
  command.add_option("-o", o->card, "write the card, or the deck, here").type_name("MATERIAL.toml");
  const auto units =
      command.add_option("--units", o->units, "si, mm-tonne-MPa, mm-kg-GPa, m-tonne-kPa or in-lbf-psi")
          .type_name("SYSTEM");
  command.add_option("--material", o->material, "which one, where there are several").type_name("NAME");
  command
      .add_option("--rho_r0", o->rho_r0, "*CAP PLASTICITY: relative density at volumetric plastic strain 0")
      .type_name("NUMBER");
  auto hardening = command.add_option(
      "--hardening", o->hardening,
      "of a von-mises card: the same material with the hardening none, exponential, hollomon, ludwik or "
      "table, by least squares of the stress");
  hardening.type_name("KIND").excludes(units);
  command
      .add_option("--strain", o->strain,
                  "the equivalent plastic strains over which --hardening follows the stress")
      .type_name("FROM:TO")
      .capture_default_str()
      .needs(hardening);
  command.add_flag("--force", o->force, "write the card though its numbers are doubted");
  command.footer(
      "Reads *ELASTIC, *DENSITY, *PLASTIC, *DRUCKER PRAGER, *CAP PLASTICITY and *MOHR COULOMB with their\n"
      "hardening; lists whatever else the material says.\n"
      "Example: platen convert tablet.inp --units mm-tonne-MPa -o tablet.toml\n"
      "         platen convert von-mises-100 --units mm-tonne-MPa -o metal.inp\n"
      "         platen convert lead-ludwik --hardening hollomon --strain 0:1.5 -o lead.toml");
  command.callback([o] { convert(*o); });
}

} // namespace platen::app
