#include "model/bodies/overfull.hpp"
#include "support/test.hpp"

namespace overfull_test {

const Mesh<2> mesh = make_rectangle({0.0, 0.0}, {4.0, 4.0}, {8, 8});  // cells of 0.5 m

CellContents nothing() { return {std::vector<Real>(64, 0.0), std::vector<Real>(64, 0.0)}; }

void add(Vec<2> x, Real volume, CellContents& contents)
{
  const auto cell = static_cast<std::size_t>(8 * static_cast<int>(x[1] / 0.5) + static_cast<int>(x[0] / 0.5));
  contents.volume[cell] += volume;
  contents.largest[cell] = std::max(contents.largest[cell], volume);
}

/// A box of 3 m by 3 m with points that are `apart` from each other, from `first` on, n of them at each place.
CellContents lattice(Real apart, Real first, int n)
{
  CellContents contents = nothing();
  for (Real y = first; y < 3.0; y += apart)
    for (Real x = first; x < 3.0; x += apart)
      for (int k = 0; k < n; ++k) add({x, y}, apart * apart, contents);
  return contents;
}

TEST(Overfull, ALatticeMayLieAcrossTheCellsInAnyWay)
{
  for (const Real apart : {0.1, 0.17, 0.25, 0.33, 0.49, 0.5})
    for (const Real first : {0.01, 0.05, 0.1})
      EXPECT_FALSE(find_overfull(mesh, lattice(apart, first, 1))) << apart << ' ' << first;
}

TEST(Overfull, SoilThatLiesTwiceInOnePlaceIsFound)
{
  for (const Real apart : {0.05, 0.1, 0.17, 0.25}) EXPECT_TRUE(find_overfull(mesh, lattice(apart, 0.05, 2))) << apart;
}

TEST(Overfull, SaysWhereHowMuchAndForHowMuchThereIsRoom)
{
  CellContents contents = lattice(0.1, 0.05, 1);
  for (int k = 0; k < 6; ++k) add({1.25, 1.75}, 0.75, contents);
  const auto found = find_overfull(mesh, contents);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->by_one_point);
  EXPECT_EQ(found->cell, 26);
  EXPECT_THAT(found->around, ElementsAre(17, 18, 19, 25, 26, 27, 33, 34, 35));
  EXPECT_NEAR(found->volume, 2.25 + 4.5, 1e-12);
  EXPECT_NEAR(found->area, 2.25, 1e-12);
  EXPECT_NEAR(found->limit, 2.25 + 6.0 * 0.5 + 1.0, 1e-12);  // a point reaches no farther than a mean cell
}

TEST(Overfull, AtTheSideOfTheMeshThereAreFewerCellsAround)
{
  EXPECT_THAT(cells_around(mesh, 0), ElementsAre(0, 1, 8, 9));
  CellContents contents = nothing();
  for (int k = 0; k < 4; ++k) add({0.1, 0.1}, 0.99, contents);
  EXPECT_FALSE(find_overfull(mesh, contents));  // 1 + 4 * 0.5 + 1 = 4
  add({0.1, 0.1}, 0.05, contents);
  EXPECT_TRUE(find_overfull(mesh, contents));
}

TEST(Overfull, OnePointMayHaveTheVolumeOfFourCells)
{
  CellContents contents = nothing();
  add({1.25, 1.75}, 0.99, contents);
  EXPECT_FALSE(find_overfull(mesh, contents));
  add({1.25, 1.75}, 1.01, contents);
  const auto found = find_overfull(mesh, contents);
  ASSERT_TRUE(found && found->by_one_point);
  EXPECT_EQ(found->volume, 1.01);
  EXPECT_NEAR(found->area, 0.25, 1e-15);
  EXPECT_NEAR(found->limit, 1.0, 1e-15);
}

}  // namespace overfull_test
