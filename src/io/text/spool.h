// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Text that may be longer than memory should hold: it is kept in a file without a name, in the folder TMPDIR or /tmp,
// until it is copied where it belongs. Guarantee: the same bytes; Error(kFile) where the disk does not take them.
// Keywords: temporary file, stream.
#pragma once

#include <cstdio>
#include <functional>
#include <memory>
#include <string_view>

namespace findspace::io {

/// Where text goes, piece by piece.
using Sink = std::function<void(std::string_view)>;

class Spool {
 public:
  void append(std::string_view text);
  bool empty() const { return size_ == 0; }
  void copy_to(const Sink& sink) const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;  // made by the first text
  std::size_t size_ = 0;
};

}  // namespace findspace::io
