#pragma once
// What the parts of the module share. The module is thin: cards, curves and summaries go to and from Python
// as the texts that the command reads and writes, numbers as arrays that Python allocates.

#include "core/error.hpp"
#include "fit/law_card.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <vector>

namespace platen::python {

namespace nb = nanobind;

nb::object object_of(const core::FieldValue&);
nb::dict dict_of(const fit::Remarks&);

/// Law, variant and parameters as one text, whatever way its numbers were written.
std::string identity(const fit::LawCard&);

/// Work without the lock of the interpreter. Ctrl-C is asked for by core::interrupted(); what Python's own
/// signal handlers raise goes on when the work has ended.
struct Signals { // forgets, before and after, that one came
  Signals();
  ~Signals();
};
template <class Work> auto long_work(Work work) {
  const Signals signals;
  nb::gil_scoped_release free;
  return work();
}

void add_laws(nb::module_&);
void add_contacts(nb::module_&);
void add_materials(nb::module_&);
void add_press(nb::module_&);
void add_measured(nb::module_&);

} // namespace platen::python
