// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The public store of results.

#include <findspace/store.h>

#include "io/store/result_file.h"

namespace findspace {

struct ResultStore::Data {
  std::string folder;
  std::uint64_t limit;
  mutable io::ResultFile file;  // which threads share

  Data(const std::string& f, std::uint64_t most) : folder(f), limit(most), file(f, most) {}
};

ResultStore::ResultStore(const std::string& folder, std::uint64_t limit)
    : data_(std::make_shared<const Data>(folder, limit)) {}
const std::string& ResultStore::folder() const { return data_->folder; }
std::uint64_t ResultStore::limit() const { return data_->limit; }

struct StoreScope::Data {
  ResultStore store;
  plane::ScopedResultStore kept{&store.data().file};
};

StoreScope::StoreScope(const ResultStore& store) : data_(new Data{store}) {}
StoreScope::~StoreScope() = default;

}  // namespace findspace
