// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/cad/cad_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace findspace::io {
namespace {

/// Where this code was loaded from.
std::filesystem::path own_folder() {
  std::error_code none;
  Dl_info info{};
  const bool known = dladdr(reinterpret_cast<const void*>(&cad_reader), &info) != 0 && info.dli_fname != nullptr;
  const std::filesystem::path loaded = known ? info.dli_fname : "";
  if (loaded.extension() == ".so") return std::filesystem::canonical(loaded, none).parent_path();
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();  // a program knows no path of its own
}

void* load() {
  const std::filesystem::path here = own_folder();
  for (const std::filesystem::path& folder : {here, here.parent_path().parent_path()}) {  // a module lies deeper
    if (folder.empty() || !std::filesystem::exists(folder / kCadLibrary)) continue;
    if (void* library = dlopen((folder / kCadLibrary).c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  }
  return dlopen(kCadLibrary, RTLD_NOW | RTLD_LOCAL);
}

}  // namespace

/// Beside the program, or two folders above the Python module, as it is built; else where the system looks.
ReadCad* cad_reader() {
  static ReadCad* const kFound = []() -> ReadCad* {
    void* const library = load();
    return library == nullptr ? nullptr : reinterpret_cast<ReadCad*>(dlsym(library, kReadCad));
  }();
  return kFound;
}

}  // namespace findspace::io
