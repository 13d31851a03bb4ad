#include "mpm/step/workspace.hpp"
#include "run/measure/followers.hpp"
#include "model/meshes/mesh_error.hpp"
#include "run/loop/guards.hpp"
#include "support/simulations.hpp"
#include <fmt/format.h>

namespace guards_test {

TEST(Guards, AHealthyStateHasNoFault)
{
  Simulation s(column("mpm_gp"));
  make_steps(s, 5);
  EXPECT_EQ(find_fault(s.model, s.state, s.work, 0.0), "");
}

TEST(Guards, AValueThatIsNotANumberIsNamedWithPointCellMaterialAndLikelyCause)
{
  Simulation s(column("mpm_gp"));
  make_steps(s, 5);
  set_value(s.state, 30, Rows::v, NAN);
  s.work.finite = false;
  const std::string smallest =
      fmt::format("{:.2g}", s.work.node[s.work.active_nodes[0]].mass);  // at the corner of the column
  EXPECT_EQ(find_fault(s.model, s.state, s.work, 0.25),
      "step 5, t = 0.0152 s: the velocity of material point 30 is not a number\n\n"
      "  where    cell 1 at x = 0.75 m, y = 0.25 m; material `clay` (tresca_softening)\n"
      "  before   largest 99.9 % speed 0.25 m/s; dt = 0.00303 s, courant 0.98\n"
      "  likely   an unstable time step, or a nearly empty node: smallest nodal mass " +
          smallest + " kg (docs/troubleshooting.md#not-a-number)");
}

TEST(Guards, EachKindOfValueHasItsName)
{
  const auto fault_in = [](int row) {
    Simulation s(column("mpm_gp"));
    make_steps(s);
    set_value(s.state, 7, row, INFINITY);
    s.work.finite = false;
    return find_fault(s.model, s.state, s.work, 0.0);
  };
  EXPECT_THAT(fault_in(Rows::sigma + 3), HasSubstr("the stress of material point 7 "));
  EXPECT_THAT(fault_in(Rows::x + 1), HasSubstr("the position of material point 7 "));
  EXPECT_THAT(fault_in(Rows::volume), HasSubstr("the volume of material point 7 "));
}

TEST(Guards, WithoutABadPointTheNodesAreNamed)
{
  Simulation s(column("mpm_gp"));
  make_steps(s);
  s.work.finite = false;
  EXPECT_THAT(find_fault(s.model, s.state, s.work, 0.0),
      AllOf(HasSubstr("a nodal acceleration is not a number"), HasSubstr("where    a node of the background mesh")));
}

TEST(Guards, TooManyPointsPutBackAtWallsAreAFault)
{
  Simulation s(column("mpm_gp"));  // 1600 points: at most 1.6 + 1
  make_steps(s);
  s.state.clamped = 2;
  EXPECT_EQ(find_fault(s.model, s.state, s.work, 0.0), "");
  s.state.clamped = 3;
  EXPECT_EQ(find_fault(s.model, s.state, s.work, 0.0),
      "step 1, t = 0.0030 s: 3 points had to be put back at the walls, more than 0.1 % of all\n\n"
      "  likely   soil flies out of the mesh, or runs against a side that is `free`\n"
      "  try      a larger mesh.size, or a `roller` on that side (docs/troubleshooting.md#clamped-points)");
}

/// The row of the ledger, judged.
std::string fault_of_row(Simulation& s)
{
  return find_fault_in_balance(s.model, s.state, keep_ledger(s.model, s.state, s.work));
}

/// Lets a column fall for a while, and judges its row.
void let_fall(Simulation& s)
{
  make_steps(s, 100);
  EXPECT_EQ(fault_of_row(s), "");
}

/// Gives the points as much kinetic energy more [J per m].
void push(Simulation& s, Real energy)
{
  const Real before = kinetic_energy(points_by_id(s.state)), factor = std::sqrt(1.0 + energy / before);
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    for (int d = 0; d < 2; ++d) block.row(Rows::v + d)[lane] *= factor;
  });
}

