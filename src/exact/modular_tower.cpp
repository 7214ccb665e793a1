// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "exact/modular_tower.h"

#include <algorithm>

namespace findspace::exact::detail {

using Coefficients = ModularTower::Coefficients;

namespace {

bool is_zero(std::span<const ModularTower::Word> a) {
  return std::all_of(a.begin(), a.end(), [](ModularTower::Word w) { return w == 0; });
}

}  // namespace

const std::vector<ModularTower::Word>& tower_primes() {
  using Word = ModularTower::Word;
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

Coefficients ModularTower::product(std::span<const Word> a, std::span<const Word> b) const {
  if (a.size() < b.size()) std::swap(a, b);
  if (is_zero(b) || is_zero(a)) return {};
  if (a.size() == 1) return {Word(std::uint64_t(a[0]) * b[0] % prime_)};
  const std::size_t level = std::size_t(std::lower_bound(sizes_.begin(), sizes_.end(), a.size()) - sizes_.begin()) - 1,
                    block = sizes_[level];
  const auto block_of = [block](std::span<const Word> s, std::size_t k) { return s.subspan(k * block, block); };
  std::vector<Coefficients> blocks;
  if (b.size() <= block) {
    for (std::size_t i = 0; i < a.size() / block; ++i) blocks.push_back(product(block_of(a, i), b));
    return joined(blocks, block);
  }
  blocks.resize(a.size() / block + b.size() / block - 1);
  for (std::size_t i = 0; i < a.size() / block; ++i)
    for (std::size_t k = 0; k < b.size() / block; ++k)
      blocks[i + k] = sum(std::move(blocks[i + k]), product(block_of(a, i), block_of(b, k)));
  reduce(blocks, relations_[level]);
  return joined(blocks, block);
}

void ModularTower::reduce(std::vector<Coefficients>& blocks, const std::vector<Coefficients>& relation) const {
  const std::size_t degree = relation.size();
  for (std::size_t k = blocks.size(); k-- > degree;) {
    for (std::size_t i = 0; i < degree; ++i) {
      Coefficients& to = blocks[k - degree + i];
      to = sum(std::move(to), product(blocks[k], relation[i]));
    }
    blocks.pop_back();
  }
}

Coefficients ModularTower::joined(const std::vector<Coefficients>& blocks, std::size_t block) const {
  Coefficients out(blocks.size() * block);
  for (std::size_t k = 0; k < blocks.size(); ++k)
    std::copy(blocks[k].begin(), blocks[k].end(), out.begin() + std::ptrdiff_t(k * block));
  return trimmed(std::move(out));
}

}  // namespace findspace::exact::detail
