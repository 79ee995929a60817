// Two bodies in contact, and what many such contacts remember.

#include "core.hpp"

#include "core/number.hpp"
#include "core/sha256.hpp"

#include <nanobind/ndarray.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace platen::python {
namespace {

using core::InvalidInput;

template <class T> using Array = nb::ndarray<T, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
template <class T> using Wanted = std::optional<Array<T>>;

struct Contact {
  law::Law law;
  fit::Validity validity = {}; ///< of the cards
  std::string words = {};      ///< for messages
  std::string key = {};        ///< same key, same contact: whose memory may be taken
};

std::string key_of(const std::string& words, std::initializer_list<const fit::LawCard*> cards) {
  std::string all = words;
  for (const auto* card : cards) all += identity(*card);
  return core::sha256(all);
}

/// Cubes of radii are numbers in these ends. Infinite is a plane, of a second body alone.
void check_radius(const fit::LawCard& card, const char* key, double radius, bool plane_too = false) {
  if (plane_too && radius == law::infinity) return;
  law::require(card.law, key, radius, {1e-30, 1e30});
}

Contact like_pair(const fit::LawCard& card, double radius, std::optional<double> partner_radius) {
  check_radius(card, "radius_m", radius);
  if (partner_radius) check_radius(card, "radius2_m", *partner_radius, true);
  law::ParameterTexts more{{"radius_m", core::number_text(radius)}};
  if (partner_radius) more["radius2_m"] = core::number_text(*partner_radius);
  Contact contact{fit::make_law(card, more)};
  contact.validity = fit::validity_of(card, contact.law);
  contact.words = fmt::format("{}, radii {} and {} m", card.law, radius, partner_radius.value_or(radius));
  contact.key = key_of(contact.words, {&card});
  return contact;
}

Contact unlike_pair(const fit::LawCard& card, double radius, const fit::LawCard& partner,
                    double partner_radius) {
  check_radius(card, "radius_m", radius);
  check_radius(partner, "radius_m", partner_radius, true);
  law::LawChoice one{card.law, card.variant, card.parameters},
      two{partner.law, partner.variant, partner.parameters};
  for (auto* side : {&one, &two})
    for (const char* key : {"radius_m", "radius2_m", "against"}) side->parameters.erase(key);
  for (const auto* side : {&one, &two})
    for (const auto& p : law::find_law(side->name).parameters)
      if (p.of == law::Of::body && side->parameters.contains(law::second_key(p.key)))
        throw InvalidInput(
            fmt::format("{}: {} describes a second body, and so does the partner; leave out one", side->name,
                        law::second_key(p.key)));
  Contact contact{law::make_law(one, radius, two, partner_radius)};
  contact.validity = fit::common(fit::validity_of(card, contact.law), fit::validity_of(partner, contact.law));
  contact.words = fmt::format("{} and {}, radii {} and {} m", card.law, partner.law, radius, partner_radius);
  contact.key = key_of(contact.words, {&card, &partner});
  return contact;
}

Contact on_plane(const fit::LawCard& card, double radius) {
  check_radius(card, "radius_m", radius);
  Contact contact{fit::make_law(card, {{"radius_m", core::number_text(radius)}, {"against", "plane"}})};
  contact.validity = fit::validity_of(card, contact.law);
  contact.words = fmt::format("{} on a rigid plane, radius {} m", card.law, radius);
  contact.key = key_of(contact.words, {&card});
  return contact;
}

/// What many contacts of one pair remember.
struct Memory {
  std::vector<law::State> states;
  std::string key;
  bool checked = true; ///< false: from outside, and no step was made with it
};

Memory memory_of(const std::string& key, const Array<const double>& overlap,
                 const Array<const double>& largest) {
  if (overlap.shape(0) != largest.shape(0))
    throw InvalidInput(fmt::format("a state of {} overlaps and {} largest overlaps: both must be as many",
                                   overlap.shape(0), largest.shape(0)));
  Memory memory{{}, key, false};
  for (std::size_t i = 0; i < overlap.shape(0); ++i) {
    const law::State state{overlap(i), largest(i)};
    if (!std::isfinite(state.gamma) || !(state.gamma_max >= 0) || !std::isfinite(state.gamma_max))
      throw InvalidInput(
          fmt::format("state {}: overlap {} and largest overlap {} must be finite, and the largest "
                      "not below 0",
                      i, state.gamma, state.gamma_max));
    memory.states.push_back(state);
  }
  return memory;
}

Memory take(const Memory& memory, const Array<const std::int64_t>& indices) {
  Memory taken{{}, memory.key, memory.checked};
  taken.states.reserve(indices.shape(0));
  for (std::size_t i = 0; i < indices.shape(0); ++i) {
    const std::int64_t at = indices(i), count = static_cast<std::int64_t>(memory.states.size());
    if (at < -1 || at >= count)
      throw nb::index_error(fmt::format("no contact {}; there are {}", at, count).c_str());
    taken.states.push_back(at == -1 ? law::State{} : memory.states[static_cast<std::size_t>(at)]);
  }
  return taken;
}

void read(const Memory& memory, double law::State::*number, const Array<double>& into) {
  if (into.shape(0) != memory.states.size()) throw InvalidInput("the array is not as long as the state");
  for (std::size_t i = 0; i < memory.states.size(); ++i) into.data()[i] = memory.states[i].*number;
}

/// Where the numbers go; null: not wanted.
struct Sink {
  double *force, *stiffness, *contact_radius, *mean_pressure, *dissipated_work;
  std::uint8_t* branch;
  bool* in_range;
};

/// All but the force.
inline void write_rest(const law::Response& now, const Contact& contact, const Sink& to, std::size_t i) {
  if (to.stiffness) to.stiffness[i] = now.stiffness;
  if (to.contact_radius) to.contact_radius[i] = now.contact_radius;
  if (to.mean_pressure) to.mean_pressure[i] = now.mean_pressure;
  if (to.dissipated_work) to.dissipated_work[i] = now.dissipated_work;
  if (to.branch) to.branch[i] = static_cast<std::uint8_t>(now.branch);
  if (to.in_range) to.in_range[i] = now.in_range && contact.validity.holds(now.state.gamma_max);
}

template <class T> T* pointer(const Wanted<T>& array, std::size_t count, const char* name) {
  if (!array) return nullptr;
  if (array->shape(0) != count)
    throw InvalidInput(fmt::format("{} has {} numbers for {} overlaps", name, array->shape(0), count));
  return array->data();
}

/// `same`: one contact along its way, else each overlap is another contact's. What is not wanted is not
/// computed: `force_alone` lets the compiler leave it out.
template <bool same, bool force_alone>
void advance(const Contact& contact, const double* overlap, std::size_t count, law::State* state,
             const Sink& to) {
  const law::TableView table = *contact.law.table;
  const law::Scale scale = contact.law.scale;
  for (std::size_t i = 0; i < count; ++i) {
    law::State& memory = state[same ? 0 : i];
    const law::Response now = law::evaluate(table, scale, memory, overlap[i]);
    memory = now.state;
    to.force[i] = now.force;
    if constexpr (!force_alone) write_rest(now, contact, to, i);
  }
}

/// One contact along its way, by the formulas.
void advance_exactly(const Contact& contact, const double* overlap, std::size_t count, const Sink& to) {
  law::State state;
  for (std::size_t i = 0; i < count; ++i) {
    const law::Response now = contact.law.formulas(state, overlap[i]);
    state = now.state;
    to.force[i] = now.force;
    write_rest(now, contact, to, i);
  }
}

void refuse_infinite(const double* overlap, std::size_t count) {
  bool finite = true;
  for (std::size_t i = 0; i < count; ++i)
    finite &= std::abs(overlap[i]) <= std::numeric_limits<double>::max();
  for (std::size_t i = 0; !finite && i < count; ++i)
    if (!std::isfinite(overlap[i]))
      throw InvalidInput(fmt::format("overlap {} is {}: overlaps must be finite numbers", i, overlap[i]));
}

Sink sink_of(std::size_t count, Array<double>& force, const Wanted<double>& stiffness,
             const Wanted<double>& contact_radius, const Wanted<double>& mean_pressure,
             const Wanted<double>& dissipated_work, const Wanted<std::uint8_t>& branch,
             const Wanted<bool>& in_range) {
  return {pointer<double>(force, count, "force"),
          pointer(stiffness, count, "stiffness"),
          pointer(contact_radius, count, "contact_radius"),
          pointer(mean_pressure, count, "mean_pressure"),
          pointer(dissipated_work, count, "dissipated_work"),
          pointer(branch, count, "branch"),
          pointer(in_range, count, "in_range")};
}

template <bool same>
void advance_all(const Contact& contact, const Array<const double>& overlaps, law::State* states,
                 const Sink& sink) {
  const std::size_t count = overlaps.shape(0);
  const double* overlap = overlaps.data();
  nb::gil_scoped_release free;
  refuse_infinite(overlap, count);
  if (sink.stiffness || sink.contact_radius || sink.mean_pressure || sink.dissipated_work || sink.branch ||
      sink.in_range)
    advance<same, false>(contact, overlap, count, states, sink);
  else advance<same, true>(contact, overlap, count, states, sink);
}

/// Tables are asked within their ends alone: no step leaves a larger overlap than this behind.
void refuse_too_large(const Contact& contact, Memory& memory) {
  for (const auto& state : memory.states)
    if (!(state.gamma_max * contact.law.scale.x_per_gamma <= law::TableView::x_limit * (1 + 1e-9)))
      throw InvalidInput(
          fmt::format("the largest overlap {} m of the state is beyond any that this contact remembers",
                      state.gamma_max));
  memory.checked = true;
}

void step(const Contact& contact, Memory& memory, const Array<const double>& overlaps, Array<double> force,
          Wanted<double> stiffness, Wanted<double> contact_radius, Wanted<double> mean_pressure,
          Wanted<double> dissipated_work, Wanted<std::uint8_t> branch, Wanted<bool> in_range) {
  if (memory.key != contact.key)
    throw InvalidInput(
        fmt::format("the state is that of another contact ({}); this one is {}", memory.key, contact.key));
  if (memory.states.size() != overlaps.shape(0))
    throw InvalidInput(
        fmt::format("{} overlaps for a state of {} contacts", overlaps.shape(0), memory.states.size()));
  if (!memory.checked) refuse_too_large(contact, memory);
  advance_all<false>(contact, overlaps, memory.states.data(),
                     sink_of(overlaps.shape(0), force, stiffness, contact_radius, mean_pressure,
                             dissipated_work, branch, in_range));
}

void follow(const Contact& contact, const Array<const double>& overlaps, Array<double> force,
            Wanted<double> stiffness, Wanted<double> contact_radius, Wanted<double> mean_pressure,
            Wanted<double> dissipated_work, Wanted<std::uint8_t> branch, Wanted<bool> in_range, bool exact) {
  const std::size_t count = overlaps.shape(0);
  const Sink sink =
      sink_of(count, force, stiffness, contact_radius, mean_pressure, dissipated_work, branch, in_range);
  law::State state;
  if (!exact) return advance_all<true>(contact, overlaps, &state, sink);
  nb::gil_scoped_release free;
  refuse_infinite(overlaps.data(), count);
  advance_exactly(contact, overlaps.data(), count, sink);
}

} // namespace

