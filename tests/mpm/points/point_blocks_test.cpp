#include "mpm/points/point_blocks.hpp"
#include "support/random.hpp"

namespace point_blocks_test {

constexpr int n_state = 2;

/// Values that tell point and row apart: 1000 id + row.
std::vector<Real> values_of(int id, const PointBlocks<2>& points)
{
  std::vector<Real> values(points.n_rows());
  for (int r = 0; r < points.n_rows(); ++r) values[r] = 1000.0 * id + r;
  values[Rows::id] = id;
  return values;
}

std::vector<Real> read(const PointBlock<2>& block, Index lane, int n_rows)
{
  std::vector<Real> values;
  for (int r = 0; r < n_rows; ++r) values.push_back(block.row(r)[lane]);
  return values;
}

/// Where each point is: id -> (cell, material), found by walking all blocks and checking every value on the way.
std::map<int, std::pair<Index, Index>> whereabouts(const PointBlocks<2>& points)
{
  std::map<int, std::pair<Index, Index>> found;
  for_each_point(points, [&](const PointBlock<2>& block, Index lane) {
    const auto values = read(block, lane, points.n_rows());
    const int id = static_cast<int>(values[Rows::id]);
    EXPECT_EQ(values, values_of(id, points));
    EXPECT_TRUE(found.emplace(id, std::pair(block.cell, block.material)).second) << "point " << id << " is there twice";
  });
  return found;
}

void expect_empty_padding(const PointBlocks<2>& points)
{
  for (const Index cell : points.occupied())
    for_each_block(points, cell, [&](const PointBlock<2>& block, Index) {
      for (Index lane = block.n; lane < block.capacity; ++lane)
        for (int r = 0; r < points.n_rows(); ++r)
          EXPECT_EQ(block.row(r)[lane], 0.0) << "row " << r << ", lane " << lane;
    });
}

TEST(PointBlocks, KeepEveryValueWhileABlockGrows)
{
  PointBlocks<2> points(3, n_state);
  for (int id = 0; id < 29; ++id) points.add({1, 0}, values_of(id, points));
  points.update_occupied();
  EXPECT_EQ(points.n_points(), 29);
  EXPECT_EQ(whereabouts(points).size(), 29u);
  const auto& block = points.block(points.first_block(1));
  EXPECT_EQ(block.n, 29);
  EXPECT_EQ(block.capacity, 32);
  for (Index lane = 0; lane < 29; ++lane) EXPECT_EQ(block.row(Rows::id)[lane], lane) << "the order of points changed";
  expect_empty_padding(points);
}

TEST(PointBlocks, AlignRowsToPacks)
{
  PointBlocks<2> points(3, 1);
  for (int id = 0; id < 9; ++id) points.add({id % 3, 0}, values_of(id, points));
  for (Index cell = 0; cell < 3; ++cell)
    for (int r = 0; r < points.n_rows(); ++r)
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(points.block(points.first_block(cell)).row(r)) % 64, 0u);
}

TEST(PointBlocks, TakeReturnsThePointAndMovesTheLastIntoItsLane)
{
  PointBlocks<2> points(1, n_state);
  for (int id = 0; id < 5; ++id) points.add({0, 0}, values_of(id, points));
  points.update_occupied();
  std::vector<Real> taken(points.n_rows());
  points.take(points.first_block(0), 1, taken);
  EXPECT_EQ(taken, values_of(1, points));
  const auto& block = points.block(points.first_block(0));
  EXPECT_EQ(block.n, 4);
  EXPECT_EQ(block.row(Rows::id)[1], 4);
  points.take(points.first_block(0), 3, taken);  // the last one itself
  EXPECT_EQ(taken, values_of(3, points));
  EXPECT_EQ(points.n_points(), 3);
  expect_empty_padding(points);
  EXPECT_EQ(whereabouts(points).size(), 3u);
}

