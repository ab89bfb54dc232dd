#include "python/errors.hpp"

#include <filesystem>
#include <new>

#include "base/control.hpp"
#include "base/error.hpp"

namespace jointid::python {
namespace {

namespace py = pybind11;

void raise(const InputError& error) {
  const auto& [kind, file, place, problem, remedy] = error.parts();
  const py::object type = py::module_::import("jointid.errors").attr("InputError");
  const py::object object = type(problem, py::arg("file") = file, py::arg("place") = place, py::arg("remedy") = remedy,
                                 py::arg("kind") = kind == ErrorKind::usage ? "usage" : "data", py::arg("what") = error.what());
  PyErr_SetObject(type.ptr(), object.ptr());
}

void raise(const std::filesystem::filesystem_error& error) {
  const py::object object =
      py::reinterpret_borrow<py::object>(PyExc_OSError)(error.code().value(), error.code().message(), error.path1().string());
  PyErr_SetObject(PyExc_OSError, object.ptr());
}

void translate(std::exception_ptr thrown) {
  if (!thrown) return;
  try {
    std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise(error);
  } catch (const Interrupted&) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
  } catch (const std::bad_alloc&) {
    PyErr_SetString(PyExc_MemoryError, "not enough memory; use fewer lines ([frequency] range, step) or fewer DOFs");
  } catch (const std::filesystem::filesystem_error& error) {
    raise(error);
  }
}

}  // namespace

void bind_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace jointid::python
