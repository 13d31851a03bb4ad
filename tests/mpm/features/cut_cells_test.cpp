#include "mpm/features/slip.hpp"
#include "mpm/features/cut_cells.hpp"

#include "mpm/step/workspace.hpp"
#include "soil/laws/material.hpp"
#include "mpm/step/cell_passes.hpp"
#include "support/simulations.hpp"
#include "support/two_soils.hpp"

#include <memory>

namespace cut_cells_test {

/// Mean shear stress of the soils of the cell at a place on a border of this angle, by material [Pa].
std::array<Real, 2> shear_stress(const Simulation& s, Vec<2> place, Real degrees)
{
  const Real twice = 2.0 * degrees * std::numbers::pi / 180.0;
  std::array<Real, 2> tau{}, volume{};
  for (const Point& p : points_by_id(s.state)) {
    const Vec<2>& centre = s.model.mesh->centres[p.cell];
    if (std::abs(centre[0] - place[0]) > 0.125 || std::abs(centre[1] - place[1]) > 0.125) continue;
    const Real along = 0.5 * std::sin(twice) * (p.sigma[1] - p.sigma[0]) + std::cos(twice) * p.sigma[3];
    tau[static_cast<std::size_t>(p.material)] += p.volume * along;
    volume[static_cast<std::size_t>(p.material)] += p.volume;
  }
  return {tau[0] / volume[0], tau[1] / volume[1]};
}

struct Way {
  std::string scheme;
  Shares shares;
};

class SoilsOfACutCell : public TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(EveryScheme, SoilsOfACutCell,
    testing::Values(Way{"mpm_gp", Shares::point}, Way{"mpm_gp", Shares::overlap}, Way{"mpm_mixed", Shares::point},
        Way{"mpm_mixed", Shares::overlap}));

/// Steps in which the soils slip as if the law had given them this plastic work in the step before [J/m^3].
void make_slipping_steps(Simulation& s, std::int64_t n, Real plastic_work = 1.0)
{
  for (std::int64_t k = 0; k < n; ++k) {
    edit_points(s.state,
        [&](const PointBlock<2>& block, Index lane) { block.row(s.model.with.slip->row)[lane] = plastic_work; });
    make_steps(s);
  }
}

Model without_motion(const Case& c)
{
  Model model = build_model(c, 1);
  model.dt = 1.0e-15;
  return model;
}

void set_a_jump(Simulation& s)
{
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    const Real sign = block.material == 0 ? 1.0 : -1.0;
    block.row(Rows::sigma)[lane] = -9.0e3 + 2.0e3 * sign;
    block.row(Rows::sigma + 1)[lane] = -5.0e3 - 1.0e3 * sign;
    block.row(Rows::sigma + 2)[lane] = -4.0e3;
    block.row(Rows::sigma + 3)[lane] = 1.0e3 + 3.0e3 * sign;
  });
}

TEST_P(SoilsOfACutCell, TheShearStressOfBothSoilsBecomesTheSameAndTheCellKeepsItsStrain)
{
  for (const Real degrees : {0.0, 90.0, -45.0}) {  // the directions that the points show exactly
    const Vec<2> place{2.625, 2.375};
    Model model = without_motion(two_clays(GetParam().scheme, GetParam().shares, place, degrees));
    State state = build_state(model);
    Simulation s(std::move(model), std::move(state));
    set_a_jump(s);
    const auto before = shear_stress(s, place, degrees);
    make_slipping_steps(s, GetParam().shares == Shares::point ? 1 : 60);
    const auto after = shear_stress(s, place, degrees);
    const Real jump = std::abs(before[1] - before[0]);
    EXPECT_GT(jump, 2.9e3);
    EXPECT_NEAR(after[0], after[1], (GetParam().shares == Shares::point ? 1e-9 : 0.02) * jump) << degrees;
    if (GetParam().shares == Shares::point) {
      const Real weight = stiff / (soft + stiff);  // both soils fill half of the cell
      EXPECT_NEAR(after[0], before[0] * weight + before[1] * (1.0 - weight), 1e-9 * jump);
    }
    std::array<Real, 4> strain{};
    Real most = 0.0;
    for (const Point& p : points_by_id(s.state)) {
      EXPECT_NEAR(p.strain[0] + p.strain[1] + p.strain[2], 0.0, 1e-12);
      for (std::size_t k = 0; k < 4; ++k) strain[k] += p.volume * p.strain[k];
      most = std::max(most, p.volume * std::abs(p.strain[3]) + p.volume * std::abs(p.strain[0]));
    }
    EXPECT_GT(most, 1e-8);
    for (const Real sum : strain) EXPECT_NEAR(sum, 0.0, 1e-6 * most) << degrees;
  }
}

