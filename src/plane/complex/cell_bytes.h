// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Cell complexes as bytes: all numbers, exact and filtering ones, as they are. Guarantee: the complex that is read
// answers every question as the one that was written, with the same numbering. Complexes with irrational numbers are
// refused: an expression has no bytes. Cost: linear. Keywords: serialisation.
#pragma once

#include <optional>

#include "plane/base/bytes.h"
#include "plane/complex/cell_complex.h"

namespace findspace::plane {

/// False where the number is not a fraction that fits.
bool put_real(const exact::Real& value, ByteWriter& out);
exact::Real take_real(ByteReader& in);

/// False where it has no bytes; what was put is then of no use.
bool put_cells(const CellComplex& cells, ByteWriter& out);
std::optional<CellComplex> take_cells(ByteReader& in);

}  // namespace findspace::plane
