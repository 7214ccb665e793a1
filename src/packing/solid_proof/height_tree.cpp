// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//

#include "packing/solid_proof/height_tree.h"

#include <algorithm>
#include <cmath>

#include "exact/margins/packing.h"

namespace findspace::packing {
namespace {

constexpr double kNear = 0.25;  // of the floor: pairs farther apart are not looked at. Found by trial
constexpr double kGain = 3;     // a plane that comes up to what is asked promises exp(-kGain) of a tree. Found by trial

}  // namespace

HeightTree::HeightTree(const HeightChoices& choices) : choices_(&choices) {
  Branch root{GrowingProgram(choices.rows()), {}};
  for (const std::size_t row : choices.always()) root.program.add(row);
  for (const Choice& choice : choices.choices()) root.open.push_back(choice.rows);
  begins_ = std::move(root);
}

HeightTree::HeightTree(const HeightChoices& choices, Branch branch) : choices_(&choices), begins_(std::move(branch)) {}

double HeightTree::bound() const {
  double result = least_;
  if (begins_) result = std::min(result, begins_->program.bound());
  if (!frames_.empty()) result = std::min(result, frames_[0].branch.program.bound());
  return result;
}

void HeightTree::visit(double below, std::size_t nodes) {
  for (std::size_t k = 0; k < nodes && !is_over() && found_.empty(); ++k) {
    std::optional<Branch> branch = begins_ ? std::exchange(begins_, std::nullopt) : next(below);
    if (branch) enter(*std::move(branch), below);
  }
}

std::vector<HeightTree> HeightTree::divided(double below) {
  std::vector<HeightTree> result;
  visit(below, 1);
  while (!frames_.empty())
    if (auto branch = next(below)) result.push_back(HeightTree(*choices_, *std::move(branch)));
  return result;
}

std::optional<HeightTree::Branch> HeightTree::next(double below) {
  Frame& frame = frames_.back();
  if (frame.rows.empty() || !frame.branch.program.solve(below)) {
    frames_.pop_back();
    return std::nullopt;
  }
  const std::size_t row = frame.rows.back();
  frame.rows.pop_back();
  Branch result = frame.branch;
  result.program.add(row);
  frame.branch.program.add(row + 1);
  return result;
}

std::vector<std::size_t> HeightTree::near(const Branch& branch) const {
  std::vector<std::pair<double, std::size_t>> found;
  for (std::size_t c = 0; c < branch.open.size(); ++c) {
    if (branch.open[c].empty()) continue;
    const double overlap = choices_->overlap(choices_->choices()[c], branch.program.vertex());
    if (overlap > -kNear * choices_->size()) found.emplace_back(-overlap, c);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::size_t> result;
  if (found.empty() || -found[0].first <= margin::kNoOverlap * choices_->size()) return result;
  for (const auto& [overlap, choice] : found) result.push_back(choice);
  return result;
}

HeightTree::Look HeightTree::look(Branch& branch, std::size_t choice, double below) {
  Look result;
  const double bound = branch.program.bound();
  std::vector<std::size_t> left;
  for (const std::size_t row : branch.open[choice]) {
    GrowingProgram trial = branch.program;
    trial.add(row);
    ++programs_;
    if (!trial.solve(below)) {
      branch.program.add(row + 1);
      continue;
    }
    left.push_back(row);
    result.planes.emplace_back(trial.bound(), row);
    result.size += std::exp(-kGain * (trial.bound() - bound) / (below - bound));
  }
  branch.open[choice] = std::move(left);
  std::sort(result.planes.begin(), result.planes.end());
  return result;
}

void HeightTree::enter(Branch branch, double below) {
  while (branch.program.solve(below)) {
    const std::vector<std::size_t> near_by = near(branch);
    if (near_by.empty()) {
      found_ = branch.program.vertex();
      least_ = std::min(least_, branch.program.bound());
      return;
    }
    std::optional<std::pair<Look, std::size_t>> best;
    bool is_made = false;
    for (const std::size_t choice : near_by) {
      Look look = this->look(branch, choice, below);
      if (look.planes.empty()) return;
      is_made = look.planes.size() == 1;
      if (is_made) {
        branch.program.add(look.planes[0].second);
        branch.open[choice].clear();
        break;
      }
      if (!best || look.size < best->first.size) best = {std::move(look), choice};
    }
    if (is_made) continue;
    const auto& [look, choice] = *best;
    branch.open[choice].clear();
    Frame& frame = frames_.emplace_back(Frame{std::move(branch), {}});
    for (auto plane = look.planes.rbegin(); plane != look.planes.rend(); ++plane) frame.rows.push_back(plane->second);
    return;
  }
}

}  // namespace findspace::packing
