// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "io/mesh/zip_archive.h"

#include <findspace/error.h>

#include <exception>
#include <memory>

#ifdef FINDSPACE_WITH_ZIP
#include <zip.h>
#endif

namespace findspace::io {

#ifdef FINDSPACE_WITH_ZIP

namespace {

[[noreturn]] void bad_file(const std::string& what) { throw Error(ErrorCode::kFile, what); }

/// What libzip says of an error.
class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ~ZipError() { zip_error_fini(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  zip_error_t* get() { return &error_; }
  [[noreturn]] void raise(const char* what) { bad_file(std::string(what) + ": " + zip_error_strerror(&error_)); }

 private:
  zip_error_t error_{};
};

}  // namespace

std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>& members) {
  ZipError error;
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, error.get());
  if (!target) error.raise("an archive cannot be made");
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, error.get());
  if (!archive) {
    zip_source_free(target);
    error.raise("an archive cannot be made");
  }
  for (const auto& [name, content] : members) {
    zip_source_t* source = zip_source_buffer(archive, content.data(), content.size(), 0);
    const zip_int64_t at = source ? zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    // The first day that the format knows.
    if (at < 0 || zip_file_set_dostime(archive, static_cast<zip_uint64_t>(at), 0, 0x21, 0) != 0) {
      zip_discard(archive);
      zip_source_free(target);
      bad_file("an archive cannot be made");
    }
  }
  std::string bytes;
  bool whole = zip_close(archive) == 0 && zip_source_open(target) == 0;
  if (whole) {
    zip_source_seek(target, 0, SEEK_END);
    bytes.resize(static_cast<std::size_t>(zip_source_tell(target)));
    zip_source_seek(target, 0, SEEK_SET);
    whole = zip_source_read(target, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
    zip_source_close(target);
  }
  zip_source_free(target);
  if (!whole) bad_file("an archive cannot be made");
  return bytes;
}

ZipArchive::ZipArchive(std::string_view bytes) {
  if (bytes.empty()) bad_file("not a ZIP archive: the file is empty");  // libzip would take it for a new one
  ZipError error;
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, error.get());
  if (!source) error.raise("not a ZIP archive");
  archive_ = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, error.get());
  if (archive_) return;
  zip_source_free(source);
  error.raise("not a whole ZIP archive");
}

ZipArchive::~ZipArchive() { zip_discard(static_cast<zip_t*>(archive_)); }

bool ZipArchive::read(const std::string& name, ReadContext& context,
                      const std::function<void(std::string_view)>& take) const {
  constexpr std::size_t kPiece = std::size_t{1} << 19;
  const auto refuse = [&](const char* what) { bad_file("the archive's member " + name + what); };
  auto* archive = static_cast<zip_t*>(archive_);
  const zip_int64_t at = zip_name_locate(archive, name.c_str(), ZIP_FL_NOCASE);
  if (at < 0) return false;
  zip_stat_t stat;
  if (zip_stat_index(archive, static_cast<zip_uint64_t>(at), 0, &stat) != 0 || (stat.valid & ZIP_STAT_SIZE) == 0)
    refuse(" cannot be read");
  context.take_bytes(stat.size, "the archive's member " + name);
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
      zip_fopen_index(archive, static_cast<zip_uint64_t>(at), 0), &zip_fclose);
  if (!file) refuse(" cannot be read");
  std::string piece(kPiece, '\0');
  std::exception_ptr thrown;
  for (zip_uint64_t left = stat.size;;) {
    const zip_int64_t read = zip_fread(file.get(), piece.data(), piece.size());
    const bool last = read == 0;
    if (read < 0 || static_cast<zip_uint64_t>(read) > left || (last && left > 0)) refuse(" is damaged");
    if (last) break;
    left -= static_cast<zip_uint64_t>(read);
    try {
      if (!thrown) take({piece.data(), static_cast<std::size_t>(read)});
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  return true;
}

#else

namespace {

[[noreturn]] void missing() {
  throw Error(ErrorCode::kUnsupported, "this build has no libzip: it neither reads nor writes 3MF files");
}

}  // namespace

std::string zip_bytes(const std::vector<std::pair<std::string, std::string>>&) { missing(); }
ZipArchive::ZipArchive(std::string_view) { missing(); }
ZipArchive::~ZipArchive() = default;
bool ZipArchive::read(const std::string&, ReadContext&, const std::function<void(std::string_view)>&) const {
  missing();
}

#endif

}  // namespace findspace::io
