// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
#include "space/mesh/mesh_edges.h"

#include <algorithm>
#include <tuple>

#include "plane/base/small_sort.h"

namespace findspace::space {

MeshEdges::MeshEdges(const Mesh& mesh) : first_(mesh.vertices.size() + 2, 0) {
  const auto lesser = [](int a, int b) { return static_cast<std::size_t>(std::min(a, b)); };
  for (const auto& face : mesh.faces) each_edge(face, [&](int a, int b) { ++first_[lesser(a, b) + 2]; });
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  uses_.resize(first_.back());
  for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
    each_edge(mesh.faces[static_cast<std::size_t>(f)], [&](int a, int b) {
      uses_[first_[lesser(a, b) + 1]++] = {std::max(a, b), f, a < b};
    });
  first_.pop_back();  // now those of vertex v begin at first_[v]
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    plane::small_sort(uses_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
                      uses_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]), [](const Use& s, const Use& t) {
                        return std::tie(s.to, s.face, s.rising) < std::tie(t.to, t.face, t.rising);
                      });
}

std::span<const MeshEdges::Use> MeshEdges::at(int a, int b) const {
  const auto v = static_cast<std::size_t>(std::min(a, b));
  const int to = std::max(a, b);
  const auto begin = uses_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
             end = uses_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]);
  const auto low = std::lower_bound(begin, end, to, [](const Use& u, int key) { return u.to < key; });
  const auto high = std::upper_bound(low, end, to, [](int key, const Use& u) { return key < u.to; });
  return {low, high};
}

int balance(std::span<const MeshEdges::Use> uses) {
  int sum = 0;
  for (const MeshEdges::Use& u : uses) sum += u.rising ? 1 : -1;
  return sum;
}

}  // namespace findspace::space
