// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "space/rays/row_bytes.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace findspace::space {
namespace {

struct Event {
  double value, radius;
  exact::Fraction exact;
  std::int32_t patch, i, j, roots;  // roots: which of the row, or -1
  std::int8_t which, here, after;
};
static_assert(std::is_trivially_copyable_v<Event>);

template <class T>
void put(const T* items, std::size_t count, std::string& out) {
  const std::uint64_t size = count;
  out.append(reinterpret_cast<const char*>(&size), sizeof size);
  if (count > 0) out.append(reinterpret_cast<const char*>(items), count * sizeof(T));
}

template <class T>
std::vector<T> take(std::string_view& bytes) {
  std::uint64_t count = 0;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  std::vector<T> out(count);
  if (count > 0) std::memcpy(static_cast<void*>(out.data()), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return out;
}

/// Those of a row in the order in which they come.
std::vector<const RayRoots*> roots_of(const RayRow& row) {
  std::vector<const RayRoots*> out;
  for (const RayEvent& e : row.events)
    if (e.at.roots != nullptr && std::find(out.begin(), out.end(), e.at.roots) == out.end()) out.push_back(e.at.roots);
  return out;
}

}  // namespace

void append_bytes(const RayRow& row, std::string& out) {
  const std::vector<const RayRoots*> roots = roots_of(row);
  std::vector<Event> events;
  events.reserve(row.events.size());
  for (const RayEvent& e : row.events) {
    const auto found = std::find(roots.begin(), roots.end(), e.at.roots);
    Event one{};
    one.value = e.at.value;
    one.radius = e.at.radius;
    one.exact = e.at.exact;
    one.patch = e.at.patch;
    one.i = e.at.i;
    one.j = e.at.j;
    one.roots = found == roots.end() ? -1 : static_cast<std::int32_t>(found - roots.begin());
    one.which = e.at.which;
    one.here = e.here;
    one.after = e.after;
    events.push_back(one);
  }
  put(row.before.data(), row.before.size(), out);
  put(row.first.data(), row.first.size(), out);
  put(events.data(), events.size(), out);
}

/// The places of one table of another process, asked of the same table here.
class RowReader::Roots : public RayRoots {
 public:
  Roots(const RaySource& source, int j, int number) : source_(source), row_number_(j), number_(number) {}
  exact::Real root(int patch, int which, int i, int j) const override {
    const std::scoped_lock lock(making_);
    if (here_ == nullptr) here_ = roots_of(source_.row(row_number_)).at(static_cast<std::size_t>(number_));
    return here_->root(patch, which, i, j);
  }

 private:
  const RaySource& source_;
  int row_number_, number_;
  mutable std::mutex making_;
  mutable const RayRoots* here_ = nullptr;
};

RowReader::RowReader(const RaySource& source) : source_(source) {}
RowReader::~RowReader() = default;

const RayRoots* RowReader::roots(int j, int number) {
  std::unique_ptr<Roots>& made = roots_[{j, number}];
  if (!made) made = std::make_unique<Roots>(source_, j, number);
  return made.get();
}

RayRow RowReader::read(int j, std::string_view& bytes) {
  RayRow row;
  row.before = take<std::int8_t>(bytes);
  row.first = take<int>(bytes);
  for (const Event& e : take<Event>(bytes)) {
    RayEvent& one = row.events.emplace_back();
    one.at.value = e.value;
    one.at.radius = e.radius;
    one.at.exact = e.exact;
    one.at.roots = e.roots < 0 ? nullptr : roots(j, e.roots);
    one.at.patch = e.patch;
    one.at.i = e.i;
    one.at.j = e.j;
    one.at.which = e.which;
    one.here = e.here;
    one.after = e.after;
  }
  return row;
}

}  // namespace findspace::space
