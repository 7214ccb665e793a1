// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The Python module: the public headers, in the same words. Numbers of Python are exact where they are int,
// decimal.Decimal, fractions of ten or text; a float stands for the decimal that it prints as.

#include <pybind11/numpy.h>
#include <pybind11/operators.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "findspace/findspace.h"
#include "options.h"

namespace findspace::python {

void bind_options(py::module_& m);
void bind_shapes(py::module_& m);
void bind_regions(py::module_& m);
void bind_worlds(py::module_& m);
void bind_space(py::module_& m);
void bind_formulas(py::module_& m);
void bind_scenes(py::module_& m);
void bind_files(py::module_& m);
void bind_boards(py::module_& m);
void bind_vocabulary(py::module_& m);
void bind_packings(py::module_& m);
void bind_packing(py::module_& m);
void bind_solid_packing(py::module_& m);

namespace {

/// An exception of the class with what the error says.
py::object made(const py::object& of, const Error& e) {
  static const char* const kCodes[] = {"usage",        "syntax", "unknown name", "bad value", "geometry",
                                       "out of range", "file",   "unsupported",  "limit"};
  py::object out = of(e.what());
  out.attr("message") = e.message();
  out.attr("place") = e.place();
  out.attr("code") = kCodes[static_cast<int>(e.code())];
  py::list points;
  for (const auto& [x, y] : e.geometry()) points.append(py::make_tuple(x, y));
  out.attr("geometry") = points;
  return out;
}

/// Errors get a class, `Stopped` one of its own.
void bind_errors(py::module_& m) {
  static py::exception<Error> error(m, "Error", PyExc_ValueError);
  error.attr("__doc__") =
      "Bad input or wrong usage. `message` says what is wrong, `place` where, `code` of what kind it is, `geometry` "
      "the points that show it.";
  static py::exception<Stopped> stopped(m, "Stopped", error.ptr());
  stopped.attr("__doc__") = "A question that ended at a limit: `limit` is 'time', 'memory' or 'cancelled'.";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Stopped& e) {
      const py::object raised = made(stopped, e);
      raised.attr("limit") = limit_name(e.limit());
      PyErr_SetObject(stopped.ptr(), raised.ptr());
    } catch (const Error& e) {
      PyErr_SetObject(error.ptr(), made(error, e).ptr());
    }
  });
}

}  // namespace

}  // namespace findspace::python

PYBIND11_MODULE(_findspace, m) {
  using namespace findspace::python;
  m.doc() = "Exact maps of where a part can go (https://en.wikipedia.org/wiki/Configuration_space_(physics)).";
  bind_errors(m);
  bind_options(m);
  bind_formulas(m);
  bind_shapes(m);
  bind_regions(m);
  bind_space(m);
  bind_worlds(m);
  bind_files(m);
  bind_scenes(m);
  bind_boards(m);
  bind_vocabulary(m);
  bind_packings(m);
  bind_packing(m);
  bind_solid_packing(m);
}
