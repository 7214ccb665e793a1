// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The text of a scene with another formula and other moving shapes: everything else stays as it was written, comments
// too. Keywords: round trip, editing in place.
#pragma once

#include <string>
#include <vector>

namespace findspace::app {

/// `text` is a scene that was read. Throws Error where it is none.
std::string edited_scene(const std::string& text, const std::string& where, const std::vector<std::string>& moving);

}  // namespace findspace::app
