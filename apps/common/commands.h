// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The verbs. Each reads its scene, writes the files of -o and returns the text for standard output and the exit status.
// Errors are thrown (findspace::Error); then nothing has been written.
#pragma once

#include "common/options.h"
#include "common/reporter.h"

namespace findspace::app {

Outcome run_map(const Options& options, Reporter& reporter);
Outcome run_check(const Options& options, Reporter& reporter);
Outcome run_explain(const Options& options, Reporter& reporter);
Outcome run_measure(const Options& options, Reporter& reporter);
Outcome run_describe(const Options& options, Reporter& reporter);
Outcome run_convert(const Options& options, Reporter& reporter);
Outcome run_place(const Options& options, Reporter& reporter);
Outcome run_serve(const Options& options, Reporter& reporter);
Outcome run_view(const Options& options, Reporter& reporter);
Outcome run_phi_verb(const Options& options, Reporter& reporter);
Outcome run_pack(const Options& options, Reporter& reporter);
Outcome run_verify(const Options& options, Reporter& reporter);
Outcome run_batch(const Options& options, Reporter& reporter);

}  // namespace findspace::app
