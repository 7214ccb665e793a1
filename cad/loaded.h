// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Whether Open CASCADE understood all that the shapes of a file are made of. It drops what it does not know, and parts
// without a word, so a model is checked twice. Before it is translated: no entity that a shape or its place in an
// assembly is made of failed to load, and none is of an unknown kind; nor does one of an unknown kind refer to a
// product, a representation or a relationship of such. After it: every solid of the file became a shape. Cost: linear
// in the entities and their references. Keywords: STEP, IGES, check list, XSTEP.
#pragma once

#include <XSControl_WorkSession.hxx>

namespace findspace::cad {

/// Throw Problem, with the entity and the reason.
void require_loaded(const Handle(XSControl_WorkSession) & session);
void require_translated(const Handle(XSControl_WorkSession) & session);

}  // namespace findspace::cad
