// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Polynomials in variables t_0, t_1, ..., each with a relation t_i^n_i = r_0 + r_1 t_i + ... whose coefficients are
// polynomials in the variables before it, modulo a prime. Cost: for D coefficients at most some D^2 products of words,
// fewer where a polynomial has not all variables. Internal to src/exact. Keywords: triangular set, quotient ring.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace findspace::exact::detail {

class ModularTower {
 public:
  using Word = std::uint32_t;
  /// Of the products of powers of the variables, the first one's running fastest; only as many as the last variable
  /// that occurs needs, none for 0.
  using Coefficients = std::vector<Word>;

  /// The prime is below 2^31.
  explicit ModularTower(Word prime) : prime_(prime), inverse_(~std::uint64_t(0) / prime) {}

  Word prime() const { return prime_; }
  /// Adds the next variable, given the r_k; returns it.
  Coefficients add_variable(std::vector<Coefficients> relation);

  Coefficients sum(Coefficients a, const Coefficients& b) const;
  Coefficients negative(Coefficients a) const;
  /// With another sign of the variable.
  Coefficients flipped(Coefficients a, std::size_t variable) const;
  Coefficients product(std::span<const Word> a, std::span<const Word> b) const;

 private:
  Coefficients trimmed(Coefficients a) const;
  /// The same polynomial; none for 0.
  std::span<const Word> trimmed(std::span<const Word> a) const;
  /// Adds a b, trimmed and neither 0, to as many coefficients as the larger has. `arena` has space for four times
  /// as many.
  void add_product(Word* out, std::span<const Word> a, std::span<const Word> b, Word* arena) const;
  /// Of 2 n - 1 coefficients of the variable with that index, n is its degree, to the first n.
  void reduce(Word* blocks, std::size_t level, Word* arena) const;

  Word prime_;
  std::uint64_t inverse_;              // 2^64 / prime
  std::vector<std::size_t> sizes_{1};  // how many coefficients the first so many variables need
  std::vector<std::vector<Coefficients>> relations_;
};

/// The 512 largest primes below 2^31, descending.
const std::vector<ModularTower::Word>& tower_primes();

}  // namespace findspace::exact::detail