/// Energy that soils lost which slip at rest, over what the ledger books; lost: what they lost.
Real booked_over_lost(const Case& c, Real& lost)
{
  Model model = without_motion(c);
  State state = build_state(model);
  Simulation s(std::move(model), std::move(state));
  set_a_jump(s);
  const Real before = kinetic_and_stored_energy(s.model, s.state);
  make_slipping_steps(s, c.method.shares == Shares::point ? 1 : 60);
  lost = before - kinetic_and_stored_energy(s.model, s.state);
  EXPECT_GT(s.state.work.slip, 0.0);
  return (s.state.work.plastic + s.state.work.slip) / lost;
}

TEST_P(SoilsOfACutCell, LoseWhatIsBookedWhenTheirShearStressBecomesTheSame)
{
  const bool at_once = GetParam().shares == Shares::point;
  for (const Real degrees : {0.0, 90.0, -45.0}) {
    Case c = two_clays(GetParam().scheme, GetParam().shares, {2.625, 2.375}, degrees);
    Real elastic = 0.0, yielding = 0.0;
    EXPECT_NEAR(booked_over_lost(c, elastic), 1.0, at_once ? 1e-8 : 0.05) << degrees;
    c.materials[0] = clay({.shear_modulus = soft, .su_peak = 4.0e3, .su_residual = 4.0e3});
    c.materials[0].name = "rock";
    EXPECT_NEAR(booked_over_lost(c, yielding), 1.0, at_once ? 0.005 : 0.05) << degrees;
    EXPECT_GT(elastic, 0.1);
    EXPECT_NE(elastic, yielding);
  }
}

/// Two soils in a box between rollers, or turned with its cells and let go as it bends.
Case heap(const Way& way, Real contrast, Real degrees, bool turned)
{
  const MaterialCase below = elastic(1e6, 0.3, 1800.0);
  Case c = free_box(way.scheme, {0.0, 0.0}, {2.0, 1.0}, below);
  c.materials.push_back(elastic(contrast * 1e6, 0.3, 1800.0));
  c.materials[1].name = "upper";
  c.bodies.push_back(body("upper", {0.0, 0.0}, {2.0, 1.0}));
  const Real slope = std::tan(degrees * std::numbers::pi / 180.0), middle = 0.53;
  std::vector<Vec<2>>& outline = c.bodies[1].polygon;
  outline.clear();
  const auto line = [&](Real x) { return std::clamp(middle + slope * (x - 1.0), 0.0, 1.0); };
  constexpr int n_parts = 20;
  for (int k = 0; k <= n_parts; ++k) outline.push_back({2.0 * k / n_parts, line(2.0 * k / n_parts)});
  outline.insert(outline.end(), {{2.0, 1.0}, {0.0, 1.0}});
  for (BodyCase& part : c.bodies) part.points_per_cell = {3, 3};
  if (turned) {
    constexpr Real half = 2.0, angle = 0.4;
    const auto corner = [&](Real x, Real y) {
      return Vec<2>{1.0 + half * (std::cos(angle) * x - std::sin(angle) * y),
          0.5 + half * (std::sin(angle) * x + std::cos(angle) * y)};
    };
    const Vec<2> low = corner(-1.0, -1.0), right = corner(1.0, -1.0), high = corner(1.0, 1.0), left = corner(-1.0, 1.0);
    c.mesh = {};
    c.mesh.kind = MeshKind::mapped;
    c.mesh.cells = {20, 20};
    c.mesh.sides = {{{low, right}, {right, high}, {left, high}, {low, left}}};
    for (BodyCase& part : c.bodies)
      part.velocity_at = [](Vec<2> x) { return Vec<2>{0.5 * x[1], std::sin(3.0 * x[0])}; };
  } else {
    c.mesh.size = {2.0, 1.25};
    c.mesh.cell = {0.2, 0.2};
    c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::roller)};
    c.forces.gravity = {0.0, -9.81};
  }
  c.method.shares = way.shares;
  c.time.end = 0.1;
  return c;
}

/// The last state of a run.
StateImage end_of(Case c, CutCells cut_cells)
{
  c.method.cut_cells = cut_cells;
  Simulation run(c);
  run.run();
  return run.save();
}

