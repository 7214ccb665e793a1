// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/rays/row_merge.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace findspace::space {

namespace {

/// The next event of a source; its exact place is found once at most.
class Head {
 public:
  explicit Head(const RayEvent& event) : event_(&event) {}
  const RayEvent& event() const { return *event_; }

  static int compare(Head& a, Head& b) {
    const RayPosition &p = a.event_->at, &q = b.event_->at;
    if (!p.roots && !q.roots) return compare_positions(p, q);
    const double gap = p.value - q.value, blur = (p.radius + q.radius) * 2;
    if (gap > blur) return 1;
    if (gap < -blur) return -1;
    if (same_root(p, q)) return 0;
    return exact::compare(a.exactly(), b.exactly());
  }

 private:
  const exact::Real& exactly() {
    if (!exact_) exact_ = event_->at.to_real();
    return *exact_;
  }
  const RayEvent* event_;
  std::optional<exact::Real> exact_;
};

using Combine = std::function<std::int8_t(std::span<const std::int8_t>)>;

/// What is made of the signs of all rows, as they change: a function that is asked for all at once, or a sum.
class AskedAnew {
 public:
  AskedAnew(std::size_t rows, const Combine& combine) : combine_(combine), signs_(rows) {}
  void set(std::size_t row, std::int8_t sign) { signs_[row] = sign; }
  std::int8_t sign() const { return combine_(signs_); }

 private:
  const Combine& combine_;
  std::vector<std::int8_t> signs_;
};

class RunningExtreme {
 public:
  RunningExtreme(std::size_t rows, bool least) : least_(least), signs_(rows), count_{0, rows, 0} {}
  void set(std::size_t row, std::int8_t sign) {
    --count_[place(signs_[row])];
    ++count_[place(sign)];
    signs_[row] = sign;
  }
  std::int8_t sign() const {
    const std::int8_t end = least_ ? -1 : 1;
    if (count_[place(end)] > 0) return end;
    return count_[place(0)] > 0 ? std::int8_t(0) : std::int8_t(-end);
  }

 private:
  static std::size_t place(std::int8_t sign) { return std::size_t(sign + 1); }

  bool least_;
  std::vector<std::int8_t> signs_;
  std::array<std::size_t, 3> count_;
};

class RunningSum {
 public:
  RunningSum(std::size_t rows, const plane::SignSum& sum) : sum_(sum), signs_(rows), now_(sum.first) {
    for (std::size_t k = 0; k < rows; ++k) now_ += sum.of(k, 0);
  }
  void set(std::size_t row, std::int8_t sign) {
    now_ += sum_.of(row, sign) - sum_.of(row, signs_[row]);
    signs_[row] = sign;
  }
  std::int8_t sign() const { return now_ > 0 ? -1 : 1; }

 private:
  const plane::SignSum& sum_;
  std::vector<std::int8_t> signs_;
  std::int32_t now_;
};

/// Which rows have events on each line, or another sign there than where they were left.
class BusyRows {
 public:
  explicit BusyRows(std::span<const RayRow> rows) : start_(rows[0].before.size() + 1, 0) {
    for (const RayRow& row : rows) each(row, [&](std::size_t line) { ++start_[line + 1]; });
    for (std::size_t line = 1; line < start_.size(); ++line) start_[line] += start_[line - 1];
    rows_.resize(start_.back());
    std::vector<std::size_t> at(start_.begin(), start_.end() - 1);
    for (std::size_t k = 0; k < rows.size(); ++k) each(rows[k], [&](std::size_t line) { rows_[at[line]++] = k; });
  }
  std::span<const std::size_t> on(std::size_t line) const {
    return std::span(rows_).subspan(start_[line], start_[line + 1] - start_[line]);
  }

 private:
  /// Calls visit(line) for the lines on which the row is busy; it is on the first one.
  template <class Visit>
  static void each(const RayRow& row, Visit visit) {
    std::int8_t left = 0;
    for (std::size_t line = 0; line < row.before.size(); ++line) {
      const int first = row.first[line], end = row.first[line + 1];
      if (first < end || line == 0 || row.before[line] != left) visit(line);
      left = first < end ? row.events[static_cast<std::size_t>(end) - 1].after : row.before[line];
    }
  }

  std::vector<std::size_t> start_, rows_;
};

/// Several rows walked side by side, line by line.
template <class Function>
class Merge {
 public:
  Merge(std::span<const RayRow> rows, Function function)
      : rows_(rows), busy_(rows), function_(std::move(function)), next_(rows.size()), heads_(rows.size()) {}

  RayRow run() {
    for (std::size_t line = 0; line < rows_[0].before.size(); ++line) {
      begin(line);
      while (!waiting_.empty()) step(line);
      result_.first.push_back(static_cast<int>(result_.events.size()));
    }
    return std::move(result_);
  }

 private:
  void begin(std::size_t line) {
    for (const std::size_t k : busy_.on(line)) {
      function_.set(k, rows_[k].before[line]);
      next_[k] = rows_[k].first[line];
      advance(line, k);
    }
    last_ = function_.sign();
    result_.before.push_back(last_);
  }

  /// The next event of row k becomes its head and waits.
  void advance(std::size_t line, std::size_t k) {
    heads_[k].reset();
    if (next_[k] == rows_[k].first[line + 1]) return;
    heads_[k].emplace(rows_[k].events[static_cast<std::size_t>(next_[k]++)]);
    waiting_.push_back(k);
    std::push_heap(waiting_.begin(), waiting_.end(), [this](std::size_t a, std::size_t b) { return is_after(a, b); });
  }

  /// Of two rows at one position the one with the smaller number comes first.
  bool is_after(std::size_t a, std::size_t b) {
    const int order = Head::compare(*heads_[a], *heads_[b]);
    return order != 0 ? order > 0 : a > b;
  }

  /// The rows whose heads come first, all at one position, wait no more.
  void take_first() {
    at_once_.clear();
    do {
      std::pop_heap(waiting_.begin(), waiting_.end(), [this](std::size_t a, std::size_t b) { return is_after(a, b); });
      at_once_.push_back(waiting_.back());
      waiting_.pop_back();
    } while (!waiting_.empty() && Head::compare(*heads_[waiting_.front()], *heads_[at_once_[0]]) == 0);
  }

  /// Passes the next position where a row has an event.
  void step(std::size_t line) {
    take_first();
    const RayPosition at = heads_[at_once_[0]]->event().at;
    for (const std::size_t k : at_once_) function_.set(k, heads_[k]->event().here);
    const std::int8_t now = function_.sign();
    for (const std::size_t k : at_once_) {
      function_.set(k, heads_[k]->event().after);
      advance(line, k);
    }
    const std::int8_t then = function_.sign();
    if (now != last_ || then != last_) result_.events.push_back({at, now, then});
    last_ = then;
  }

  std::span<const RayRow> rows_;
  BusyRows busy_;
  Function function_;
  std::vector<int> next_;
  std::vector<std::optional<Head>> heads_;
  std::vector<std::size_t> waiting_, at_once_;  // rows: a heap, the first head on top; those of one position
  std::int8_t last_ = 0;
  RayRow result_;
};

}  // namespace

RayRow combined(std::span<const RayRow> rows, const Combine& combine) {
  return Merge(rows, AskedAnew(rows.size(), combine)).run();
}

RayRow extreme(std::span<const RayRow> rows, bool least) {
  return Merge(rows, RunningExtreme(rows.size(), least)).run();
}

RayRow summed(std::span<const RayRow> rows, const plane::SignSum& sum) {
  return Merge(rows, RunningSum(rows.size(), sum)).run();
}

}  // namespace findspace::space