TEST(Guards, EnergyFromNowhereIsNamedWithItsPlaceAndLikelyCauses)
{
  Simulation s(column("mpm_gp"));
  let_fall(s);
  const Real scale = energy_from_outside(s.state);
  set_value(s.state, 30, Rows::v, std::sqrt(2.0 * 0.6 * scale / points_by_id(s.state)[30].mass));
  TableRow row = keep_ledger(s.model, s.state, s.work);
  const std::string message = find_fault_in_balance(s.model, s.state, row);
  const Real made = s.state.energy_marks.most_unexplained;
  const Vec<2> place = points_by_id(s.state)[30].x;
  EXPECT_NEAR(made, 0.6 * scale, 0.01 * scale);
  EXPECT_EQ(message,
      fmt::format("step 100, t = 0.3030 s: the energy grows by itself: {:.3g} J per m come from nowhere, {:.3g} J came "
                  "from outside\n\n"
                  "  before   kinetic {:.3g} J, elastic {:.3g} J; largest 99.9 % speed {:.3g} m/s\n"
                  "  where    the fastest point, {:.3g} m/s, is in cell 1 at x = {} m, y = {} m; soil there: clay\n"
                  "           24 points per cell of soil; stiffest over softest soil there 1\n"
                  "  likely   an unstable time step, or a stiff body that travels far in pure FLIP\n"
                  "  try      a lower time.courant, or method.flip = 0.9 "
                  "(docs/troubleshooting.md#the-energy-balance-is-off)",
          made, scale, row["kinetic"], row["elastic"], row["v_999"], row["v_max"], coordinate_text(place[0]),
          coordinate_text(place[1])));
}

TEST(Guards, FewPointsPerCellAndSoilsOfDifferentStiffnessAreNamedFirst)
{
  Case c = column("mpm_gp");
  c.bodies[0].points_per_cell = {2, 2};
  c.materials.push_back(elastic(1e9, 0.3, 2000.0));
  c.materials.back().name = "rock";
  c.bodies.push_back(c.bodies[0]);
  c.bodies[0].polygon = {{0.0, 0.0}, {8.0, 0.0}, {8.0, 1.0}, {0.0, 1.0}};
  c.bodies[1].polygon = {{0.0, 1.0}, {8.0, 1.0}, {8.0, 2.0}, {0.0, 2.0}};
  c.bodies[1].material = "rock";
  Simulation s(c);
  make_steps(s, 30);
  EXPECT_EQ(fault_of_row(s), "");
  edit_points(s.state, [](const PointBlock<2>& block, Index lane) {
    if (block.row(Rows::x + 1)[lane] > 0.8 && block.row(Rows::x + 1)[lane] < 1.2) block.row(Rows::v)[lane] = 50.0;
  });
  EXPECT_THAT(fault_of_row(s),
      AllOf(
          HasSubstr("soil there: clay, rock\n           4 points per cell of soil; stiffest over softest soil there "),
          HasSubstr("likely   too few points per cell where soil flows, or soils of very different stiffness in one "
                    "cell, or an unstable time step"),
          HasSubstr("try      body.points_per_cell of 3 at least, or cells that follow their border, or a lower")));
}

// The balance of the ledger closes in each of these.
TEST(Guards, EnergyFromNowhereIsAFaultHoweverItIsBooked)
{
  const std::vector<std::function<void(WorkTotals&, Real)>> books{[](WorkTotals& w, Real made) { w.damping += made; },
      [](WorkTotals& w, Real made) { w.relaxation += made; }, [](WorkTotals& w, Real made) { w.plastic -= made; },
      [](WorkTotals& w, Real made) { w.outer[outer_balance] += made; }};
  for (const auto& book : books) {
    Simulation s(column("mpm_gp"));
    let_fall(s);
    const Real made = 0.6 * energy_from_outside(s.state);
    push(s, made);
    book(s.state.work, made);
    EXPECT_LT(std::abs(keep_ledger(s.model, s.state, s.work)["unexplained"]), 0.05 * made);
    EXPECT_THAT(fault_of_row(s), HasSubstr("the energy grows by itself"));
    EXPECT_NEAR(unexplained_share(s.state), 0.6, 0.01);
  }
}

// Its work was once part of `water_work`.
TEST(Guards, EnergyOfExcessPressureFromNowhereIsAFault)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 2.0}, elastic(1e7, 0.3, 2000.0));
  c.mesh.size = {4.0, 3.0};
  c.materials[0].drainage = Drainage::undrained_effective;
  c.materials[0].undrained_poisson_ratio = 0.48;
  c.forces.gravity = {0.0, -9.81};
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::fixed)};
  Simulation s(c);
  make_steps(s, 100);
  EXPECT_EQ(fault_of_row(s), "");
  const Real volume = 4.0 * 2.0, made = energy_from_outside(s.state);
  const SoilMaterial& soil = s.model.materials[0];
  edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
    block.row(soil.excess_row)[lane] += std::sqrt(2.0 * soil.water_stiffness * made / volume);
  });
  EXPECT_THAT(fault_of_row(s), HasSubstr("the energy grows by itself"));
}

