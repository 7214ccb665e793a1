// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// ZIP archives in memory, by libzip. Written archives carry no time, so the same content gives the same bytes. A build
// without libzip says so with Error(kUnsupported). Errors: Error(kFile) for what is not a whole archive, for members
// that are missing, encrypted or damaged, and kLimit for those too large. Keywords: container, deflate, OPC package.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/text/read_context.h"

namespace findspace::io {

/// Members by name and content, in order.
std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& members);

class ZipArchive {
 public:
  /// Keeps a view of the bytes.
  explicit ZipArchive(std::string_view bytes);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// Gives the content of a member in pieces, whose bytes the context counts before they are unpacked; false if there
  /// is none of that name. Where a damaged member makes `take` throw, the damage is what is reported.
  bool read(const std::string& name, ReadContext& context, const std::function<void(std::string_view)>& take) const;

 private:
  void* archive_ = nullptr;
};

}  // namespace findspace::io
