// What the page asks of Platen. Texts and numbers go through two buffers; every call returns 0, or 1 with a
// sentence in the text. Cards, predictions, laws and files are read by the sources of the program.

#include "json.hpp"

#include "core/error.hpp"
#include "core/number.hpp"
#include "dem/lammps_lines.hpp"
#include "dem/law_table.hpp"
#include "explorer.hpp"
#include "material/card.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

using namespace platen;
using web::Json;

namespace {

std::string in, out;
std::vector<double> numbers;
web::Explorer explorer;

/// The first line is what is asked for, the others are key=value.
law::ParameterTexts request() {
  law::ParameterTexts texts;
  for (const auto& line : law::detail::split(in, '\n'))
    if (const auto equals = line.find('='); equals != std::string::npos)
      texts[line.substr(0, equals)] = line.substr(equals + 1);
  return texts;
}

double number_in(const law::ParameterTexts& texts, const char* key) {
  const auto found = texts.find(key);
  const auto value = found == texts.end() ? std::nullopt : core::number_from(found->second);
  if (!value || !std::isfinite(*value)) throw core::InvalidInput(std::string(key) + " is not a number");
  return *value;
}

template <class Work> int guarded(Work work) {
  try {
    work();
    return 0;
  } catch (const std::bad_alloc&) {
    out = "the memory that a page may use is exhausted";
  } catch (const std::exception& error) { out = error.what(); }
  return 1;
}

/// All numbers of a material, in SI.
std::string numbers_of(const material::Material& m) {
  Json json;
  for (const auto& p : material::parameters(m)) json.put(p.key, p.value);
  if (const auto* rock = std::get_if<material::DruckerPrager>(&m.model))
    json.put("phi_deg", rock->friction_deg());
  return json.text();
}

} // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(buffer) char* buffer(std::size_t size) {
  in.resize(size);
  return in.data();
}
EXPORT(text) const char* text() { return out.data(); }
EXPORT(text_size) std::size_t text_size() { return out.size(); }
EXPORT(values) const double* values() { return numbers.data(); }
EXPORT(values_size) std::size_t values_size() { return numbers.size(); }

/// A surrogate of the catalogue, or its grains of rock.
EXPORT(load) int load() {
  return guarded([] { explorer.load(in); });
}
/// What is worth doing before the next question, a small part; 1: there is more.
EXPORT(prepare) int prepare() { return explorer.prepare(); }

/// name, model and parameters as a card has them: all of its numbers.
EXPORT(card) int card() {
  return guarded([] { out = numbers_of(web::material_of(request())); });
}

/// name, model, parameters: the law of the material.
EXPORT(predict) int predict() {
  return guarded([] { out = explorer.predict(request()); });
}

/// Names of runs, one a line: the nearest of them to the material.
EXPORT(nearest_of) int nearest_of() {
  return guarded([] { out = explorer.nearest_of(law::detail::split(in, '\n')); });
}

/// radius_m, density, against, beside: all curves of the page.
EXPORT(curves) int curves() {
  return guarded([] {
    const auto asked = request();
    numbers.clear();
    out = explorer.curves({number_in(asked, "radius_m"), number_in(asked, "density"),
                           asked.at("against") == "plane", law::detail::split(asked.at("beside"), ',')},
                          numbers);
  });
}

/// One step of the contact that is dragged.
EXPORT(step) void step(double overlap) { explorer.step(overlap, numbers); }
EXPORT(forget) void forget() { explorer.forget(); }

/// law.toml, table.csv, material.toml, law.lmp
EXPORT(file) int file() {
  return guarded([] {
    const auto asked = request();
    out = explorer.file(asked.at("file"), number_in(asked, "radius_m"), number_in(asked, "density"),
                        asked.at("against") == "plane");
  });
}

/// A file of an instrument, its name in the first line: delta, force of its particle.
EXPORT(measured) int measured() {
  return guarded([] {
    const auto end = in.find('\n');
    numbers.clear();
    out = explorer.measured(in.substr(end + 1), in.substr(0, end), numbers);
  });
}

/// name, model, parameters, radius_m: the strength with which the law is nearest to what was measured.
EXPORT(fit) int fit() {
  return guarded([] {
    const auto asked = request();
    out = explorer.fit_strength(asked, number_in(asked, "radius_m"));
  });
}
