// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/number/modular_tower.h"

#include <algorithm>

namespace findspace::exact::detail {

using Coefficients = ModularTower::Coefficients;
using Word = ModularTower::Word;

namespace {

/// x modulo the prime; `inverse` is 2^64 / prime, rounded down.
Word reduced(std::uint64_t x, Word prime, std::uint64_t inverse) {
  const auto q = static_cast<std::uint64_t>((static_cast<unsigned __int128>(x) * inverse) >> 64);
  const std::uint64_t r = x - q * prime;  // below twice the prime
  return Word(r < prime ? r : r - prime);
}

}  // namespace

const std::vector<ModularTower::Word>& tower_primes() {
  static const std::vector<Word> found = [] {
    constexpr Word kTop = Word(1) << 31, kSpan = 16384, kRoot = 46341;
    constexpr std::size_t kMost = 512;
    std::vector<char> composite(kSpan), small(kRoot);
    for (Word d = 2; d < kRoot; ++d) {
      if (small[d] != 0) continue;
      for (Word m = d * d; d < 216 && m < kRoot; m += d) small[m] = 1;
      for (Word m = kTop - kTop % d; kTop - m < kSpan; m -= d) composite[kTop - m] = 1;
    }
    std::vector<Word> out;
    for (Word k = 1; k < kSpan && out.size() < kMost; ++k)
      if (composite[k] == 0) out.push_back(kTop - k);
    return out;
  }();
  return found;
}

Coefficients ModularTower::add_variable(std::vector<Coefficients> relation) {
  Coefficients out(2 * sizes_.back());
  out[sizes_.back()] = 1;
  sizes_.push_back(sizes_.back() * relation.size());
  out.resize(sizes_.back());
  relations_.push_back(std::move(relation));
  return out;
}

Coefficients ModularTower::trimmed(Coefficients a) const {
  std::size_t used = a.size();
  while (used > 0 && a[used - 1] == 0) --used;
  if (used == 0) return {};
  a.resize(*std::lower_bound(sizes_.begin(), sizes_.end(), used));
  return a;
}

Coefficients ModularTower::sum(Coefficients a, const Coefficients& b) const {
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t k = 0; k < b.size(); ++k) {
    const std::uint64_t s = std::uint64_t(a[k]) + b[k];
    a[k] = Word(s < prime_ ? s : s - prime_);
  }
  return trimmed(std::move(a));
}

Coefficients ModularTower::negative(Coefficients a) const {
  for (Word& w : a) w = w == 0 ? 0 : prime_ - w;
  return a;
}

Coefficients ModularTower::flipped(Coefficients a, std::size_t variable) const {
  const std::size_t degree = relations_[variable].size();
  for (std::size_t k = 0; k < a.size(); ++k)
    if (k / sizes_[variable] % degree % 2 != 0 && a[k] != 0) a[k] = prime_ - a[k];
  return a;
}

inline std::span<const Word> ModularTower::trimmed(std::span<const Word> a) const {
  if (a.empty() || a.back() != 0) return a;
  std::size_t used = a.size();
  while (used > 0 && a[used - 1] == 0) --used;
  return used < 2 ? a.first(used) : a.first(*std::lower_bound(sizes_.begin(), sizes_.end(), used));
}

Coefficients ModularTower::product(std::span<const Word> a, std::span<const Word> b) const {
  a = trimmed(a);
  b = trimmed(b);
  if (a.empty() || b.empty()) return {};
  Coefficients out(std::max(a.size(), b.size()));
  std::vector<Word> arena(4 * out.size());  // each level needs less than twice its size, the next at most half of that
  add_product(out.data(), a, b, arena.data());
  return trimmed(std::move(out));
}

void ModularTower::add_product(Word* out, std::span<const Word> a, std::span<const Word> b, Word* arena) const {
  if (a.size() < b.size()) std::swap(a, b);
  if (b.size() == 1) {
    for (std::size_t k = 0; k < a.size(); ++k) out[k] = reduced(out[k] + std::uint64_t(a[k]) * b[0], prime_, inverse_);
    return;
  }
  const std::size_t level = std::size_t(std::lower_bound(sizes_.begin(), sizes_.end(), a.size()) - sizes_.begin()) - 1,
                    block = sizes_[level], degree = relations_[level].size();
  const auto block_of = [&](std::span<const Word> s, std::size_t k) { return trimmed(s.subspan(k * block, block)); };
  if (b.size() <= block) {
    for (std::size_t i = 0; i < degree; ++i) {
      const std::span<const Word> a_i = block_of(a, i);
      if (!a_i.empty()) add_product(out + i * block, a_i, b, arena);
    }
    return;
  }
  const std::size_t length = (2 * degree - 1) * block;
  std::fill_n(arena, length, 0);
  for (std::size_t i = 0; i < degree; ++i) {
    const std::span<const Word> a_i = block_of(a, i);
    for (std::size_t k = 0; !a_i.empty() && k < degree; ++k) {
      const std::span<const Word> b_k = block_of(b, k);
      if (!b_k.empty()) add_product(arena + (i + k) * block, a_i, b_k, arena + length);
    }
  }
  reduce(arena, level, arena + length);
  for (std::size_t k = 0; k < degree * block; ++k) {
    const Word s = out[k] + arena[k];  // below 2^32
    out[k] = s < prime_ ? s : s - prime_;
  }
}

void ModularTower::reduce(Word* blocks, std::size_t level, Word* arena) const {
  const std::vector<Coefficients>& relation = relations_[level];
  const std::size_t block = sizes_[level], degree = relation.size();
  for (std::size_t k = 2 * degree - 1; k-- > degree;) {
    const std::span<const Word> high = trimmed(std::span<const Word>(blocks + k * block, block));
    for (std::size_t i = 0; !high.empty() && i < degree; ++i)
      if (!relation[i].empty()) add_product(blocks + (k - degree + i) * block, high, relation[i], arena);
  }
}

}  // namespace findspace::exact::detail
