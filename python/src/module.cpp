#include "core.hpp"

#include "core/catalogue.hpp"
#include "core/interrupt.hpp"
#include "core/version.hpp"
#include "platen/law/error.hpp"

#include <nanobind/stl/string_view.h>

#include <exception>
#include <filesystem>

namespace platen::python {
namespace {

/// Whether a signal handler of Python raised; its exception waits in the thread that asked.
thread_local bool raised = false;

bool python_asks_to_stop() {
  if (raised) return true;
  nb::gil_scoped_acquire lock;
  return raised = PyErr_CheckSignals() != 0;
}

void raise(const char* type, const char* what) {
  PyErr_SetString(nb::module_::import_("platen._errors").attr(type).ptr(), what);
}

void translate(const std::exception_ptr& pointer, void*) {
  try {
    std::rethrow_exception(pointer);
  } catch (const core::InvalidInput& error) {
    raise("InvalidInput", error.what());
  } catch (const law::BadParameter& error) {
    raise("InvalidInput", error.what());
  } catch (const core::ConvergenceError& error) {
    raise("ConvergenceError", error.what());
  } catch (const core::IoError& error) {
    raise("IoError", error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    raise("IoError", error.what());
  } catch (const core::Interrupted&) {
    if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
  }
}

struct Convert {
  nb::object operator()(std::monostate) const { return nb::none(); }
  nb::object operator()(const auto& value) const { return nb::cast(value); }
};

} // namespace

void stop_long_work() { raised = true; }

Signals::Signals() { raised = false; }
Signals::~Signals() { raised = false; }

nb::object object_of(const core::FieldValue& value) { return std::visit(Convert{}, value); }

nb::dict dict_of(const fit::Remarks& remarks) {
  nb::dict result;
  for (const auto& [key, value] : remarks) result[key.c_str()] = object_of(value);
  return result;
}

} // namespace platen::python

NB_MODULE(_core, m) {
  using namespace platen;
  namespace nb = nanobind;
  m.doc() = "The compiled part of platen; its names may change, those of platen do not.";
  nb::set_leak_warnings(false);
  nb::register_exception_translator(python::translate);
  core::ask_for_interrupts(python::python_asks_to_stop);
  m.attr("version") = std::string(core::version);
  m.attr("engine") = core::engine;
  m.def("card_names", &core::card_names, nb::arg("folder"), "Cards of a folder of the catalogue.");
  python::add_laws(m);
  python::add_contacts(m);
  python::add_materials(m);
  python::add_press(m);
  python::add_measured(m);
  python::add_comparison(m);
  python::add_study(m);
  python::add_pools(m);
  python::add_reproduce(m);
}