TEST(PointBlocks, ListOccupiedCellsInOrder)
{
  PointBlocks<2> points(10, n_state);
  for (const Index cell : {7, 2, 9, 2, 4}) points.add({cell, 0}, values_of(cell, points));
  EXPECT_TRUE(points.update_occupied());
  EXPECT_THAT(points.occupied(), ElementsAre(2, 4, 7, 9));
  EXPECT_THAT(points.slot_of_cell(), ElementsAre(-1, -1, 0, -1, 1, -1, -1, 2, -1, 3));
  EXPECT_FALSE(points.update_occupied()) << "nothing changed";
}

TEST(PointBlocks, ForgetEmptiedCellsAndTakeInNewOnes)
{
  PointBlocks<2> points(10, n_state);
  for (const Index cell : {7, 2, 9}) points.add({cell, 0}, values_of(cell, points));
  points.update_occupied();
  std::vector<Real> taken(points.n_rows());
  points.take(points.first_block(7), 0, taken);
  points.add({3, 0}, taken);
  points.add({0, 0}, values_of(11, points));
  EXPECT_TRUE(points.update_occupied());
  EXPECT_THAT(points.occupied(), ElementsAre(0, 2, 3, 9));
  EXPECT_THAT(points.slot_of_cell(), ElementsAre(0, -1, 1, 2, -1, -1, -1, -1, -1, 3));
  EXPECT_EQ(points.first_block(7), -1);
}

TEST(PointBlocks, KeepACellThatWasEmptiedAndFilledAgainInOneStep)
{
  PointBlocks<2> points(4, n_state);
  points.add({2, 0}, values_of(5, points));
  points.update_occupied();
  std::vector<Real> taken(points.n_rows());
  points.take(points.first_block(2), 0, taken);
  points.add({2, 0}, taken);
  points.update_occupied();
  EXPECT_THAT(points.occupied(), ElementsAre(2));
  EXPECT_EQ(whereabouts(points).size(), 1u);
  points.take(points.first_block(2), 0, taken);
  points.add({2, 1}, taken);  // and by another material
  points.update_occupied();
  EXPECT_THAT(points.occupied(), ElementsAre(2));
  EXPECT_EQ(points.block(points.first_block(2)).material, 1);
}

TEST(PointBlocks, KeepMaterialsApartInOrderOfTheirNumber)
{
  PointBlocks<2> points(2, n_state);
  for (const Index material : {2, 0, 1, 2})
    points.add({1, material}, values_of(10 + static_cast<int>(points.n_points()), points));
  points.update_occupied();
  std::vector<std::pair<Index, Index>> blocks;
  for_each_block(points, 1, [&](const PointBlock<2>& block, Index) { blocks.emplace_back(block.material, block.n); });
  EXPECT_THAT(blocks, ElementsAre(std::pair(0, 1), std::pair(1, 1), std::pair(2, 2)));
  std::vector<Real> taken(points.n_rows());
  points.take(points.block(points.first_block(1)).next, 0, taken);
  EXPECT_EQ(taken, values_of(12, points));
  points.update_occupied();
  blocks.clear();
  for_each_block(points, 1, [&](const PointBlock<2>& block, Index) { blocks.emplace_back(block.material, block.n); });
  EXPECT_THAT(blocks, ElementsAre(std::pair(0, 1), std::pair(2, 2)));
}

TEST(PointBlocks, KeepBodiesOfAMaterialApartInOrderOfTheirNumber)
{
  PointBlocks<2> points(2, n_state);
  EXPECT_EQ(points.n_bodies(), 1);
  int id = 10;
  for (const auto& [material, body] : {std::pair{1, 0}, {0, 3}, {0, 0}, {0, 3}, {0, 1}})
    points.add({1, material, body}, values_of(id++, points));
  points.expect({1, 0, 1}, 20);  // is there
  points.update_occupied();
  std::vector<std::array<Index, 3>> blocks;
  for_each_block(points, 1, [&](const PointBlock<2>& block, Index) {
    blocks.push_back({block.material, block.body, block.n});
  });
  using Block = std::array<Index, 3>;
  EXPECT_THAT(blocks, ElementsAre(Block{0, 0, 1}, Block{0, 1, 1}, Block{0, 3, 2}, Block{1, 0, 1}));
  EXPECT_EQ(points.n_bodies(), 4);
}

