// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A thousand random regions in every format of drawings.
#include "law/io_read_back.h"

namespace findspace::io {
namespace io_read_back_all {

TEST(ReadBack, AThousandRegions) { expect_read_back(0, 1000); }

}  // namespace io_read_back_all
}  // namespace findspace::io