TEST(Guards, EnergyThatIsLostIsAFault)
{
  Simulation s(column("mpm_gp"));
  let_fall(s);
  const Real lost = 0.6 * energy_from_outside(s.state) / 0.4;
  s.state.work.gravity += lost;
  s.state.work.from_outside += lost;
  EXPECT_THAT(fault_of_row(s), HasSubstr("J per m of energy were lost and nothing explains it, "));
}

TEST(Guards, WhatTransferAndPressuresLoseIsExplainedAndWhatTheyGainIsNot)
{
  for (Real WorkTotals::*part : {&WorkTotals::taken, &WorkTotals::reset}) {
    Simulation s(column("mpm_gp"));
    let_fall(s);
    const Real share = unexplained_share(s.state), lost = 0.6 * energy_from_outside(s.state) / 0.4;
    s.state.work.gravity += lost;
    s.state.work.from_outside += lost;
    s.state.work.*part -= lost;
    EXPECT_EQ(fault_of_row(s), "");
    EXPECT_LE(unexplained_share(s.state), share + 0.005);
    s.state.work.*part += 2.0 * lost;
    EXPECT_THAT(fault_of_row(s), HasSubstr("were lost"));
  }
}

TEST(Guards, PlasticWorkThatIsGivenBackIsAFault)
{
  Simulation s(column("mpm_gp"));
  let_fall(s);
  const Real scale = energy_from_outside(s.state);
  s.state.work.plastic -= 0.9e-3 * scale;
  EXPECT_EQ(fault_of_row(s), "");
  s.state.work.plastic -= 0.2e-3 * scale;
  EXPECT_THAT(fault_of_row(s), HasSubstr("J per m of plastic work and slip were given back, which no soil can, "));
}

TEST(Guards, TheLargestShareOfUnexplainedEnergyIsRemembered)
{
  Simulation s(column("mpm_gp"));
  let_fall(s);
  const Real made = 0.1 * energy_from_outside(s.state);
  s.state.work.gravity -= made;
  EXPECT_EQ(fault_of_row(s), "");
  s.state.work.gravity += made;
  EXPECT_EQ(fault_of_row(s), "");
  EXPECT_NEAR(unexplained_share(s.state), 0.1, 0.005);
  EXPECT_EQ(summarise(s.model, s.state).unexplained_energy, unexplained_share(s.state));
  EXPECT_EQ(unexplained_share(restore(s.model, make_image(s.state))), unexplained_share(s.state));
}

// Once in a period gravity has done no work on the whole of an elastic layer that swings, and 28 J to and fro.
TEST(Guards, WorkThatSwingsToAndFroWasExchanged)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.0}, elastic(1e7, 0.3, 2000.0));
  c.mesh.size = {4.0, 2.0};
  c.mesh.cell = {0.25, 0.25};
  c.forces.gravity = {0.0, -9.81};
  c.sides = {side("left", SideKind::roller), side("right", SideKind::roller), side("bottom", SideKind::fixed)};
  Simulation s(c);
  Real largest = 0.0, least_share = 1.0;
  while (s.state.time < 0.1) {
    make_steps(s);
    largest = std::max(largest, std::abs(s.state.work.gravity));
    EXPECT_EQ(fault_of_row(s), "") << s.state.step;
    EXPECT_GE(energy_from_outside(s.state), largest);
    least_share = std::min(least_share, std::abs(s.state.work.gravity) / largest);
  }
  EXPECT_LT(least_share, 0.1);  // it did swing back
}

// Forces work at the stress of the start of a step: in the first step of sides that move, all energy that is stored is
// without work, later 1/n of it.
TEST(Guards, TheOffsetOfHalfAStepIsNoGainOfEnergy)
{
  Simulation s(column("mpm_gp"));
  make_steps(s, 1);
  TableRow row = keep_ledger(s.model, s.state, s.work);
  row["elastic"] = 5.0 * energy_from_outside(s.state);
  row["unexplained"] = 1.1 * row["elastic"];
  EXPECT_EQ(find_fault_in_balance(s.model, s.state, row), "");
  s.state.step = 20;
  EXPECT_THAT(
      find_fault_in_balance(s.model, s.state, row), HasSubstr("step 20, t = 0.0030 s: the energy grows by itself"));
}

