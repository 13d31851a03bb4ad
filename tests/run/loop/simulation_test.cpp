#include "model/meshes/setup_mesh.hpp"
#include "mpm/step/workspace.hpp"
#include "support/simulations.hpp"

namespace simulation_test {

/// 132 steps of 1/330 s.
Case sliding_column()
{
  Case c = column("mpm_gp", 0.5);
  c.time.end = 0.2;
  c.bodies[0].velocity = {2.0, 0.0};
  c.output.fields_every = 0.05;
  return c;
}

TEST(Simulation, InPiecesEndsInTheBitsOfOneRun)
{
  Simulation whole(sliding_column()), pieces(sliding_column());
  EXPECT_EQ(whole.run(), Outcome::finished);
  EXPECT_EQ(pieces.start(), Outcome::finished);
  EXPECT_EQ(pieces.start(), Outcome::finished);  // once
  EXPECT_EQ(pieces.state.rows_reported.at("ledger"), 1);
  pieces.step();
  pieces.step(10);
  pieces.advance_to(0.1);
  pieces.advance_to(0.2);
  EXPECT_EQ(pieces.state.step, pieces.model.n_steps);
  EXPECT_EQ(first_difference(whole.save(), pieces.save()), "");
}

TEST(Simulation, AdvancesToTheFirstStepAtOrAfterATime)
{
  Simulation s(sliding_column());
  s.advance_to(10.5 * s.model.dt);
  EXPECT_EQ(s.state.step, 11);
  s.advance_to(12.0 * s.model.dt);
  EXPECT_EQ(s.state.step, 12);
}

TEST(Simulation, RefusesToGoBack)
{
  Simulation s(sliding_column());
  s.step(5);
  EXPECT_THAT(refusal<InputError>([&] { s.advance_to(0.0); }),
      AllOf(HasSubstr("the run cannot advance to t = 0 s"), HasSubstr("It is at t = ")));
  EXPECT_THAT(refusal<InputError>([&] { s.advance_to(std::nan("")); }), HasSubstr("cannot advance to t = nan s"));
  EXPECT_THAT(refusal<InputError>([&] { s.advance_to(1e12); }), HasSubstr("cannot advance to t = 1000000000000 s"));
  EXPECT_THAT(refusal<InputError>([&] { s.step(-1); }), HasSubstr("-1 steps cannot be made"));
  EXPECT_EQ(s.state.step, 5);
}

TEST(Simulation, GoesOnBeyondTheEndOfItsCase)
{
  Simulation s(sliding_column());
  s.run();
  const std::int64_t end = s.state.step;
  s.advance_to(s.state.time + 2.5 * s.model.dt);
  EXPECT_EQ(s.state.step, end + 3);
  s.step(4);
  EXPECT_EQ(s.state.step, end + 7);
}

TEST(Simulation, GoesOnFromASavedStateWithTheSameBits)
{
  Simulation s(sliding_column());
  s.step(20);
  const StateImage saved = s.save();
  s.step(30);
  const StateImage first = s.save();
  s.restore(saved);
  EXPECT_EQ(first_difference(s.save(), saved), "");
  s.step(30);
  EXPECT_EQ(first_difference(s.save(), first), "");
}

TEST(Simulation, RefusesASavedStateOfAnotherCase)
{
  Simulation saved(sliding_column());
  saved.advance_to(0.1);
  Case fewer = sliding_column(), slower = sliding_column();
  fewer.bodies[0].points_per_cell = {2, 2};
  slower.time.courant *= 0.5;
  Simulation other(fewer), steps(slower);
  EXPECT_THAT(
      [&] { other.restore(saved.save()); }, ThrowsMessage<FileError>(HasSubstr("of another case: it has 1600")));
  EXPECT_THAT(
      [&] { steps.restore(saved.save()); }, ThrowsMessage<FileError>(HasSubstr("of another case: its 33 steps")));
  EXPECT_EQ(other.state.time, 0.0);
}

TEST(Simulation, SeeksTheEquilibriumThatTheCaseAsksForBeforeItsFirstStep)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 1.5}, elastic(2e6, 0.3, 2000.0));
  c.forces.gravity = {0.0, -9.81};
  c.initial.stress = InitialStress::equilibrium;
  for (const char* name : {"left", "right", "bottom"}) c.sides.push_back(side(name, SideKind::roller));
  Simulation s(c);
  s.step();
  EXPECT_GT(s.state.equilibrium_steps, 10);
  EXPECT_EQ(s.state.step, 1);
  EXPECT_LT(s.work.unbalanced_ratio, 1e-2);
}

TEST(Simulation, StopsItselfWhereARunDoes)
{
  Case c = sliding_column();
  c.bodies[0].velocity = {60.0, 0.0};
  for (SideCondition& side : c.sides)
    if (side.side == "right") side.kind = SideKind::free;
  Simulation s(c);
  EXPECT_THROW(s.run(), RunError);
}

