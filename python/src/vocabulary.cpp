// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The words of the formula language in Python.

#include "findspace/vocabulary.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "pickles.h"

namespace findspace::python {

void bind_vocabulary(py::module_& m) {
  py::class_<DistanceWord>(m, "DistanceWord", "One word for a distance.")
      .def(pickled<DistanceWord>(&DistanceWord::word, &DistanceWord::distance, &DistanceWord::symbol,
                                 &DistanceWord::exchanged, &DistanceWord::negated, &DistanceWord::directional))
      .def_readonly("word", &DistanceWord::word, "'gap', 'gamma1'.")
      .def_readonly("distance", &DistanceWord::distance, "The word of the literature for what it is: 'gamma1'.")
      .def_readonly("symbol", &DistanceWord::symbol, "Its letter there, or the word where it has none.")
      .def_readonly("exchanged", &DistanceWord::exchanged, "Its value is that with the shapes exchanged.")
      .def_readonly("negated", &DistanceWord::negated, "Its value is minus that of the distance.")
      .def_readonly("directional", &DistanceWord::directional, "Whether along=, toward= and rotating= are defined.")
      .def("__repr__", [](const DistanceWord& w) { return "<DistanceWord " + w.word + ">"; });
  py::class_<PredicateWord>(m, "PredicateWord", "One word for a distance compared with a level.")
      .def(pickled<PredicateWord>(&PredicateWord::word, &PredicateWord::distance, &PredicateWord::relation,
                                  &PredicateWord::level, &PredicateWord::negated))
      .def_readonly("word", &PredicateWord::word, "'clear'.")
      .def_readonly("distance", &PredicateWord::distance, "The word of the literature: 'gamma1'.")
      .def_readonly("relation", &PredicateWord::relation, "How it is compared: '<' '<=' '=' '!=' '>=' '>'.")
      .def_property_readonly(
          "level",
          [](const PredicateWord& w) {
            static constexpr const char* kLevels[] = {"none", "optional", "required"};
            return kLevels[std::size_t(w.level)];
          },
          "Whether a level is the third argument: 'none', 'optional' or 'required'; 0 where it is left out.")
      .def_readonly("negated", &PredicateWord::negated, "Whether it is compared with minus the level.")
      .def("__repr__", [](const PredicateWord& w) { return "<PredicateWord " + w.word + ">"; });
  m.def("distance_words", &distance_words, R"doc(All words for distances; those of the literature come first.

Examples
--------
>>> import findspace as fs
>>> next((w.distance, w.symbol) for w in fs.distance_words() if w.word == "gap")
('gamma1', 'γ₁')
)doc");
  m.def("usual_distance_words", &usual_distance_words, "Those that most people ask for.");
  m.def("predicate_words", &predicate_words, R"doc(All words for predicates.

Examples
--------
>>> import findspace as fs
>>> next((w.distance, w.relation, w.level) for w in fs.predicate_words() if w.word == "clear")
('gamma1', '>=', 'optional')
)doc");
  m.def("unit_words", &unit_words, "Of lengths: 'um', 'mm', and so on.");
  m.def("nearest_word", &nearest_word, py::arg("word"), py::arg("candidates"),
        R"doc(The candidate that was probably meant, by edit distance; '' where none is near enough.

Examples
--------
>>> import findspace as fs
>>> fs.nearest_word("gapp", [w.word for w in fs.distance_words()])
'gap'
)doc");
}

}  // namespace findspace::python
