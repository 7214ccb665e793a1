// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors

#include "in_space/space_commands.h"

#include <memory>
#include <utility>

#include "common/told.h"
#include "in_space/ray_outcome.h"
#include "in_space/space_outcome.h"
#include "io/api/public_scene.h"
#include "io/question/space_map.h"

namespace findspace::app {

Outcome map_space(const Session& session) {
  check_outputs(session.options(), space_formats());
  auto found =
      io::map_of_space(session, {session.options().apply, "--"}, wants_surface(session), io::public_solid_world);
  if (!found) return map_rays(session, lines_unasked(session, "map"));
  session.reporter().stage("writing");
  return told(session, Answer(std::make_shared<const Answer::Data>(*std::move(found))));
}

}  // namespace findspace::app