TEST_P(SoilsOfACutCell, HaveOneStrainToTheBitWhereTheyDoNotYield)
{
  const std::vector<std::string> what_a_slip_follows_from{"points/last_plastic_work"};
  for (const bool turned : {false, true})
    for (const auto& [contrast, degrees] :
        {std::pair{10.0, 5.7}, std::pair{1000.0, 5.7}, std::pair{100.0, -35.0}, std::pair{300.0, 65.0}}) {
      Case c = heap(GetParam(), contrast, degrees, turned);
      EXPECT_EQ(first_difference(end_of(c, CutCells::mean), end_of(c, CutCells::slip)), "") << contrast;
      for (MaterialCase& soil : c.materials) {
        const std::string name = soil.name;
        soil = clay({.shear_modulus = soil.parameters[0], .poisson_ratio = 0.3, .su_peak = 1e9, .su_residual = 1e9});
        soil.name = name;
      }
      EXPECT_EQ(different_arrays(end_of(c, CutCells::mean), end_of(c, CutCells::slip)), what_a_slip_follows_from)
          << contrast << " " << degrees;
    }
}

TEST_P(SoilsOfACutCell, NeverGainByTheirSlipWhatYieldingLost)
{
  for (const bool weak_above : {false, true})
    for (const Real contrast : {10.0, 100.0}) {
      Case c = heap(GetParam(), contrast, 5.7, false);
      MaterialCase& weak = c.materials[weak_above ? 1 : 0];
      const std::string name = weak.name;
      weak = clay({.shear_modulus = 1e6, .poisson_ratio = 0.3, .su_peak = 2e3, .su_residual = 2e3});
      weak.name = name;
      if (weak_above) c.materials[0] = elastic(contrast * 1e6, 0.3, 1800.0);
      c.time.end = 0.2;
      Simulation s(c);
      Real last = 0.0, fall = 0.0;
      while (s.state.time < c.time.end) {
        make_steps(s);
        const Real lost = s.state.work.plastic + s.state.work.slip;
        fall = std::max(fall, last - lost);
        last = lost;
      }
      EXPECT_GT(s.state.work.plastic, 0.1);
      EXPECT_LT(fall, 1e-3 * s.state.work.gravity) << contrast << weak_above;  // decision 0072; the bound lags a step
    }
}

TEST_P(SoilsOfACutCell, KeepThePlasticWorkOfTheLastStepAtTheirPoints)
{
  Case c = heap(GetParam(), 10.0, 5.7, false);
  c.materials[0] = clay({.shear_modulus = 1e6, .poisson_ratio = 0.3, .su_peak = 2e3, .su_residual = 2e3});
  c.materials[0].name = "rock";
  Simulation s(c);
  Real before = 0.0;
  while (s.state.work.plastic < 10.0) {
    before = s.state.work.plastic;
    make_steps(s);
  }
  Real kept = 0.0;
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    const Real work = block.row(s.model.with.slip->row)[lane];
    if (block.material == 1) {
      EXPECT_EQ(work, 0.0);
    }
    kept += block.row(Rows::volume)[lane] * work;
  });
  const bool at_points = GetParam().scheme == "mpm_gp";  // the law runs there
  EXPECT_NEAR(kept, s.state.work.plastic - before, (at_points ? 1e-3 : 0.1) * kept);
}

TEST(KinkOfACell, IsWhatSlippedButNoMoreThanTheCornersMove)
{
  const Kink kink{.slipped = 0.02};
  EXPECT_EQ(kink_of(kink, 0.1, 0.25), 0.02);
  EXPECT_DOUBLE_EQ(kink_of(kink, 0.001, 0.25), 0.004);
  EXPECT_EQ(kink_of(kink, -0.001, 0.25), 0.0);
  EXPECT_EQ(kink_of(kink, 0.0, 0.25), 0.0);
  EXPECT_DOUBLE_EQ(kink_of({.slipped = -0.02}, -0.003, 0.25), -0.012);
  EXPECT_EQ(kink_of({.slipped = -0.02}, 0.003, 0.25), 0.0);
}