TEST(Guards, SoilSoLooseThatItsWavesOvertakeTheTimeStepIsAFault)
{
  Simulation s(column("mpm_gp"));
  let_fall(s);
  TableRow row = keep_ledger(s.model, s.state, s.work);
  row["numerical"] = row["unexplained"] = 0.06 * energy_from_outside(s.state);
  const auto swell = [&](Real last_id, Real factor) {
    edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
      if (block.row(Rows::id)[lane] <= last_id) block.row(Rows::volume)[lane] *= factor;
    });
  };
  swell(79.0,
      1.1);  // 5 % of 1600 points; courant 0.98: waves may become faster by 1/0.98, volumes larger by 1/0.98^2 = 1.041
  EXPECT_EQ(find_fault_in_balance(s.model, s.state, row), "");
  swell(159.0, 1.03);
  EXPECT_EQ(find_fault_in_balance(s.model, s.state, row), "");
  swell(159.0, 1.02);
  EXPECT_EQ(find_fault_in_balance(s.model, s.state, row),
      "step 100, t = 0.3030 s: the time step has become too long for 10 % of the soil, more than 5 %\n\n"
      "  where    soil so loose that its waves cross the smallest cell (0.5 m) within dt = 0.00303 s\n"
      "  likely   soil that swells without end, often under tension; dt is that of the density at t = 0\n"
      "  try      a time.courant lower than 0.98 (docs/troubleshooting.md#the-time-step-is-too-long)");
  row["numerical"] = row["unexplained"] = -0.06 * energy_from_outside(s.state);  // a loss does no harm
  EXPECT_EQ(find_fault_in_balance(s.model, s.state, row), "");
}

/// Spoils a point's velocity at a step, and keeps what a run that stops itself hands over.
struct Saboteur : Observer {
  State* state = nullptr;
  std::int64_t at_step = -1;
  Real velocity = NAN;
  std::vector<std::int64_t> saved_steps;

  void rows(const std::vector<TableRow>& rows) override
  {
    if (rows[0].table->name != "ledger" || rows[0]["step"] != at_step) return;
    set_value(*state, 700, Rows::v, velocity);
  }
  std::string save_failed(const StateImage& image) override
  {
    saved_steps.push_back(image.step);
    return "runs/column/failed.h5";
  }
};

std::string message_of_run(Simulation& s, Saboteur& saboteur)
{
  saboteur.state = &s.state;
  s.observers = {&saboteur};
  return refusal<RunError>([&] { s.run(); });
}

/// The column with a row of the ledger at every step.
Simulation column_with_rows()
{
  Case c = column("mpm_gp");
  c.output.ledger_every = 1e-9;
  return Simulation(c);
}

TEST(Guards, ARunThatMeetsNotANumberStopsAfterThatStepAndKeepsItsState)
{
  Simulation s = column_with_rows();
  Saboteur saboteur;
  saboteur.at_step = 4;
  const std::string message = message_of_run(s, saboteur);
  EXPECT_THAT(message, HasSubstr("step 5, t = 0.0152 s: the "));
  EXPECT_THAT(message, ContainsRegex("of material point [0-9]+ is not a number"));
  EXPECT_THAT(message, HasSubstr("material `clay` (tresca_softening)"));
  EXPECT_THAT(message, EndsWith("\n  saved    runs/column/failed.h5"));
  EXPECT_EQ(saboteur.saved_steps, std::vector<std::int64_t>{5});
}

TEST(Guards, ARunThatGainsEnergyStopsAtItsNextRow)
{
  Simulation s = column_with_rows();
  Saboteur saboteur;
  saboteur.at_step = 120;
  saboteur.velocity = 30.0;
  EXPECT_THAT(message_of_run(s, saboteur), AllOf(HasSubstr("step 121, t = 0.3667 s: the energy grows by itself: "),
                                               HasSubstr("  saved    runs/column/failed.h5")));
  EXPECT_EQ(saboteur.saved_steps, std::vector<std::int64_t>{121});
}

}  // namespace guards_test
