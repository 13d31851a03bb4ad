#include "mpm/kernels/overlap.hpp"

#include "support/blocks.hpp"
#include "support/random.hpp"

namespace terp {
namespace overlap_test {

using P = Patch<Quad4>;
using test::PointValues;

constexpr int extent_row = Rows::state;  // the only row beyond the fixed ones

/// A mesh of 3 x 3 cells of 2 m x 2 m: one local unit is 1 m. Points of extent 0.4 m in the middle cell.
struct Cells {
  Mesh<2> mesh = make_rectangle({0.0, 0.0}, {6.0, 6.0}, {3, 3});
  PointBlocks<2> points{9, 1};

  void add(Index cell, PointValues point, Real extent = 0.4, Index material = 0)
  {
    point.state = {1.0 / extent};
    test::add_point(mesh, cell, point, points, material);
  }
  const PointBlock<2>& middle() { return test::only_block(points, 4); }
  std::array<Real, P::n_slots> shares(Vec<2> local, Real extent = 0.4)
  {
    points = PointBlocks<2>(9, 1);
    add(4, {.local = local}, extent);
    PointShares packs;
    set_shares(middle(), 0, {extent_row, 2.0}, packs);
    std::array<Real, P::n_slots> values;
    for (int slot = 0; slot < P::n_slots; ++slot) values[slot] = packs.in_slot(slot)[0];
    return values;
  }
};

/// Everything zero but the slots named.
testing::Matcher<std::array<Real, P::n_slots>> only(std::initializer_list<std::pair<int, Real>> slots)
{
  std::vector<Real> expected(P::n_slots, 0.0);
  for (const auto& [slot, share] : slots) expected[slot] = share;
  return testing::Pointwise(testing::DoubleNear(1e-15), expected);
}

TEST(Overlap, ASquareWithinASubCellCountsThereAlone)
{
  Cells cells;
  EXPECT_THAT(cells.shares({-0.5, 0.5}), only({{P::own_slot[2], 1.0}}));
  EXPECT_THAT(cells.shares({0.79, -0.21}), only({{P::own_slot[1], 1.0}}));
}

TEST(Overlap, ASquareOnLinesCountsByItsParts)
{
  Cells cells;
  EXPECT_THAT(cells.shares({0.0, 0.5}), only({{P::own_slot[2], 0.5}, {P::own_slot[3], 0.5}}));
  EXPECT_THAT(cells.shares({0.9, 0.5}), only({{P::own_slot[3], 0.75}, {11, 0.25}}));  // 0.1 of 0.4 beyond the side
  EXPECT_THAT(cells.shares({-1.0, 1.0}), only({{P::own_slot[2], 0.25}, {8, 0.25}, {13, 0.25}, {12, 0.25}}));
}

TEST(Overlap, ASquareIsAtMostAsLargeAsTheCell)
{
  Cells cells;
  EXPECT_EQ(cells.shares({0.25, 0.0}, 100.0), cells.shares({0.25, 0.0}, 2.0));
}

/// Squares up to the size of a sub-cell fit into two by two slots; there they have the bits of all slots.
TEST(Overlap, WindowsHoldTheSharesOfSquaresThatFit)
{
  test::Random random(10);
  for (int trial = 0; trial < 200; ++trial) {
    Cells cells;
    for (int k = 0; k < 7; ++k)  // one lane is empty
      cells.add(4, {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)}}, random.between(0.1, 1.0));
    if (trial == 0) cells.middle().row(Rows::xi)[0] = -1.0;
    PointWindow window;
    ASSERT_TRUE(set_window(cells.middle(), 0, {extent_row, 2.0}, window));
    PointShares shares;
    set_shares(cells.middle(), 0, {extent_row, 2.0}, shares);
    for (int lane = 0; lane < 7; ++lane) {
      std::array<Real, P::n_slots> expected{}, found{};
      for (int slot = 0; slot < P::n_slots; ++slot) expected[slot] = shares.in_slot(slot)[lane];
      for (int k = 0; k < 4; ++k) found[entry_at(window.first[lane]) + PointWindow::slots[k]] = window.in_slot(k)[lane];
      EXPECT_EQ(found, expected);
    }
  }
}