/// Corners that follow a shear of the soil above the border alone: the soil below has no strain.
TEST(CutCellsWithAKink, StrainTheSoilThatShearsAndNotTheOther)
{
  constexpr Real k = 1e-3;
  Case c = two_soils("mpm_gp", Shares::point, {2.6, 2.4}, 30.0, 6);
  c.materials[1] = clay({.shear_modulus = soft, .poisson_ratio = 0.3, .su_peak = 1e9, .su_residual = 1e9});
  c.materials[1].name = "hard rock";
  Simulation s(c);
  const auto n_cells = static_cast<Index>(s.state.points.occupied().size());
  const Vec<2> t{std::cos(std::numbers::pi / 6.0), std::sin(std::numbers::pi / 6.0)}, n{-t[1], t[0]};
  int n_cut = 0;
  for (Index first = 0; first < n_cells; first += pack_width) {
    const CellGroup<Quad4> group = view_group(s.model, s.state, s.work, first, std::min(first + pack_width, n_cells));
    std::vector<BlockSlip>& slips = s.work.with.slip->blocks;
    GroupVectors<Quad4> du{};
    for (int lane = 0; lane < group.n(); ++lane) {
      const Index b = s.state.points.first_block(group.cells[lane]);
      if (s.state.points.block(b).next < 0) continue;
      Kink kink{.along = {n[1], -n[0]}, .share = 0.4, .slipped = k};
      kink.above = above_border(group.mesh, group.cells[lane], n, kink.share);
      for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < 4; ++i)
          du[lane][d][static_cast<int>(i)] = k * kink.above[i] * kink.along[static_cast<int>(d)];
      const BlockSlip unit{.normal = n[0] * n[1], .shear = 0.5 * (n[1] * n[1] - n[0] * n[0])};
      for (const Index of : {b, s.state.points.block(b).next}) {
        slips[of] = unit;
        slips[of].g = s.state.points.block(of).material == 1 ? 0.6 * k : -0.4 * k;
      }
      slips[b].kink = kink;
      ++n_cut;
    }
    Real lost = 0.0;
    GroupVectors<Quad4> room;
    GaussStrain<Quad4> slipped;
    const auto strain =
        strain_by_cell(strain_of_group(geometry_of(group), without_kinks<Quad4>(group, slips, du, room, lost), true));
    for (int lane = 0; lane < group.n(); ++lane)
      for_each_block(s.state.points, group.cells[lane], [&](const auto& block, Index b) {
        if (!slips[b].acts()) return;
        const auto own = with_slip<Quad4>(slips, b, strain[lane], slipped);
        const Real sheared = block.material == 1 ? k : 0.0;
        for (std::size_t g = 0; g < 4; ++g) {
          EXPECT_NEAR(own.d_eps[0][g], sheared * n[0] * n[1], 1e-9 * k);
          EXPECT_NEAR(own.d_eps[1][g], -sheared * n[0] * n[1], 1e-9 * k);
          EXPECT_NEAR(own.d_eps[3][g], 0.5 * sheared * (n[1] * n[1] - n[0] * n[0]), 1e-9 * k);
          EXPECT_NEAR(own.d_spin[g], -0.5 * sheared, 1e-9 * k);
        }
      });
  }
  EXPECT_GT(n_cut, 8);
}

constexpr Real layer_length = 20.0, layer_strength = 8.0e3, layer_speed = 0.04;

/// A weak layer of 2 m, or less, on cells of 1 m turned by 30 degrees, between blocks of ten times its strength.
Case sheared_layer(const Way& way, CutCells cut_cells, Real thickness = 2.0)
{
  constexpr Real half = 15.0, angle = std::numbers::pi / 6.0;
  const Real strong = 10.0 * layer_strength;
  Case c = free_box(way.scheme, {0.0, -3.0}, {layer_length, 5.0},
      clay({.poisson_ratio = 0.45, .su_peak = strong, .su_residual = strong}));
  c.materials.push_back(clay({.poisson_ratio = 0.45, .su_peak = layer_strength, .su_residual = layer_strength}));
  c.materials[1].name = "weak";
  c.bodies.push_back(body("weak", {0.0, 1.0 - 0.5 * thickness}, {layer_length, 1.0 + 0.5 * thickness}));
  for (BodyCase& part : c.bodies) part.points_per_cell = {4, 4};
  const auto corner = [&](Real x, Real y) {
    return Vec<2>{0.5 * layer_length + half * (std::cos(angle) * x - std::sin(angle) * y),
        1.0 + half * (std::sin(angle) * x + std::cos(angle) * y)};
  };
  const Vec<2> low = corner(-1.0, -1.0), right = corner(1.0, -1.0), high = corner(1.0, 1.0), left = corner(-1.0, 1.0);
  c.mesh = {};
  c.mesh.kind = MeshKind::mapped;
  c.mesh.cells = {30, 30};
  c.mesh.sides = {{{low, right}, {right, high}, {left, high}, {low, left}}};
  for (const Real side : {-1.0, 1.0}) {
    FootingCase block{.name = side < 0.0 ? "lower" : "upper", .low = {-50.0, 3.5}, .high = {100.0, 50.0}};
    if (side < 0.0) block.low[1] = -50.0, block.high[1] = -1.5;
    block.velocity = {side * layer_speed, 0.0};
    block.ramp = 0.5;
    c.footings.push_back(block);
  }
  c.forces.local_damping = 0.2;
  c.time.end = 5.0;
  c.method.shares = way.shares;
  c.method.cut_cells = cut_cells;
  return c;
}

