// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/cad/cad_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <string_view>
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

struct Library {
  ReadCad* read = nullptr;
  std::string why;  // it is there and cannot be loaded
};

Library load() {
  const std::filesystem::path here = own_folder();
  Library out;
  const auto open = [&](const char* path) {
    void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) out.read = reinterpret_cast<ReadCad*>(dlsym(library, kReadCad));
    return out.read != nullptr;
  };
  for (const std::filesystem::path& folder : {here, here.parent_path().parent_path()}) {  // a module lies deeper
    std::error_code none;
    if (folder.empty() || !std::filesystem::exists(folder / kCadLibrary, none)) continue;
    if (open((folder / kCadLibrary).c_str())) return out;
    // NOLINTNEXTLINE(concurrency-mt-unsafe): each thread has its own message
    if (const char* const said = dlerror(); said != nullptr) out.why = said;
  }
  if (open(kCadLibrary)) return out;
  // Where the system has none, it says this of the name itself.
  const char* const said = dlerror();  // NOLINT(concurrency-mt-unsafe): as above
  const std::string absent = std::string(kCadLibrary) + ": cannot open shared object file: No such file";
  if (out.why.empty() && said != nullptr && std::string_view(said).substr(0, absent.size()) != absent) out.why = said;
  return out;
}

}  // namespace

/// Beside the program, or two folders above the Python module, as it is built; else where the system looks.
ReadCad* cad_reader(std::string* why) {
  static const Library kFound = load();
  if (why != nullptr) *why = kFound.why;
  return kFound.read;
}

}  // namespace findspace::io