void add_contacts(nb::module_& m) {
  nb::class_<Memory>(m, "Memory", "What many contacts of one pair remember.")
      .def_ro("key", &Memory::key)
      .def("__len__", [](const Memory& memory) { return memory.states.size(); })
      .def_static("from_arrays", &memory_of, nb::arg("key"), nb::arg("overlap"), nb::arg("largest_overlap"))
      .def("take", &take, nb::arg("indices"), "A new memory of these contacts; -1: one that never touched.")
      .def(
          "read_overlap",
          [](const Memory& memory, Array<double> into) { read(memory, &law::State::gamma, into); },
          nb::arg("into").noconvert())
      .def(
          "read_largest_overlap",
          [](const Memory& memory, Array<double> into) { read(memory, &law::State::gamma_max, into); },
          nb::arg("into").noconvert());
  const auto wanted = [](const char* name) { return nb::arg(name).noconvert() = nb::none(); };
  nb::class_<Contact>(m, "Contact", "Two bodies in contact.")
      .def_static("like_pair", &like_pair, nb::arg("card"), nb::arg("radius"),
                  nb::arg("partner_radius") = nb::none())
      .def_static("unlike_pair", &unlike_pair, nb::arg("card"), nb::arg("radius"), nb::arg("partner"),
                  nb::arg("partner_radius"))
      .def_static("on_plane", &on_plane, nb::arg("card"), nb::arg("radius"))
      .def_ro("words", &Contact::words)
      .def_ro("key", &Contact::key)
      .def_prop_ro(
          "limit", [](const Contact& c) { return c.validity.to; },
          "Largest overlap for which the cards hold [m].")
      .def_prop_ro(
          "delta_bar_per_overlap", [](const Contact& c) { return c.law.scale.x_per_gamma; }, "[1/m]")
      .def(
          "new_memory",
          [](const Contact& contact, std::size_t count) {
            return Memory{std::vector<law::State>(count), contact.key, true};
          },
          nb::arg("count"))
      .def("step", &step, nb::arg("memory"), nb::arg("overlap"), nb::arg("force").noconvert(),
           wanted("stiffness"), wanted("contact_radius"), wanted("mean_pressure"), wanted("dissipated_work"),
           wanted("branch"), wanted("in_range"),
           "One step of many contacts; fills the arrays that are given.")
      .def("follow", &follow, nb::arg("overlap"), nb::arg("force").noconvert(), wanted("stiffness"),
           wanted("contact_radius"), wanted("mean_pressure"), wanted("dissipated_work"), wanted("branch"),
           wanted("in_range"), nb::arg("exact") = false,
           "One contact from its first touch along a way; exact: by the formulas, not by their table.");
}

} // namespace platen::python
