// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// DXF as a sequence of groups (a code and a value), and these as entities. In ASCII a group is two lines; in binary
// files a number and a value of the kind that the code says, which becomes the shortest decimal that reads back as it.
// Used by read_dxf.cpp.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "exact/number/real.h"

namespace findspace::io {

/// The order of names of blocks and layers, in which small letters are capital ones.
struct DxfNameOrder {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const;
};
using DxfNames = std::set<std::string, DxfNameOrder>;
bool same_dxf_name(std::string_view a, std::string_view b);

struct DxfGroup {
  int code = 0;
  std::string_view value;  // without blanks around
  int line = 0;            // of the value, from 1; in binary files the number of the group
};

struct DxfEntity {
  std::string_view type;
  int line = 0;
  std::vector<DxfGroup> groups;     // without the type
  std::vector<DxfEntity> vertices;  // of a POLYLINE

  const DxfGroup* find(int code) const;
  std::string_view layer() const;  // "0" where none is given
};

struct DxfBlock {
  DxfEntity head;
  std::vector<DxfEntity> entities;
};

struct DxfDocument {
  std::string name;
  std::deque<std::string> texts;  // what values refer to that do not stand so in the file
  std::optional<int> units;       // $INSUNITS
  DxfNames hidden_layers;         // that are off or frozen
  DxfNames frozen_layers;         // which hide the whole of a block that is inserted on them
  std::map<std::string, DxfBlock, DxfNameOrder> blocks;
  std::vector<DxfEntity> entities;

  /// The number of a group; `missing` where there is none.
  exact::Real number(const DxfEntity& entity, int code, const exact::Real& missing) const;
  exact::Real number(const DxfEntity& entity, int code) const;  // required
  exact::Real number(const DxfGroup& group) const;
  int flags(const DxfEntity& entity, int code) const;
  std::string place(const DxfEntity& entity) const;  // "LINE (part.dxf:120)"
};

/// Throws Error(kSyntax) at "name:line", kFile where the end is missing. The document refers to `text`.
DxfDocument read_dxf_document(std::string_view text, const std::string& name);

}  // namespace findspace::io