TEST(PointBlocks, ClearMemoryBeforeItIsUsedAgain)
{
  PointBlocks<2> points(4, n_state);
  for (int id = 1; id <= 8; ++id) points.add({0, 0}, values_of(id, points));
  points.update_occupied();
  const Real* before = points.block(points.first_block(0)).data;
  points.add({0, 0}, values_of(9, points));  // grows: the old memory is free, and still full of numbers
  points.add({3, 0}, values_of(10, points));
  points.update_occupied();
  EXPECT_EQ(points.block(points.first_block(3)).data, before)
      << "the freed memory was not used again: this test shows nothing";
  expect_empty_padding(points);
}

TEST(PointBlocks, ExpectMakesRoomThatIsEnough)
{
  PointBlocks<2> points(2, n_state);
  points.expect({1, 0}, 25);
  const auto& block = points.block(points.first_block(1));
  EXPECT_EQ(block.capacity, 32);
  const Real* data = block.data;
  for (int id = 0; id < 25; ++id) points.add({1, 0}, values_of(id, points));
  points.expect({1, 0}, 50);  // is there already
  EXPECT_EQ(points.block(points.first_block(1)).data, data);
  EXPECT_EQ(points.n_blocks(), 1);
}

TEST(PointBlocks, ExpectWithoutPointsLeavesNoOccupiedCell)
{
  PointBlocks<2> points(2, n_state);
  points.expect({1, 0}, 25);
  points.update_occupied();
  EXPECT_TRUE(points.occupied().empty());
  EXPECT_EQ(points.first_block(1), -1);
}

TEST(PointBlocks, ReserveSetsMemoryAsideForTheRun)
{
  PointBlocks<2> points(400, n_state);
  points.reserve(20000);
  const auto held = points.reserved_bytes();
  EXPECT_GT(held, 0);
  for (int id = 0; id < 100 * 25; ++id)
    points.add({id % 100, 0}, values_of(id, points));  // each block grows from 8 to 32
  points.update_occupied();
  EXPECT_EQ(points.bytes(), 100 * 32 * points.n_rows() * 8);
  EXPECT_EQ(points.reserved_bytes(), held) << "the run had to ask for memory";
  EXPECT_EQ(whereabouts(points).size(), 100u * 25u);
  expect_empty_padding(points);
}

TEST(PointBlocks, LoseNothingInTwentyThousandRandomMoves)
{
  constexpr Index n_cells = 23, n_materials = 3;
  PointBlocks<2> points(n_cells, n_state);
  points.reserve(100);
  Random random(21);
  std::map<int, std::pair<Index, Index>> expected;
  for (int id = 0; id < 300; ++id) {
    expected[id] = {random.below(n_cells), random.below(n_materials)};
    points.add({expected[id].first, expected[id].second}, values_of(id, points));
  }
  points.update_occupied();
  std::vector<Real> values(points.n_rows());
  for (int move = 0; move < 20000; ++move) {
    const Index from = points.occupied()[random.below(static_cast<Index>(points.occupied().size()))];
    const Index b = points.first_block(from);
    if (points.block(b).n == 0) continue;  // emptied since the last update
    const Index material = points.block(b).material;
    points.take(b, random.below(points.block(b).n), values);
    const Index to = random.below(move % 2 ? n_cells : 4);  // crowds some cells, empties others
    points.add({to, material}, values);
    expected[static_cast<int>(values[Rows::id])] = {to, material};
    if (move % 7 == 0) points.update_occupied();
    if (move % 1000 != 0) continue;
    points.update_occupied();
    ASSERT_EQ(whereabouts(points), expected);
    ASSERT_EQ(points.n_points(), 300);
    ASSERT_TRUE(std::is_sorted(points.occupied().begin(), points.occupied().end()));
    expect_empty_padding(points);
  }
}

}  // namespace point_blocks_test
