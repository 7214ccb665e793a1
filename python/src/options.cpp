// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "options.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "interruptible.h"
#include "pickles.h"

namespace findspace::python {
namespace {

/// A function of Python that is told of progress. Options are copied where the interpreter's lock is not held.
class Told {
 public:
  explicit Told(const py::object& function)
      : function_(new py::object(function), [](const py::object* o) {
          const py::gil_scoped_acquire held;
          delete o;
        }) {}

  void operator()(double part) const {
    const py::gil_scoped_acquire held;
    (*function_)(part);
  }
  const py::object& function() const { return *function_; }

 private:
  std::shared_ptr<const py::object> function_;
};

std::function<void(double)> progress_of(const py::object& function) {
  if (function.is_none()) return {};
  if (!PyCallable_Check(function.ptr())) throw py::type_error("progress is a function of a number, or None");
  return Told(function);
}

py::object function_of(const Options& o) {
  const Told* told = o.progress.target<Told>();
  return told == nullptr ? py::none() : told->function();
}

Options options_made(unsigned threads, double seconds, std::size_t memory, const py::object& progress,
                     const std::optional<Cancel>& cancel, std::uint64_t seed, double work, std::uint64_t work_limit) {
  return {threads, seconds, memory, progress_of(progress), cancel.value_or(Cancel()), seed, work, work_limit};
}

void bind_cancel(py::module_& m) {
  py::class_<Cancel>(m, "Cancel",
                     R"doc(A token that ends the questions that have it, from any thread. A pickle brings another token.

Examples
--------
>>> import findspace as fs
>>> token = fs.Cancel()
>>> world = fs.World({"A": fs.Shape.box((0, 0), (1, 1)), "B": fs.Shape.disc((0, 0), 1)}, "B").limited(cancel=token)
>>> token.request()
>>> try:
...     world.solve("clear(B, A)")
... except fs.Stopped as stopped:
...     print(stopped.limit)
cancelled
>>> token.reset()
>>> world.solve("clear(B, A)").bounded
False
)doc")
      .def(py::init<>())
      .def(py::pickle([](const Cancel& c) { return py::make_tuple(c.requested()); },
                      [](const py::tuple& t) {
                        const Cancel made;
                        if (t[0].cast<bool>()) made.request();
                        return made;
                      }))
      .def("request", &Cancel::request, "Ends what has the token.")
      .def("reset", &Cancel::reset, "Later questions run again.")
      .def_property_readonly("requested", &Cancel::requested, "Whether it is requested.");
}

/// As before the last time that this store was opened.
void close(const ResultStore& store) {
  std::vector<ResultStore>& open = open_stores();
  const auto last =
      std::find_if(open.rbegin(), open.rend(), [&](const ResultStore& s) { return &s.data() == &store.data(); });
  if (last == open.rend()) throw std::runtime_error("this store is not open: use it in 'with'");
  open.erase(std::next(last).base());
}

void bind_store(py::module_& m) {
  py::class_<ResultStore>(m, "ResultStore", R"doc(Results in a folder, kept between runs and shared by processes.

Sums, Phi-functions and what else is costly and depends on its operands alone is looked for there, and kept there, by
what this process asks within ``with``. A result from the store is the bytes of the one that would be made.

Parameters
----------
folder : str
    Made where there is none; it may be shared by machines.
limit : int
    Bytes; the oldest entries go first.

Examples
--------
>>> import findspace as fs, tempfile
>>> with tempfile.TemporaryDirectory() as folder, fs.ResultStore(folder):
...     world = fs.World({"A": fs.Shape.box((0, 0), (9, 9)), "B": fs.Shape.disc((0, 0), 1)}, "B")
...     world.solve("inside(B, A)").area
49.0
)doc")
      .def(py::init([](const std::string& folder, std::uint64_t limit) { return ResultStore(folder, limit); }),
           py::arg("folder"), py::arg("limit") = std::uint64_t{1} << 30)
      .def_property_readonly("folder", &ResultStore::folder, "As it was made.")
      .def_property_readonly("limit", &ResultStore::limit, "In bytes.")
      .def(
          "__enter__",
          [](const ResultStore& s) {
            open_stores().push_back(s);
            return s;
          },
          "What is asked from now on uses it.")
      .def(
          "__exit__", [](const ResultStore& s, const py::args&) { close(s); }, "As before.")
      .def(py::pickle(
          [](const ResultStore& s) { return py::make_tuple(s.folder(), s.limit()); },
          [](const py::tuple& t) { return ResultStore(t[0].cast<std::string>(), t[1].cast<std::uint64_t>()); }))
      .def("__repr__", [](const ResultStore& s) { return "<ResultStore '" + s.folder() + "'>"; });
}

}  // namespace

Options options_of(const std::optional<Options>& given, const py::kwargs& words) {
  if (given && !words.empty()) throw py::type_error("either options or their words are given");
  return given ? *given : py::type::of<Options>()(**words).cast<Options>();
}

void bind_options(py::module_& m) {
  bind_cancel(m);
  bind_store(m);
  py::class_<Options>(m, "Options", R"doc(How much a question may cost, and who hears of it.

Calls that take options take their words as well: ``world.limited(seconds=5)`` is
``world.limited(fs.Options(seconds=5))``. A pickle leaves the token out.

Parameters
----------
threads : int
    0: one for each core.
seconds : float
    Of each question; 0: no limit.
memory : int
    Bytes that the process has in memory; 0: no limit.
progress : callable, optional
    Called with a part from 0 to 1, in questions about many positions.
cancel : Cancel, optional
    A token that ends the question.
seed : int
    Of what is random, packings and samples.
work : float
    Of packings, in million pairs of parts looked at; 0: no limit.
work_limit : int
    Units that explanations and searches in space may cost, as with ``--work-limit``; 0: as many as reading allowed.

Examples
--------
>>> import findspace as fs
>>> fs.Options(seconds=5, seed=7)
<Options threads=0 seconds=5.0 memory=0 seed=7 work=0.0 work_limit=0>
)doc")
      .def(py::init(&options_made), py::kw_only(), py::arg("threads") = 0, py::arg("seconds") = 0.0,
           py::arg("memory") = 0, py::arg("progress") = py::none(), py::arg("cancel") = py::none(), py::arg("seed") = 1,
           py::arg("work") = 0.0, py::arg("work_limit") = 0)
      .def_readwrite("threads", &Options::threads, "0: one for each core.")
      .def_readwrite("seconds", &Options::seconds, "Of each question; 0: no limit.")
      .def_readwrite("memory", &Options::memory, "Bytes that the process has in memory; 0: no limit.")
      .def_property(
          "progress", &function_of, [](Options& o, const py::object& f) { o.progress = progress_of(f); },
          "Called with a part from 0 to 1, or None.")
      .def_property(
          "cancel", [](const Options& o) { return o.cancel; }, [](Options& o, const Cancel& c) { o.cancel = c; },
          "The token that ends the question.")
      .def_readwrite("seed", &Options::seed, "Of what is random.")
      .def_readwrite("work", &Options::work, "Of packings, in million pairs of parts looked at; 0: no limit.")
      .def_readwrite("work_limit", &Options::work_limit, "Units that explanations and searches in space may cost.")
      .def(py::pickle(
          [](const Options& o) {
            return py::make_tuple(o.threads, o.seconds, o.memory, function_of(o), o.seed, o.work, o.work_limit);
          },
          [](const py::tuple& t) {
            return options_made(t[0].cast<unsigned>(), t[1].cast<double>(), t[2].cast<std::size_t>(), t[3],
                                std::nullopt, t[4].cast<std::uint64_t>(), t[5].cast<double>(),
                                t[6].cast<std::uint64_t>());
          }))
      .def("__repr__", [](const Options& o) {
        return py::str("<Options threads={} seconds={} memory={} seed={} work={} work_limit={}>")
            .format(o.threads, o.seconds, o.memory, o.seed, o.work, o.work_limit);
      });
}

}  // namespace findspace::python
