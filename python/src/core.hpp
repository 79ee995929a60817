#pragma once
// What the parts of the module share. The module is thin: cards, curves and summaries go to and from Python
// as the texts that the command reads and writes, numbers as arrays that Python allocates.

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "fit/law_card.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <exception>
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

/// Makes core::interrupted() true in this thread until its long work has ended.
void stop_long_work();

/// A function of Python that long work calls now and then; what it raises is kept, and the work stops.
class Callback {
 public:
  explicit Callback(nb::object function) : function_(std::move(function)) {}

  template <class... Args> bool operator()(const Args&... args) {
    if (core::interrupted()) return false;
    if (function_.is_none()) return true;
    nb::gil_scoped_acquire lock;
    try {
      function_(args...);
    } catch (nb::python_error& error) {
      raised_ = std::make_exception_ptr(std::move(error));
      stop_long_work();
      return false;
    }
    return true;
  }
  /// With the lock held: goes on with what was raised in Python during the work.
  void rethrow() const {
    if (raised_) std::rethrow_exception(raised_);
    if (PyErr_Occurred()) nb::raise_python_error();
  }

 private:
  nb::object function_;
  std::exception_ptr raised_;
};

template <class T> nb::object array_of(const std::vector<T>& values) {
  auto* data = new T[values.size()];
  std::ranges::copy(values, data);
  nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
  return nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<1>>(data, {values.size()}, owner));
}

void add_laws(nb::module_&);
void add_contacts(nb::module_&);
void add_materials(nb::module_&);
void add_press(nb::module_&);
void add_measured(nb::module_&);
void add_comparison(nb::module_&);
void add_study(nb::module_&);
void add_pools(nb::module_&);
void add_reproduce(nb::module_&);

} // namespace platen::python
