// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/compaction/linear_program.h"

#include <ClpSimplex.hpp>

#include "exact/margins/packing.h"

namespace findspace::packing {

LinearProgram::LinearProgram(double unit) : unit_(unit) {}
LinearProgram::~LinearProgram() = default;

int LinearProgram::add_column(double low, double high, double cost) {
  low_.push_back(low / unit_);
  high_.push_back(high / unit_);
  cost_.push_back(cost);
  return int(low_.size()) - 1;
}

void LinearProgram::begin_row(double least) {
  starts_.push_back(int(columns_.size()));
  least_.push_back(least / unit_);
}

void LinearProgram::add(int column, double factor) {
  if (factor == 0) return;
  columns_.push_back(column);
  factors_.push_back(factor);
}

bool LinearProgram::solve() {
  std::vector<CoinBigIndex> starts(starts_.begin(), starts_.end());
  starts.push_back(CoinBigIndex(columns_.size()));
  const int rows = int(least_.size());
  std::vector<int> lengths;
  for (int r = 0; r < rows; ++r) lengths.push_back(int(starts[std::size_t(r) + 1] - starts[std::size_t(r)]));
  const CoinPackedMatrix matrix(false, int(low_.size()), rows, CoinBigIndex(columns_.size()), factors_.data(),
                                columns_.data(), starts.data(), lengths.data());
  const std::vector<double> most(least_.size(), COIN_DBL_MAX);
  ClpSimplex clp;
  clp.setLogLevel(0);
  clp.setPrimalTolerance(margin::kProgramTolerance);
  clp.loadProblem(matrix, low_.data(), high_.data(), cost_.data(), least_.data(), most.data());
  clp.dual();
  if (clp.status() != 0) return false;
  const double* values = clp.primalColumnSolution();
  solution_.assign(values, values + low_.size());
  return true;
}

}  // namespace findspace::packing
