#include "model/bodies/cut_cell.hpp"
#include "support/meshes.hpp"

namespace cut_cell_test {

Polygon box(Vec<2> low, Vec<2> high) { return {low, {high[0], low[1]}, high, {low[0], high[1]}}; }

/// The square from -1 to 1, so that places are local coordinates.
const CellGeometry<Quad4> square = make_cell_geometry<Quad4>({{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}});

void expect_piece(const Piece& piece, Vec<2> x, Real volume, bool is_whole)
{
  for (int d = 0; d < 2; ++d) EXPECT_NEAR(piece.x[d], x[d], 1e-14);
  EXPECT_NEAR(piece.volume, volume, 1e-14);
  EXPECT_EQ(piece.is_whole, is_whole);
}

TEST(Lattice, PartsHaveTheVolumeOfTheirStraightSidedQuadrilateral)
{
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    const auto cell = make_cell_geometry<Quad4>(distorted_square(0.3, random));
    const Lattice lattice{cell, {4, 3}};
    Real sum = 0.0;
    for (Index row = 0; row < 3; ++row)
      for (Index column = 0; column < 4; ++column) {
        Polygon part;
        for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          const auto x =
              Quad4::offset_from_centre(cell.map, Vec<2>{-1.0 + 0.5 * (column + i), -1.0 + 2.0 / 3.0 * (row + j)});
          part.push_back({x[0], x[1]});
        }
        ASSERT_NEAR(volume_of_part(lattice, {column, row}), signed_area(part), 1e-15);
        sum += signed_area(part);
      }
    ASSERT_NEAR(sum, cell.volume, 1e-14);
  }
}

TEST(CutCell, KeepsWholePartsOnTheLatticeAndPutsPiecesAtTheirCentroids)
{
  const Overlay overlay{-1, {{box({-3.0, -3.0}, {0.5, 3.0}), 4, false}}};  // cuts the right column in half
  const auto pieces = cut_cell({square, {2, 2}}, overlay, 4);
  ASSERT_THAT(pieces, SizeIs(4));
  expect_piece(pieces[0], {-0.5, -0.5}, 1.0, true);
  expect_piece(pieces[1], {0.25, -0.5}, 0.5, false);
  expect_piece(pieces[2], {-0.5, 0.5}, 1.0, true);
  expect_piece(pieces[3], {0.25, 0.5}, 0.5, false);
}

TEST(CutCell, MergesASliverIntoTheNearestPieceAndKeepsTheirCentroid)
{
  const Overlay overlay{-1, {{box({-3.0, -3.0}, {0.1, 3.0}), 0, false}}};  // a tenth of the right column
  const auto pieces = cut_cell({square, {2, 2}}, overlay, 0);
  ASSERT_THAT(pieces, SizeIs(2));
  expect_piece(pieces[0], {-0.45, -0.5}, 1.1, false);
  expect_piece(pieces[1], {-0.45, 0.5}, 1.1, false);
}

TEST(CutCell, MergesBelowAFifthAndNotAbove)
{
  const auto pieces_to = [](Real x) {
    return cut_cell({square, {2, 2}}, {-1, {{box({-3.0, -3.0}, {x, 3.0}), 0, false}}}, 0).size();
  };
  EXPECT_EQ(pieces_to(0.199), 2u);
  EXPECT_EQ(pieces_to(0.201), 4u);
}

TEST(CutCell, LetsASliverStayWhereNothingCanTakeIt)
{
  const auto pieces = cut_cell({square, {2, 2}}, Overlay{-1, {{box({-3.0, -3.0}, {-0.9, -0.9}), 0, false}}}, 0);
  ASSERT_THAT(pieces, SizeIs(1));
  expect_piece(pieces[0], {-0.95, -0.95}, 0.01, false);
  EXPECT_TRUE(pieces[0].stays_alone);
}

TEST(CutCell, DoesNotMergeAcrossAGap)
{
  const Overlay overlay{0, {{box({-0.3, -3.0}, {0.9, 3.0}), 1, false}}};  // a ditch between 0.7 and 0.1
  const auto pieces = cut_cell({square, {2, 1}}, overlay, 0);
  ASSERT_THAT(pieces, SizeIs(2));
  expect_piece(pieces[0], {-0.65, 0.0}, 1.4, false);
  expect_piece(pieces[1], {0.95, 0.0}, 0.2, false);
  EXPECT_TRUE(pieces[1].stays_alone);
}

TEST(CutCell, TakesAnOutlineAlongTheLatticeForWhatItIsMeant)
{
  const auto pieces = cut_cell({square, {2, 2}}, Overlay{-1, {{box({-3.0, -3.0}, {1e-12, 1.0 - 1e-12}), 0, false}}}, 0);
  ASSERT_THAT(pieces, SizeIs(2));
  expect_piece(pieces[0], {-0.5, -0.5}, 1.0, true);
  expect_piece(pieces[1], {-0.5, 0.5}, 1.0, true);
}

TEST(CutCell, GivesABodyThatIsCoveredNothing)
{
  EXPECT_THAT(cut_cell({square, {3, 3}}, {0, {{box({-3.0, -3.0}, {3.0, 3.0}), 1, false}}}, 0), IsEmpty());
}

}  // namespace cut_cell_test