/// Mean force on the layer over its strength until a slip, from half of it [m].
Real force_of_layer(Simulation& s, Real slip)
{
  const auto time_of = [](Real at) { return 0.25 + 0.5 * at / layer_speed; };
  s.advance_to(time_of(0.5 * slip));
  const Real work = s.state.work.boundary, start = s.state.time;
  s.advance_to(time_of(slip));
  return (s.state.work.boundary - work) / (2.0 * layer_speed * (s.state.time - start) * layer_length * layer_strength);
}

TEST_P(SoilsOfACutCell, CarryNoMoreThanTheWeakerOneHoweverFarTheySlip)
{
  Simulation slip(sheared_layer(GetParam(), CutCells::slip)), mean(sheared_layer(GetParam(), CutCells::mean));
  EXPECT_GT(force_of_layer(mean, 0.1), 1.15);
  EXPECT_NEAR(force_of_layer(slip, 0.1), 1.0, 0.05);
  EXPECT_NEAR(force_of_layer(slip, 0.2), 1.0, 0.05);
  EXPECT_LT(summarise(slip.model, slip.state).energy_balance_error, 0.002);
}

TEST_P(SoilsOfACutCell, CarryLessThanTheirMeanWhereALayerIsThinnerThanACell)
{
  const auto force = [&](CutCells cut_cells) {
    Simulation s(sheared_layer(GetParam(), cut_cells, 0.5));
    return force_of_layer(s, 0.1);
  };
  EXPECT_GT(force(CutCells::mean), 2.5);
  EXPECT_LT(force(CutCells::slip), 1.4);
}

/// Two clays that collapse and mix, one ten times as strong as the other.
Case collapse(const Way& way)
{
  Case c = column(way.scheme, 0.25);
  c.method.shares = way.shares;
  c.method.cut_cells = CutCells::slip;
  c.materials.push_back(clay({.su_peak = 8.0e4, .su_residual = 2.0e4}));
  c.materials[1].name = "strong";
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 2.0}), body("strong", {0.0, 1.1}, {8.0, 2.0})};
  c.bodies[1].polygon = {{0.0, 0.9}, {8.0, 1.4}, {8.0, 2.0}, {0.0, 2.0}};
  c.time.end = 0.6;
  return c;
}

std::unique_ptr<Simulation> solved(Case c, CutCells cut_cells)
{
  c.method.cut_cells = cut_cells;
  auto run = std::make_unique<Simulation>(c);
  run->run();
  return run;
}

TEST_P(SoilsOfACutCell, CloseTheLedgerOfEnergyAsSoilsOfOneStrainDo)
{
  const Case c = collapse(GetParam());
  const auto slip = solved(c, CutCells::slip), mean = solved(c, CutCells::mean);
  EXPECT_NE(first_difference(slip->save(), mean->save()), "");
  const auto error = [](const Simulation& s) { return summarise(s.model, s.state).energy_balance_error; };
  EXPECT_LT(error(*slip), error(*mean) + 0.005);
}

/// What the nodes gave is what the points and the slip took.
TEST_P(SoilsOfACutCell, LoseNoWorkBetweenNodesAndPoints)
{
  Case c = collapse(GetParam());
  c.method.strain_shares = StrainShares::transposed;
  const auto run = solved(c, CutCells::slip);
  const WorkTotals& work = run->state.work;
  EXPECT_GT(work.slip, 0.02 * work.taken);
  EXPECT_LT(std::abs(work.transfer()), 0.01 * work.taken);
}

TEST_P(SoilsOfACutCell, ChangeNoBitOfOneSoil)
{
  Case c = column(GetParam().scheme, 0.25);
  c.method.shares = GetParam().shares;
  c.time.end = 0.3;
  EXPECT_EQ(first_difference(solved(c, CutCells::mean)->save(), solved(c, CutCells::slip)->save()), "");
}

TEST(CutCellsOfAFluid, DoNotSlip)
{
  Case c = two_soils("mpm_gp", Shares::point, {2.625, 2.375}, 0.0);
  std::vector<Real> typical;
  for (const ParameterInfo& parameter : find_material("newtonian_fluid")->parameters)
    typical.push_back(parameter.typical);
  c.materials[1] = {"water", "newtonian_fluid", 1000.0, typical};
  c.bodies[1].material = "water";
  Simulation s(c);
  make_steps(s);
  for (const BlockSlip& slip : s.work.with.slip->blocks) EXPECT_FALSE(slip.acts());
}

}  // namespace cut_cells_test
