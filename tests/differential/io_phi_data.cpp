// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The convex polytopes of Stoyan 2004 and 2005 and of Egeblad 2009: all ordered pairs. gamma12 equals the hull of all
// differences, is closed, and its contact types change places with the bodies.
#include <findspace/error.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "differential/space_oracle.h"
#include "io/mesh/read_mesh.h"

namespace findspace {
namespace io_phi_data {

using space::Contact;
using space::ContactSurface;
using space::Polytope;

std::vector<Polytope> read_all() {
  const std::filesystem::path root = std::filesystem::path(FINDSPACE_SHARED) / "data" / "3d";
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"stoyan2004/convex", "stoyan2005", "egeblad2009/Merged"}) {
    if (!std::filesystem::exists(root / folder)) continue;
    for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("polytope") || (name.starts_with("Convex") && name.ends_with(".stl")))
        files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<Polytope> polytopes;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    io::ReadContext context;
    // The hull is the shape meant (polytope7 has a vertex that no face uses).
    polytopes.push_back(Polytope::hull(io::parse_mesh(bytes, file.extension().string(), context, [](const auto&) {
                                         return exact::Real(1);
                                       }).vertices));
  }
  return polytopes;
}

std::array<int, 6> counts(const ContactSurface& s) {
  std::array<int, 6> n{};
  for (int f = 0; f < s.facet_count(); ++f) ++n[static_cast<std::size_t>(s.contact(f))];
  return n;
}

TEST(PhiData, AllPairsBothOrders) {
  const std::vector<Polytope> bodies = read_all();
  if (bodies.empty()) GTEST_SKIP() << "no shared data";
  ASSERT_EQ(bodies.size(), 19u);
  for (const Polytope& a : bodies) {
    for (const Polytope& b : bodies) {
      const ContactSurface ab(a, b), ba(b, a);
      ASSERT_FALSE(ab.fault().has_value()) << *ab.fault();
      ASSERT_TRUE(plain(ab, false) == plain(hull_of_differences(a, b)));
      ASSERT_TRUE(plain(ab, true) == three_stages(a, b));
      const auto [fv, fe, ff, vf, ef, ee] = counts(ab);
      ASSERT_EQ(counts(ba), (std::array<int, 6>{vf, ef, ff, fv, fe, ee}));
    }
  }
}

}  // namespace io_phi_data
}  // namespace findspace
