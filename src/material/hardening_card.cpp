#include "material/hardening_card.hpp"

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <tuple>

namespace platen::material {
namespace {

using core::any_number, core::Field, core::left_open, core::positive, core::right_open, core::Table;

/// A law as cards name it, and in words.
template <class Law> struct Kind {
  std::string name, words;
  CardSection<Law> section;
};

/// Of a table.
struct Points {
  std::vector<double> strain, stress;
};

HardeningTable make_table(const Table& section, const Points& given) {
  const auto refuse = [&](const char* key, const std::string& rule) {
    throw core::InvalidInput(fmt::format("{}: {}", core::place(section, key), rule));
  };
  const auto& [strain, stress] = given;
  if (strain.size() != stress.size())
    refuse("stress_Pa", fmt::format("{} stresses for {} strains; each strain needs its stress", stress.size(),
                                    strain.size()));
  if (strain.size() < 2) refuse("strain", "a hardening table needs two points at least");
  if (strain.size() > HardeningTable::size_max)
    refuse("strain", fmt::format("{} points; a hardening table has {} at most", strain.size(),
                                 HardeningTable::size_max));
  if (strain.front() != 0) refuse("strain", "a hardening table begins at strain 0, where yield begins");
  return {strain, stress};
}

Points points_of(const HardeningTable& h) {
  return {{h.strain.begin(), h.strain.begin() + h.size}, {h.stress.begin(), h.stress.begin() + h.size}};
}

const std::tuple<Kind<PerfectlyPlastic>, Kind<ExponentialHardening>, Kind<Hollomon>, Kind<Ludwik>,
                 Kind<HardeningTable>>
    kinds = {
        {"none", "perfectly plastic, as where `hardening` is left out", section_of<PerfectlyPlastic>({})},
        {"exponential", "sigma = sigma_y exp(eta eps_p)",
         section_of<ExponentialHardening>(
             {{"eta", &ExponentialHardening::eta, "exponent of sigma_y over the equivalent plastic strain",
               any_number}})},
        {"hollomon",
         "sigma = kappa eps^(1/m) over the total strain eps = eps_p + sigma/E, from its intersection with "
         "the "
         "elastic line on; `sigma_y_Pa` and `E_bar` are left out",
         section_of<Hollomon>(
             {{"kappa_Pa", &Hollomon::kappa, "strength coefficient, less than E", positive},
              {"inverse_m", &Hollomon::inverse_m, "hardening exponent 1/m", left_open(0, 1)}})},
        {"ludwik", "sigma = sigma_y + K eps_p^(1/n)",
         section_of<Ludwik>({{"K_Pa", &Ludwik::K, "strength coefficient, less than E", positive},
                             {"inverse_n", &Ludwik::inverse_n, "hardening exponent 1/n", positive}})},
        {"table", "straight lines between points, 2 to 100; `sigma_y_Pa` and `E_bar` are left out",
         section_of<HardeningTable, Points>(
             {Field<Points>{"strain", &Points::strain, "equivalent plastic strain, the first 0",
                            right_open(0, std::numeric_limits<double>::infinity())}
                  .growing(),
              {"stress_Pa", &Points::stress, "yield stress there; the last holds beyond the last strain",
               positive}},
             make_table, points_of)},
};

template <class Use> void for_each_kind(Use use) {
  std::apply([&](const auto&... kind) { (use(kind), ...); }, kinds);
}

} // namespace

Hardening read_hardening(const Table& parameters) {
  const Table* section = core::section(parameters, "hardening");
  if (!section) return PerfectlyPlastic{};
  const core::Value* named = section->find("kind");
  const auto* name = named ? std::get_if<std::string>(&named->data) : nullptr;
  std::vector<std::string> names;
  for_each_kind([&](const auto& kind) { names.push_back(kind.name); });
  if (!name)
    throw core::InvalidInput(fmt::format("{}: the text kind is missing; it is one of {}",
                                         core::place(*section, "kind"), fmt::join(names, ", ")));
  std::optional<Hardening> law;
  const std::vector<std::string> others = {"kind"};
  for_each_kind([&](const auto& kind) {
    if (kind.name == *name) law = kind.section.read(*section, others);
  });
  if (!law)
    throw core::InvalidInput(fmt::format("{} = \"{}\": there is no such hardening{}",
                                         core::place(*section, "kind"), *name,
                                         core::suggestion(*name, names)));
  return *law;
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

std::vector<CardEntry> hardening_entries(const Hardening& hardening) {
  if (std::holds_alternative<PerfectlyPlastic>(hardening)) return {};
  return std::visit(
      []<class Law>(const Law& law) {
        const auto& kind = std::get<Kind<Law>>(kinds);
        auto entries = kind.section.entries(law);
        entries.insert(entries.begin(), {"kind", kind.name, {}});
        for (auto& entry : entries) entry.key = "hardening." + entry.key;
        return entries;
      },
      hardening);
}

std::string hardening_reference() {
  std::string page = "### hardening = { kind = ..., ... }\n\n`eps_p` is the equivalent plastic strain. "
                     "`platen convert CARD --hardening KIND` writes one kind as another.\n";
  for_each_kind([&](const auto& kind) {
    page += fmt::format("\n`kind = \"{}\"`: {}\n", kind.name, kind.words);
    if (!kind.section.fields.empty()) page += "\n" + core::reference_table(kind.section.fields);
  });
  return page;
}

} // namespace platen::material
