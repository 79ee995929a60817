#include "material/hardening_card.hpp"

#include "core/error.hpp"
#include "core/fields.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace platen::material {
namespace {

using core::any_number, core::Field, core::left_open, core::positive, core::right_open, core::Table;

/// The section as it stands in a card, every kind's fields side by side.
struct Given {
  std::string kind = "none";
  double eta = 0, kappa = 0, inverse_m = 0, K = 0, inverse_n = 0;
  std::vector<double> strain, stress;
};

struct Kind {
  std::string name, law;
  std::vector<Field<Given>> fields;
};
const std::vector<Kind> kinds = {
    // in the order of Hardening
    {"none", "perfectly plastic, as where `hardening` is left out", {}},
    {"exponential",
     "sigma = sigma_y exp(eta eps_p)",
     {{"eta", &Given::eta, "exponent of sigma_y over the equivalent plastic strain", any_number}}},
    {"hollomon",
     "sigma = kappa eps^(1/m) over the total strain eps = eps_p + sigma/E, from its intersection with the "
     "elastic line on; `sigma_y_Pa` and `E_bar` are left out",
     {{"kappa_Pa", &Given::kappa, "strength coefficient, less than E", positive},
      {"inverse_m", &Given::inverse_m, "hardening exponent 1/m", left_open(0, 1)}}},
    {"ludwik",
     "sigma = sigma_y + K eps_p^(1/n)",
     {{"K_Pa", &Given::K, "strength coefficient, less than E", positive},
      {"inverse_n", &Given::inverse_n, "hardening exponent 1/n", positive}}},
    {"table",
     "straight lines between points, 2 to 100; `sigma_y_Pa` and `E_bar` are left out",
     {Field<Given>{"strain", &Given::strain, "equivalent plastic strain, the first 0",
                   right_open(0, std::numeric_limits<double>::infinity())}
          .growing(),
      {"stress_Pa", &Given::stress, "yield stress there; the last holds beyond the last strain", positive}}},
};
const std::vector<Field<Given>> kind_field = {{"kind", &Given::kind, "the law"}};

void check_table(const Table& section, const Given& table) {
  const auto refuse = [&](const char* key, const std::string& rule) {
    throw core::InvalidInput(fmt::format("{}: {}", core::place(section, key), rule));
  };
  const std::size_t points = table.strain.size();
  if (points != table.stress.size())
    refuse("stress_Pa", fmt::format("{} stresses for {} strains; each strain needs its stress",
                                    table.stress.size(), points));
  if (points < 2) refuse("strain", "a hardening table needs two points at least");
  if (points > HardeningTable::size_max)
    refuse("strain",
           fmt::format("{} points; a hardening table has {} at most", points, HardeningTable::size_max));
  if (table.strain.front() != 0) refuse("strain", "a hardening table begins at strain 0, where yield begins");
}

Given given(const Hardening& hardening) {
  Given g;
  g.kind = kinds[hardening.index()].name;
  if (const auto* h = std::get_if<ExponentialHardening>(&hardening)) g.eta = h->eta;
  if (const auto* h = std::get_if<Hollomon>(&hardening)) g.kappa = h->kappa, g.inverse_m = h->inverse_m;
  if (const auto* h = std::get_if<Ludwik>(&hardening)) g.K = h->K, g.inverse_n = h->inverse_n;
  if (const auto* h = std::get_if<HardeningTable>(&hardening)) {
    g.strain.assign(h->strain.begin(), h->strain.begin() + h->size);
    g.stress.assign(h->stress.begin(), h->stress.begin() + h->size);
  }
  return g;
}

} // namespace

