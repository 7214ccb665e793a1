// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a thread has while somebody lends it: an object that what it calls may ask for. Loans are nested, and the last
// one counts. Guarantee: no other thread has it. Cost: a read of a pointer. Keywords: dynamic scope, ambient context,
// thread-local.
#pragma once

namespace findspace::plane {

/// While it lives, the thread has this T; null: none.
template <class T>
class OfThread {
 public:
  explicit OfThread(T* lent) : before_(now_) { now_ = lent; }
  ~OfThread() { now_ = before_; }
  OfThread(const OfThread&) = delete;
  OfThread& operator=(const OfThread&) = delete;

  /// The one of this thread, or null.
  static T* now() { return now_; }

 private:
  static inline constinit thread_local T* now_ = nullptr;
  T* before_;
};

}  // namespace findspace::plane