TEST(Overlap, ASquareThatReachesThreeColumnsFitsIntoNoWindow)
{
  PointWindow window;
  for (const Vec<2> local : {Vec<2>{-0.5, 0.5}, Vec<2>{0.5, 0.4}, Vec<2>{0.4, -0.5}}) {
    Cells cells;
    cells.add(4, {.local = {0.9, 0.9}}, 0.4);
    cells.add(4, {.local = local}, 1.1);
    EXPECT_FALSE(set_window(cells.middle(), 0, {extent_row, 2.0}, window));
  }
  Cells cells;
  cells.add(4, {.local = {0.0, 1.0}}, 1.1);  // across 0, and across the side
  EXPECT_TRUE(set_window(cells.middle(), 0, {extent_row, 2.0}, window));
}

/// Points in all nine cells; of a second material at the right and beyond the lower left corner.
Cells random_points(std::uint64_t seed)
{
  Cells cells;
  test::Random random(seed);
  for (Index cell = 0; cell < 9; ++cell)
    for (int k = 0; k < (cell == 4 ? 70 : 6); ++k)  // more than one strip in the middle
      cells.add(cell,
          {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)},
              .volume = random.between(0.01, 0.1),
              .sigma = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-9.0, 9.0),
                  random.between(-9.0, 9.0)}},
          random.between(0.3, 1.5), cell == 5 || cell == 0 ? 1 : 0);
  cells.points.update_occupied();
  return cells;
}

/// All that partners could take, or a part of it.
TakenShares shares_of(const BlockPartners& partners, Real part = 1.0)
{
  TakenShares taken;
  for (int k = 0; k < P::n_outer; ++k) taken[k] = partners[k] < 0 ? 0.0 : k % 2 == 0 ? part : 1.0;
  return taken;
}

struct Sums {
  static constexpr int width = patch_others + 1;
  BlockPartners partners;
  std::array<Real, P::n_slots * width> values;

  explicit Sums(Cells& cells)
  {
    partners = find_block_partners(cells.points, find_patch_partners(cells.mesh)[4], cells.middle());
    const std::array<int, 1> others{extent_row};
    sum_over_patch(cells.middle(), {extent_row, 2.0}, others, width, values.data());
  }
  Real total(int row) const
  {
    Real sum = 0.0;
    for (int slot = 0; slot < P::n_slots; ++slot) sum += values[slot * width + row];
    return sum;
  }
};

/// What few points give is summed in another way, with the bits of many.
TEST(Overlap, PointsWithoutVolumeChangeNoBitOfTheSums)
{
  test::Random random(14);
  for (const int n : {1, 3, 4, 5, 8}) {
    Cells few, many;
    for (int k = 0; k < 9; ++k) {
      const PointValues point{.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)},
          .volume = k < n ? random.between(0.01, 0.1) : 0.0,
          .sigma = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), random.between(-9.0, 9.0),
              random.between(-9.0, 9.0)}};
      const Real extent = random.between(0.3, 1.5);
      if (k < n) few.add(4, point, extent);
      many.add(4, point, extent);
    }
    EXPECT_EQ(Sums(few).values, Sums(many).values) << n;
  }
}

TEST(Overlap, SumsLoseNothingAndFoldingMovesThemToSubCellsWithSoil)
{
  Cells cells = random_points(11);
  Sums sums(cells);
  std::array<Real, 6> expected{};
  const PointBlock<2>& block = cells.middle();
  for (Index p = 0; p < block.n; ++p) {
    const Real volume = block.row(Rows::volume)[p];
    for (int k = 0; k < 4; ++k) expected[k] += volume * block.row(Rows::sigma + k)[p];
    expected[patch_volume] += volume;
    expected[patch_others] += volume * block.row(extent_row)[p];
  }
  for (int r = 0; r < 6; ++r) EXPECT_NEAR(sums.total(r), expected[r], 1e-12);
  EXPECT_NE(sums.values[7 * Sums::width + patch_volume], 0.0);  // right: cell 5, of another material
  fold_sums(sums.partners, shares_of(sums.partners), Sums::width, sums.values.data());
  for (int r = 0; r < 6; ++r) EXPECT_NEAR(sums.total(r), expected[r], 1e-12);
  for (const int slot : {7, 11}) EXPECT_EQ(sums.values[slot * Sums::width + patch_volume], 0.0);
  EXPECT_NE(sums.values[15 * Sums::width + patch_volume], 0.0);  // the corner is reached by way of the upper cell
}

