// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a scene answers in Python, with what it was asked, so that a pickle asks it again.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "findspace/scene.h"

namespace findspace::python {

namespace py = pybind11;

struct AnswerOf {
  Scene scene;
  std::string verb;
  py::tuple asked;
  Answer answer;
};

/// (at, degrees, time), each None where it is not given.
Pose pose_of(const std::optional<py::sequence>& at, const py::object& degrees, const py::object& time);

/// Asks; what `asked` holds is said at the questions in answers.cpp.
AnswerOf answered(const Scene& scene, const std::string& verb, const py::tuple& asked);

void bind_answer(py::module_& m);

}  // namespace findspace::python