Hardening read_hardening(const Table& parameters) {
  const Table* section = core::section(parameters, "hardening");
  if (!section) return PerfectlyPlastic{};
  const core::Value* named = section->find("kind");
  const auto* name = named ? std::get_if<std::string>(&named->data) : nullptr;
  std::vector<std::string> names;
  for (const auto& kind : kinds) names.push_back(kind.name);
  if (!name)
    throw core::InvalidInput(fmt::format("{}: the text kind is missing; it is one of {}",
                                         core::place(*section, "kind"), fmt::join(names, ", ")));
  const auto at = std::find(names.begin(), names.end(), *name) - names.begin();
  if (at == std::ssize(names))
    throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such hardening{}",
                                         core::place(*section, "kind"), *name,
                                         core::suggestion(*name, names)));
  const std::vector<std::string> others = {"kind"};
  const Given g = core::read_fields<Given>(*section, kinds[static_cast<std::size_t>(at)].fields, {}, others);
  if (*name == "exponential") return ExponentialHardening{g.eta};
  if (*name == "hollomon") return Hollomon{g.kappa, g.inverse_m};
  if (*name == "ludwik") return Ludwik{g.K, g.inverse_n};
  if (*name == "none") return PerfectlyPlastic{};
  check_table(*section, g);
  return HardeningTable{g.strain, g.stress};
}

void check_hardening(const Table& parameters, const Hardening& hardening, double E, double G,
                     double sigma_y) {
  const auto refuse = [&](const std::string& rule) {
    throw core::InvalidInput(fmt::format("{}: {}", core::place(parameters, "hardening"), rule));
  };
  const auto less_than_E = [&](const char* key, double strength) {
    if (strength >= E)
      refuse(fmt::format("{} = {} must be less than E_Pa = {}", key, core::number_text(strength),
                         core::number_text(E)));
  };
  if (const auto* h = std::get_if<Hollomon>(&hardening)) less_than_E("kappa_Pa", h->kappa);
  if (const auto* h = std::get_if<Ludwik>(&hardening)) less_than_E("K_Pa", h->K);
  double steepest = 0;
  if (const auto* h = std::get_if<ExponentialHardening>(&hardening)) steepest = h->eta * sigma_y;
  if (const auto* h = std::get_if<HardeningTable>(&hardening))
    for (int i = 1; i < h->size; ++i)
      steepest = std::min(steepest, (h->stress[i] - h->stress[i - 1]) / (h->strain[i] - h->strain[i - 1]));
  if (steepest <= -3 * G)
    refuse(fmt::format("softens by {} Pa per unit strain; it must stay above -3G = {}, the elastic unloading",
                       core::number_text(steepest), core::number_text(-3 * G)));
}

std::string hardening_line(const Hardening& hardening) {
  if (std::holds_alternative<PerfectlyPlastic>(hardening)) return "";
  const Given g = given(hardening);
  std::string law = core::card_lines(kind_field, g) + core::card_lines(kinds[hardening.index()].fields, g);
  law.pop_back(); // the end of the last line
  for (auto end = law.find('\n'); end != std::string::npos; end = law.find('\n')) law.replace(end, 1, ", ");
  return fmt::format("hardening = {{ {} }}\n", law);
}

std::vector<std::pair<std::string, std::pair<double, std::string>>> hardening_numbers(
    const Hardening& hardening) {
  std::vector<std::pair<std::string, std::pair<double, std::string>>> list;
  const Given g = given(hardening);
  for (const auto& field : kinds[hardening.index()].fields) {
    const core::FieldValue value = core::value_of(field, g);
    if (const auto* number = std::get_if<double>(&value))
      list.push_back({"hardening." + field.key, {*number, field.meaning}});
    else if (const auto* numbers = std::get_if<std::vector<double>>(&value))
      for (std::size_t i = 0; i < numbers->size(); ++i)
        list.push_back({fmt::format("hardening.{}[{}]", field.key, i), {(*numbers)[i], field.meaning}});
  }
  return list;
}

std::string hardening_reference() {
  std::string page = "\n### hardening = { kind = ..., ... }\n\n`eps_p` is the equivalent plastic strain.\n";
  for (const auto& kind : kinds) {
    page += fmt::format("\n`kind = \"{}\"`: {}\n", kind.name, kind.law);
    if (!kind.fields.empty()) page += "\n" + core::reference_table(core::infos<Given>(kind.fields));
  }
  return page;
}

} // namespace platen::material
