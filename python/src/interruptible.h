// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Long work that Ctrl-C ends: it is done in another thread without the interpreter's lock, while this one looks for
// signals. It uses the store that stands open. Cost: that of making a thread, some 20 microseconds.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "findspace/options.h"
#include "findspace/store.h"

namespace findspace::python {

namespace py = pybind11;

/// Those of `with ResultStore(...)`, the innermost last; read and changed with the interpreter's lock.
inline std::vector<ResultStore>& open_stores() {
  static std::vector<ResultStore> stores;
  return stores;
}

/// Whether a signal came whose handler raised.
inline bool signalled() {
  const py::gil_scoped_acquire held;
  return PyErr_CheckSignals() != 0;
}

/// work(), or the exception of the handler of a signal.
template <class Work>
auto interruptible(const Work& work) {
  const Cancel cancel;
  constexpr std::chrono::milliseconds kBetweenLooks{20};
  bool interrupted = false;
  std::optional<decltype(work())> out;
  const std::optional<ResultStore> store = open_stores().empty() ? std::nullopt : std::optional(open_stores().back());
  {
    const py::gil_scoped_release released;
    std::future<void> done = std::async(std::launch::async, [&] {
      const CancelScope scope(cancel);
      const auto kept = store ? std::make_unique<StoreScope>(*store) : nullptr;
      try {
        out.emplace(work());
      } catch (const Stopped&) {
        if (!cancel.requested()) throw;
      }
    });
    while (done.wait_for(kBetweenLooks) != std::future_status::ready) {
      if (interrupted || !signalled()) continue;
      interrupted = true;
      cancel.request();
    }
    done.get();
  }
  if (interrupted) throw py::error_already_set();
  return *std::move(out);
}

}  // namespace findspace::python
