// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "plane/base/result_store.h"

namespace findspace::plane {
namespace {

thread_local ResultStore* store_of_thread = nullptr;

}  // namespace

ResultStore* result_store() { return store_of_thread; }

ScopedResultStore::ScopedResultStore(ResultStore* store) : before_(store_of_thread) { store_of_thread = store; }
ScopedResultStore::~ScopedResultStore() { store_of_thread = before_; }

}  // namespace findspace::plane
