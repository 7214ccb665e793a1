// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "common/stop_on_interrupt.h"

namespace findspace::app {
namespace {

const Cancel stop_wanted;

extern "C" void on_stop(int) { stop_wanted.request(); }

}  // namespace

StopOnInterrupt::StopOnInterrupt() {
  struct sigaction action {};
  action.sa_handler = on_stop;
  sigaction(SIGINT, &action, &interrupt_);
  sigaction(SIGTERM, &action, &terminate_);
}

StopOnInterrupt::~StopOnInterrupt() {
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
}

const Cancel& StopOnInterrupt::wanted() { return stop_wanted; }

}  // namespace findspace::app