TEST(Overlap, ASmallBlockTakesSharesAsFarAsItHoldsSoil)
{
  EXPECT_DOUBLE_EQ(taken_by(0.01, 4.0), 0.02);  // an eighth of 4 m2 is 0.5 m2
  EXPECT_DOUBLE_EQ(taken_by(0.5, 4.0), 1.0);
  EXPECT_DOUBLE_EQ(taken_by(3.0, 4.0), 1.0);
  Cells cells = random_points(16);
  Sums whole(cells), part(cells);
  ASSERT_GE(part.partners[0], 0);  // below, at the left
  TakenShares taken = shares_of(part.partners);
  fold_sums(whole.partners, taken, Sums::width, whole.values.data());
  taken[0] = 0.25;
  fold_sums(part.partners, taken, Sums::width, part.values.data());
  const auto volume = [](const Sums& sums, int slot) { return sums.values[slot * Sums::width + patch_volume]; };
  EXPECT_NEAR(volume(part, P::outer_slot[0]), 0.25 * volume(whole, P::outer_slot[0]), 1e-15);
  EXPECT_NEAR(
      volume(part, P::own_slot[0]), volume(whole, P::own_slot[0]) + 0.75 * volume(whole, P::outer_slot[0]), 1e-15);
}

/// Omega_p times what points take sums to what sub-cells were given times the value there, with folded shares too.
TEST(Overlap, BothWaysAreTransposesOfEachOther)
{
  for (const auto& [alone, part] : {std::pair(false, 1.0), {true, 1.0}, {false, 0.3}, {false, 0.0}}) {
    Cells cells = random_points(12);
    if (alone) {  // all shares go back
      for (Index cell = 0; cell < 9; ++cell)
        while (cell != 4 && cells.points.first_block(cell) >= 0 && test::only_block(cells.points, cell).n > 0) {
          std::vector<Real> values(cells.points.n_rows());
          cells.points.take(cells.points.first_block(cell), 0, values);
        }
      cells.points.update_occupied();
    }
    Sums sums(cells);
    const TakenShares taken = shares_of(sums.partners, part);
    fold_sums(sums.partners, taken, Sums::width, sums.values.data());
    test::Random random(13);
    std::vector<std::array<Real, 4 * 8>> gauss(cells.points.n_blocks());  // one row of eight used
    for (auto& block : gauss)
      for (Real& value : block) value = random.between(-1.0, 1.0);
    const PatchView view(
        sums.partners, taken, cells.points.first_block(4), [&](Index b) { return gauss[b].data(); }, 8);

    Real of_points = 0.0, of_slots = 0.0;
    const PointBlock<2>& block = cells.middle();
    for (Index p = 0; p < block.n; p += pack_width) {
      with_shares(block, p, {extent_row, 2.0}, [&](const auto& shares) {
        of_points += sum(view.at_points<1>(shares, 0)[0] * Pack::load(block.row(Rows::volume) + p));
      });
    }
    const auto value_in = [&](Index b, int g) { return gauss[b][g * 8]; };
    for (int g = 0; g < 4; ++g)
      of_slots += sums.values[P::own_slot[g] * Sums::width + patch_volume] * value_in(cells.points.first_block(4), g);
    for (int k = 0; k < P::n_outer; ++k)
      if (const Index partner = sums.partners[k]; partner >= 0)
        of_slots += sums.values[P::outer_slot[k] * Sums::width + patch_volume] *
                    value_in(partner / P::n_slots, own_beside_slot[partner % P::n_slots]);
    EXPECT_NEAR(of_points, of_slots, 1e-12) << alone << ' ' << part;
  }
}

TEST(Overlap, WindowsGiveTheBitsOfAllSlots)
{
  Cells cells;
  test::Random random(15);
  for (int k = 0; k < pack_width; ++k)
    cells.add(4, {.local = {random.between(-1.0, 1.0), random.between(-1.0, 1.0)}}, random.between(0.1, 1.0));
  std::array<Real, 4 * 11> gauss;
  for (Real& value : gauss) value = random.between(-1.0, 1.0);
  BlockPartners none;
  none.fill(-1);
  const PatchView view(
      none, shares_of(none), 0, [&](Index) { return gauss.data(); }, 11);
  PointWindow window;
  ASSERT_TRUE(set_window(cells.middle(), 0, {extent_row, 2.0}, window));
  PointShares shares;
  set_shares(cells.middle(), 0, {extent_row, 2.0}, shares);
  const auto by_window = view.at_points<3>(window, 8), by_slots = view.at_points<3>(shares, 8);
  for (int r = 0; r < 3; ++r)
    for (int lane = 0; lane < pack_width; ++lane) EXPECT_EQ(by_window[r][lane], by_slots[r][lane]);
}

}  // namespace overlap_test
}  // namespace terp