TEST(Simulation, ReadsFieldsByTheirNamesInResults)
{
  Simulation s(sliding_column());
  const PointField velocity = s.field("velocity"), position = s.field("position"), strain = s.field("eps_eq_p");
  const auto points = points_by_id(s.state);
  ASSERT_EQ(velocity.values.size(), 3 * points.size());
  ASSERT_EQ(position.values.size(), 2 * points.size());
  ASSERT_EQ(strain.values.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_EQ(velocity.values[3 * k + d], points[k].v[d]);
      EXPECT_EQ(position.values[2 * k + d], points[k].x[d]);
    }
  EXPECT_EQ(velocity.unit, "m/s");
  EXPECT_THAT(refusal<InputError>([&] { s.field("speed"); }),
      AllOf(HasSubstr("speed: there is no field of this name"), HasSubstr("Fields of this run: position, velocity,")));
}

TEST(Simulation, SetsFieldsOfAllPointsById)
{
  Simulation s(sliding_column());
  for (const char* name : {"velocity", "stress", "strain", "volume", "eps_eq_p"}) {
    PointField field = s.field(name);
    for (std::size_t k = 0; k < field.values.size(); ++k)
      if (field.n_components != 3 || k % 3 != 2) field.values[k] = 0.01 + 1e-6 * static_cast<Real>(k);
    s.set_field(name, field.values);
    EXPECT_EQ(s.field(name).values, field.values) << name;
  }
}

TEST(Simulation, RefusesFieldsThatCannotBeSet)
{
  Simulation s(sliding_column());
  std::vector<Real> strain = s.field("eps_eq_p").values, velocity = s.field("velocity").values;
  EXPECT_THAT(refusal<InputError>([&] { s.set_field("su", strain); }),
      AllOf(HasSubstr("su: there is no field of this name that can be set"),
          HasSubstr("velocity, volume, stress, strain")));
  EXPECT_THAT(refusal<InputError>([&] { s.set_field("velocity", strain); }),
      AllOf(HasSubstr("1600 values were given, 4800 are needed"), HasSubstr("Its shape is [1600, 3], sorted by id.")));
  strain[7] = std::nan("");
  EXPECT_THAT(refusal<InputError>([&] { s.set_field("eps_eq_p", strain); }),
      HasSubstr("the value of material point 7 is not a finite number"));
  velocity[3 * 5 + 2] = 1.0;
  EXPECT_THAT(
      refusal<InputError>([&] { s.set_field("velocity", velocity); }), HasSubstr("point 5 points out of the plane"));
  std::vector<Real> volume = s.field("volume").values;
  volume[9] = 0.0;
  EXPECT_THAT(refusal<InputError>([&] { s.set_field("volume", volume); }),
      HasSubstr("the volume of material point 9 is not positive"));
  EXPECT_EQ(s.field("eps_eq_p").values[7], 0.0);  // nothing was changed
}

TEST(Simulation, OfTwoMaterialsSetsAVariableWhereItIs)
{
  Case c = sliding_column();
  c.materials.push_back(elastic(2e6, 0.3, 2000.0));
  c.bodies.push_back(body(c.materials.back().name, {0.0, 0.0}, {2.0, 2.0}));
  Simulation s(c);
  std::vector<Real> strain = s.field("eps_eq_p").values;
  std::size_t soil = strain.size(), rock = strain.size();
  for (std::size_t k = 0; k < strain.size(); ++k) (std::isnan(strain[k]) ? rock : soil) = k;
  strain[soil] = 0.5;
  s.set_field("eps_eq_p", strain);
  EXPECT_EQ(s.field("eps_eq_p").values[soil], 0.5);
  strain[rock] = 0.5;
  EXPECT_THAT(
      refusal<InputError>([&] { s.set_field("eps_eq_p", strain); }), HasSubstr("has no `eps_eq_p`: give NaN there"));
}

TEST(Simulation, WhatIsSetDuringTheRunIsNoFaultOfItsBalanceOrItsHistory)
{
  Simulation s = followed(sliding_column());
  s.step(20);
  PointField velocity = s.field("velocity"), strain = s.field("eps_eq_p");
  for (Real& v : velocity.values) v *= 3.0;
  for (Real& e : strain.values) e += 0.1;
  s.set_field("eps_eq_p", strain.values);
  for (Real& e : strain.values) e -= 0.1;
  s.set_field("velocity", velocity.values);
  s.set_field("eps_eq_p", strain.values);
  s.run();
  const Summary summary = summarise(s.model, s.state);
  EXPECT_LT(summary.energy_balance_error, 0.05);
  EXPECT_EQ(summary.points_eps_eq_p_fell, 0);
}

TEST(Simulation, ManyRunsHoldOneMesh)
{
  const Case c = sliding_column();
  const auto mesh = std::make_shared<const Mesh<2>>(build_mesh(c));
  Simulation a(c, mesh), b(c, mesh), own(c);
  EXPECT_EQ(a.model.mesh.get(), b.model.mesh.get());
  for (Simulation* s : {&a, &b, &own}) s->step(5);
  EXPECT_EQ(first_difference(a.save(), b.save()), "");
  EXPECT_EQ(first_difference(a.save(), own.save()), "");
}

}  // namespace simulation_test
