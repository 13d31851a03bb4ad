#include "mpm/mesh/patch.hpp"

#include "support/meshes.hpp"

#include <gtest/gtest.h>

namespace terp {
namespace patch_test {

using P = Patch<Quad4>;

Vec<2> place_of(const Mesh<2>& mesh, Index cell, Vec<2> local)
{
  const auto offset = Quad4::offset_from_centre(mesh.geometry(cell).map, local);
  return {mesh.centres[cell][0] + offset[0], mesh.centres[cell][1] + offset[1]};
}

/// Middle of a slot in local coordinates of its cell.
Vec<2> middle_of(int slot) { return {slot % 4 - 1.5, slot / 4 - 1.5}; }

/// The sub-cell that a partner names: that of the other cell which touches the outer sub-cell of the partner.
Vec<2> middle_of_partner(const Mesh<2>& mesh, Index partner)
{
  return place_of(mesh, partner / P::n_outer, middle_of(P::own_slot[P::own_beside[partner % P::n_outer]]));
}

TEST(Patch, OfARegularMeshLiesWhereItsSlotsLie)
{
  const Mesh<2> mesh = make_rectangle({1.0, -2.0}, {3.0, 1.5}, {3, 3});
  const PatchPartners partners = find_patch_partners(mesh);
  for (int k = 0; k < P::n_outer; ++k) {
    ASSERT_NE(partners[4][k], outside);
    const Vec<2> found = middle_of_partner(mesh, partners[4][k]),
                 expected = place_of(mesh, 4, middle_of(P::outer_slot[k]));
    EXPECT_NEAR(found[0], expected[0], 1e-12) << k;
    EXPECT_NEAR(found[1], expected[1], 1e-12) << k;
  }
}

TEST(Patch, OfACellAtTheEdgeEndsThere)
{
  const PatchPartners partners = find_patch_partners(make_rectangle({0.0, 0.0}, {2.0, 2.0}, {2, 2}));
  for (const int k : {0, 1, 6, 7, 8, 9, 11}) EXPECT_EQ(partners[0][k], outside) << k;  // below, left, three corners
  for (const int k : {2, 3, 4, 5, 10}) EXPECT_NE(partners[0][k], outside) << k;
}

TEST(Patch, PartnerOfThePartnerIsWhereItBegan)
{
  const Mesh<2> mesh = test::distorted_rectangle(5, 4, 0.5, 0.2, 7);
  const PatchPartners partners = find_patch_partners(mesh);
  for (Index cell = 0; cell < mesh.n_cells(); ++cell)
    for (int k = 0; k < P::n_outer; ++k)
      if (const Index partner = partners[cell][k]; partner != outside) {
        EXPECT_EQ(partners[partner / P::n_outer][partner % P::n_outer], P::n_outer * cell + k);
      }
}

/// Three cells around a node: a hexagon cut from its middle.
TEST(Patch, HasNoCornerWhereNotFourCellsMeet)
{
  Mesh<2> mesh;
  mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.9}, {-0.5, 0.9}, {-1.0, 0.0}, {-0.5, -0.9}, {0.5, -0.9}};
  mesh.cells = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
  connect(mesh);
  const PatchPartners partners = find_patch_partners(mesh);
  for (Index cell = 0; cell < 3; ++cell) {
    EXPECT_EQ(partners[cell][8], outside);                      // across the middle
    EXPECT_EQ(partners[cell][0] / P::n_outer, (cell + 2) % 3);  // across the side from the middle
    EXPECT_EQ(partners[cell][7] / P::n_outer, (cell + 1) % 3);  // across the side to the middle
  }
}

}  // namespace patch_test
}  // namespace terp
