#include "run/loop/stages.hpp"
#include "support/paths.hpp"
#include "support/simulations.hpp"
#include "support/stages.hpp"

namespace stages_test {

TEST(Stages, InWhichNothingChangesGiveTheBitsOfOneRun)
{
  for (const char* scheme : {"mpm_mixed", "mpm_gp"}) {
    Case one = column(scheme);
    const Case chain = staged(one, {{stage("a", 0.07), {}}, {stage("b", 0.13), {}}, {stage("c", 0.1), {}}});
    one.time.end = chain.time.end;
    Simulation a(one), b(chain);
    a.run(), b.run();
    EXPECT_EQ(a.state.step, b.state.step);
    EXPECT_EQ(a.state.time, b.state.time);
    EXPECT_EQ(a.model.dt, b.model.dt);
    EXPECT_EQ(b.state.stages_done.size(), 3u);
    EXPECT_EQ(different_arrays(a.save(), b.save()),
        (std::vector<std::string>{"counts", "stage", "stages_done"}));  // the ends of stages are due rows here
    EXPECT_EQ(a.state.clamped, b.state.clamped);
  }
}

TEST(Stages, OfLoadsAloneDoNotReadAFileOfPointsAgain)
{
  const ScratchFolder folder;
  Case c = settling();
  c.folder = folder.path();
  c.bodies = std::vector<BodyCase>(1);
  c.bodies[0].points_file = "points.csv";
  const std::string file = c.folder + "/points.csv";
  std::ofstream(file) << "x,y,volume,material\n0.6,0.1,0.04," << c.materials[0].called() << '\n';
  Simulation s(staged(c, {{stage("a", 0.03), {}}, {stage("b", 0.03), [](Case& b) { b.forces.gravity[1] = -5.0; }}}));
  std::filesystem::remove(file);
  s.run();
  EXPECT_EQ(s.state.stages_done.size(), 2u);
}

TEST(Stages, EndAtWholeStepsNearestToTheirTimes)
{
  Simulation s(staged(settling(), {{stage("a", 1.0), {}}, {stage("b", 2.5), {}}, {stage("c", 0.5), {}}}));
  s.advance_to(2.0);
  const std::vector<StageSummary> so_far = summarise(s.model, s.state).stages;
  ASSERT_EQ(so_far.size(), 2u);
  EXPECT_EQ(so_far[1].name, "b");  // it runs
  EXPECT_EQ(so_far[1].record.start, so_far[0].record.end);
  EXPECT_TRUE(std::isnan(so_far[1].record.end));
  s.run();
  EXPECT_EQ(summarise(s.model, s.state).stages.size(), 3u);
  ASSERT_EQ(s.state.stages_done.size(), 3u);
  EXPECT_NEAR(s.state.stages_done[0].end, 1.0, 0.5 * s.model.dt);
  EXPECT_NEAR(s.state.stages_done[1].end, 3.5, 0.5 * s.model.dt);
  EXPECT_EQ(s.state.time, s.state.stages_done[2].end);
  EXPECT_NEAR(s.state.time, 4.0, 1e-12);
  EXPECT_EQ(s.state.step, s.model.n_steps);
}

TEST(Stages, ARunThatEndsAtRestEndsThere)
{
  Case c = settling();
  c.time.until = Until::at_rest;
  c.time.rest_time = 0.2;
  Simulation s(c);
  EXPECT_EQ(s.run(), Outcome::finished);
  EXPECT_LT(s.state.time, 3.0);
  EXPECT_GT(s.state.time, 0.3);
  EXPECT_NEAR(stress_at_base(s.state), -2000.0 * 10.0 * 0.875, 200.0);
  ASSERT_EQ(s.state.stages_done.size(), 1u);
  EXPECT_TRUE(s.state.stages_done[0].at_rest);
  EXPECT_LT(s.state.stages_done[0].fastest, 1e-3);
  const std::int64_t step = s.state.step;
  s.run();  // it has ended
  EXPECT_EQ(s.state.step, step);
  s.step(5);  // beyond its end, if so wanted
  EXPECT_EQ(s.state.step, step + 5);
}

TEST(Stages, ARunThatDoesNotComeToRestEndsWithItsTimeAndSaysSo)
{
  Case c = settling();
  c.time.until = Until::at_rest;
  c.time.end = c.time.at_most = 0.1;
  Simulation s(c);
  s.run();
  EXPECT_NEAR(s.state.time, 0.1, 1e-12);
  ASSERT_EQ(s.state.stages_done.size(), 1u);
  EXPECT_FALSE(s.state.stages_done[0].at_rest);
  EXPECT_GT(s.state.stages_done[0].fastest, 1e-3);
  EXPECT_EQ(summarise(s.model, s.state).stages.size(), 1u);
}

/// Soil that flies on as it is, or swings on: nothing damps it.
Case undamped(Case c, Real rest_time)
{
  c.forces.local_damping = 0.0;
  c.time = {.end = 5.0, .until = Until::at_rest, .at_most = 5.0, .rest_by = RestBy::mean, .rest_time = rest_time};
  return c;
}

TEST(Stages, SoilRestsByItsMeanMotionWhereItGoesLessFarThanItsSpeedAllows)
{
  Case c = undamped(free_box("mpm_gp", {0.5, 0.0}, {2.5, 1.0}, elastic(2e6, 0.3, 2000.0)), 1.0);
  c.forces.gravity = {0.0, 0.0};
  c.time.rest_speed = 0.1;
  c.bodies[0].velocity = {0.099, 0.0};
  Simulation slow(c);
  slow.run();
  EXPECT_TRUE(slow.state.stages_done.at(0).at_rest);
  EXPECT_NEAR(slow.state.time, 1.0, 5.0 * slow.model.dt);  // the first step, and four whole parts of rest_time
  EXPECT_NEAR(slow.state.stages_done[0].fastest, 0.099, 1e-9);
  c.bodies[0].velocity = {0.101, 0.0};
  c.time.end = c.time.at_most = 2.0;
  Simulation fast(c);
  fast.run();
  EXPECT_FALSE(fast.state.stages_done.at(0).at_rest);
}

TEST(Stages, SoilThatSwingsInPlaceRestsByItsMeanMotionAlone)
{
  const Real period = 4.0 / std::sqrt(2e6 * 3.5 / 2000.0);  // 4 H / c_p of the column: c_p^2 = 3.5 G / rho
  Case c = undamped(settling(), 4.0 * period);
  c.time.rest_speed = 5e-3;  // 1.4 mm in that time; the top swings by 2.9 mm, with up to g H / c_p = 0.17 m/s
  Simulation swings(c);
  swings.run();
  EXPECT_TRUE(swings.state.stages_done.at(0).at_rest);
  EXPECT_LT(swings.state.time, 5.0 * period);
  c.time.rest_by = RestBy::fastest;
  c.time.end = c.time.at_most = 1.0;
  Simulation by_nodes(c);
  by_nodes.run();
  EXPECT_FALSE(by_nodes.state.stages_done.at(0).at_rest);
}

TEST(Stages, RestWaitsForRampsAndLoadsThatAreToCome)
{
  Case c = settling();
  c.time.rest_time = 0.1;
  c.loads = {{.name = "late", .from = 0.0, .to = 4.0, .pressure = 5e3, .start = 2.0, .ramp = 0.5}};
  c.time.until = Until::at_rest;
  c.time.end = c.time.at_most = 10.0;
  Simulation s(c);
  s.run();
  EXPECT_GT(s.state.time, 2.5);
  EXPECT_LT(s.state.time, 6.0);
  EXPECT_NEAR(stress_at_base(s.state), -(2000.0 * 10.0 * 0.875 + 5e3), 250.0);
  c.time.rest_by = RestBy::mean;
  Simulation by_mean(c);
  by_mean.run();
  EXPECT_GT(by_mean.state.time, 2.6);
  EXPECT_LE(by_mean.state.time, s.state.time);
}

// A dike is not at rest before the river comes.
TEST(Stages, RestWaitsForWaterThatIsToCome)
{
  Case c = settling();
  c.time.rest_time = 0.1;
  c.time.until = Until::at_rest;
  c.time.end = c.time.at_most = 4.0;
  c.water.start.phreatic_line = {{0.0, 0.2}};
  c.water.situations = {{.name = "still", .time = 2.0, .phreatic_line = {{0.0, 0.2}}},
      {.name = "flood", .time = 2.5, .phreatic_line = {{0.0, 0.9}}}};
  Simulation s(c);
  s.run();
  EXPECT_GT(s.state.time, 2.5);
  EXPECT_LT(s.state.time, 4.0);
  c.water = {};
  c.water.start.formula = [](Vec<2> x, Real t) { return std::max(0.0, 9810.0 * (0.2 + 1e-9 * t - x[1])); };
  c.water.start.formula_changes = true;
  c.time.end = c.time.at_most = 1.5;
  Simulation never(c);
  never.run();
  EXPECT_FALSE(never.state.stages_done.at(0).at_rest);
}

TEST(Stages, ChangeLoadsAndGravity)
{
  Case c = settling();
  c.time.rest_time = 0.2;
  c.time.courant = 0.5;  // near 1 the work of local damping after a sudden load is booked 10 % too small
  c.loads = {{.name = "q", .from = 0.0, .to = 4.0, .pressure = 0.0}};
  StageCase heavy = resting("heavy", 5.0);
  heavy.ramp = 0.3;
  const Case chain =
      staged(c, {{resting("settle", 5.0), {}}, {resting("load", 5.0), [](Case& now) { now.loads[0].pressure = 8e3; }},
                    {heavy, [](Case& now) {
                       now.forces.gravity = {0.0, -20.0};
                     }}});
  Simulation s = followed(chain);
  s.run();
  ASSERT_EQ(s.state.stages_done.size(), 3u);
  for (const StageRecord& record : s.state.stages_done) EXPECT_TRUE(record.at_rest);
  EXPECT_LT(s.state.time, 10.0);
  EXPECT_NEAR(stress_at_base(s.state), -(2000.0 * 20.0 * 0.875 + 8e3), 500.0);
  const Real exchanged = energy_exchanged(s.state);
  const Real numerical = kinetic_and_stored_energy(s.model, s.state) - s.state.start_energy - s.state.work.given();
  EXPECT_LT(std::abs(numerical), 0.02 * exchanged);
  EXPECT_EQ(keep_ledger(s.model, s.state, s.work)["stage"], 3.0);
}

TEST(Stages, MayGiveSoilALimitOfTensionWhoseOpeningAllStagesHave)
{
  Case c = settling();
  c.materials = {clay()};
  const std::string name = c.materials[0].name;
  c.bodies = {body(name, {0.0, 0.0}, {2.0, 1.0})};
  const std::size_t cutoff = c.materials[0].parameters.size() - 1;
  ASSERT_EQ(find_material("tresca_softening")->parameters[cutoff].name, "tension_cutoff");
  const Case chain =
      staged(c, {{stage("whole", 0.1), {}},
                    {stage("cracked", 0.3), [cutoff](Case& now) { now.materials[0].parameters[cutoff] = 0.0; }}});
  Simulation s(chain);
  const int row = row_of(s.model.materials[0], Role::opening);
  ASSERT_GE(row, 0);
  s.run();
  EXPECT_EQ(row_of(s.model.materials[0], Role::opening), row);
  for_each_point(s.state.points,
      [&](const PointBlock<2>& block, Index lane) { EXPECT_LE(block.row(Rows::sigma + 2)[lane], 1e-9); });
}

TEST(Stages, GiveBodiesAnotherMaterialWithItsMass)
{
  Case c = settling();
  c.materials.push_back(elastic(8e6, 0.3, 1500.0));
  c.materials[0].name = "soft", c.materials[1].name = "stiff";
  c.bodies = {body("soft", {0.0, 0.0}, {4.0, 0.5}), body("soft", {0.0, 0.5}, {4.0, 1.0})};
  const Case chain =
      staged(c, {{stage("a", 0.2), {}}, {stage("b", 0.2), [](Case& now) { now.bodies[1].material = "stiff"; }}});
  Simulation s(chain);
  const auto first = points_by_id(s.state);
  s.run();
  const auto last = points_by_id(s.state);
  ASSERT_EQ(last.size(), first.size());
  Index stiff = 0;
  for (std::size_t k = 0; k < last.size(); ++k) {
    const bool upper = first[k].x[1] > 0.5;
    EXPECT_EQ(last[k].material, upper ? 1 : 0);
    EXPECT_NEAR(last[k].mass, first[k].mass * (upper ? 0.75 : 1.0), 1e-12);
    stiff += upper;
  }
  EXPECT_GT(stiff, 100);
  Real fastest_wave = std::sqrt(elastic(8e6, 0.3, 1500.0).parameters[0] / 1500.0);
  EXPECT_LT(s.model.dt * fastest_wave, 0.25);  // the step of all stages is that of the stiffest
}

/// The largest pressure that points of Modified Cam-Clay have been loaded to, by number [Pa].
std::vector<Real> loaded_to(const Simulation& s)
{
  std::vector<Real> p_c(static_cast<std::size_t>(s.state.n_ids()));
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    const SoilMaterial& soil = s.model.materials[block.material];
    p_c[static_cast<std::size_t>(block.row(Rows::id)[lane])] = soil.law->derived(0, soil.view(block, lane));
  });
  return p_c;
}

// The law counts from the yield stress of its parameters. What the soil was loaded to is its own.
TEST(Stages, KeepThePressureThatCamClayWasLoadedTo)
{
  const auto soil = [](const char* name, Real angle, Real yield_stress) {
    return MaterialCase{name, "modified_cam_clay", 1600.0, {angle, 0.3, 0.05, 1.8, 0.2, yield_stress, 100e3, 1e3}};
  };
  const std::vector<Change> changes = {[](Case& now) { now.bodies[0].material = "b"; },
      [](Case& now) { now.materials[0].parameters[0] = 25.0; },
      [](Case& now) { now.materials[0].fields[0].value_at = [](Vec<2>) { return 50e3; }; }};
  for (const bool varies : {false, true})
    for (std::size_t k = 0; k < (varies ? 3 : 2); ++k) {
      Case c = settling();
      c.materials = {soil("a", 30.0, 20e3), soil("b", 30.0, 70e3)};
      if (varies) c.materials[0].fields = {{5, [](Vec<2> x) { return 20e3 + 1e3 * x[1]; }}};
      c.bodies[0].material = "a";
      StageCase second = stage("b", 0.02);
      second.changes = {{"material.a.friction_angle", "25"}};
      Simulation s(staged(c, {{stage("a", 0.02), {}}, {second, changes[k]}}));
      while (s.state.stages_done.empty()) s.step(1);
      edit_points(s.state, [&](const PointBlock<2>& block, Index lane) {
        block.row(s.model.materials[0].rows[1])[lane] = std::log(2.0);  // it yielded
      });
      const std::vector<Real> before = loaded_to(s);
      s.step(1);
      const std::vector<Real> after = loaded_to(s);
      for (std::size_t id = 0; id < before.size(); ++id) ASSERT_NEAR(after[id], before[id], 1e-9 * before[id]) << k;
      EXPECT_GT(before[0], 1.9 * 20e3);
    }
}

TEST(Stages, MayCountDisplacementAnew)
{
  StageCase second = stage("b", 0.2);
  second.reset_displacement = true;
  Simulation s(staged(settling(), {{stage("a", 0.5), {}}, {second, {}}}));
  while (s.state.stages_done.empty()) s.step(1);
  const auto before = points_by_id(s.state);
  s.step(1);
  const auto after = points_by_id(s.state);
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(s.state.x_initial[2 * k + 1], before[k].x[1]);
    EXPECT_LT(std::abs(after[k].strain[1]), 1e-3 * std::abs(before[k].strain[1]) + 1e-6);
  }
}

struct Times : Observer {
  void rows(const std::vector<TableRow>& rows) override
  {
    of[std::string(rows[0].table->name)].push_back(rows[0]["time"]);
  }
  std::map<std::string, std::vector<Real>> of;
};

// The step of all stages is one, also where a stage changes what its values follow from.
TEST(Stages, OfWhateverChangeLoseAndRepeatNoRow)
{
  constexpr std::size_t shear_modulus = 0, su_peak = 2;
  const auto change_of = [](auto change) { return Change(change); };
  const auto vary = [](Real base) { return [base](Vec<2> x) { return base * (1.0 + 0.1 * x[1]); }; };
  const std::vector<std::pair<const char*, Change>> changes = {{"nothing", change_of([](Case&) {})},
      {"stiffness", change_of([&](Case& c) { c.materials[0].fields[0].value_at = vary(5e5); })},
      {"strength", change_of([&](Case& c) { c.materials[0].fields[1].value_at = vary(5e3); })},
      {"material", change_of([](Case& c) { c.bodies[1].material = "stiff"; })},
      {"density", change_of([](Case& c) { c.materials[1].density = 1500.0; })}, {"gravity", change_of([](Case& c) {
                                                                                   c.forces.gravity = {0.0, -5.0};
                                                                                 })},
      {"damping", change_of([](Case& c) { c.forces.local_damping = 0.7; })},
      {"load", change_of([](Case& c) { c.loads[0].pressure = 1e3; })},
      {"side", change_of([](Case& c) { c.sides[1].kind = SideKind::free; })}};
  Case c = column("mpm_gp");
  c.materials[0].fields = {{shear_modulus, vary(2e6)}, {su_peak, vary(8e3)}};
  c.materials.push_back(elastic(1e6, 0.3, 1900.0));
  c.materials[1].name = "stiff";
  c.bodies = {body("clay", {0.0, 0.0}, {8.0, 1.0}), body("clay", {0.0, 1.0}, {8.0, 2.0})};
  c.loads = {{.name = "q", .from = 1.0, .to = 2.0, .pressure = 0.0}};
  c.output.ledger_every = c.output.history_every = 0.02;
  c.output.history_points = {{"A", {1.0, 1.0}}};
  for (const auto& [name, change] : changes) {
    Simulation s(staged(c, {{stage("a", 0.11), {}}, {stage("b", 0.11), change}}));
    Times times;
    s.observers = {&times};
    s.run();
    EXPECT_EQ(s.state.time, s.model.time_of(s.state.step)) << name;
    for (const char* table : {"ledger", "history"}) {
      const std::vector<Real>& at = times.of[table];
      EXPECT_EQ(at.size(), 13u) << table << ", " << name << ": 0, 0.02 to 0.22 and 0.11 s, but "
                                << testing::PrintToString(at);
      for (std::size_t k = 1; k < at.size(); ++k) {
        EXPECT_GT(at[k], at[k - 1]) << table << ", " << name;
        EXPECT_LT(at[k] - at[k - 1], 0.02 + 1.5 * s.model.dt) << table << ", " << name;
      }
    }
  }
}

// A strength that varies with the place belongs to the place of the seed, not to where the point has come to.
TEST(Stages, KeepTheFieldsOfTheFirstPlacesWhenDisplacementIsCountedAnew)
{
  constexpr std::size_t su_peak = 2;
  Case c = column("mpm_gp");
  c.materials[0].fields = {{su_peak, [](Vec<2> x) { return 15e3 + 1e3 * x[1]; }}};
  StageCase anew = stage("b", 0.05), changed = stage("c", 0.05);
  anew.reset_displacement = true;
  changed.changes = {{"material.clay.eta", "9"}};
  Simulation s(staged(c, {{stage("a", 0.3), {}}, {anew, {}}, {changed, {}}}));
  const std::vector<Real> seeds = s.state.x_initial;
  s.run();
  const SoilMaterial& soil = s.model.materials[0];
  Real farthest = 0.0;
  for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
    const auto id = static_cast<std::size_t>(block.row(Rows::id)[lane]);
    EXPECT_EQ(*soil.view(block, lane).parameters(0), 15e3 + 1e3 * seeds[2 * id + 1]);
    farthest = std::max(farthest, std::abs(s.state.x_initial[2 * id + 1] - seeds[2 * id + 1]));
  });
  EXPECT_GT(farthest, 1e-3);
}

TEST(Stages, GoOnFromACheckpointWithTheSameBits)
{
  Case c = settling();
  c.loads = {{.name = "q", .from = 1.0, .to = 2.0, .pressure = 0.0}};
  StageCase second = stage("b", 0.3);
  second.ramp = 0.2;
  Case chain = staged(
      c, {{stage("a", 0.2), {}}, {second, [](Case& now) { now.loads[0].pressure = 8e3; }}, {resting("c", 1.0), {}}});
  for (const RestBy by : {RestBy::fastest, RestBy::mean}) {
    chain.time.rest_by = by;
    expect_same_bits(chain, {}, {0.1, 0.2, 0.31, 0.8});
  }
}

/// At the middle of the ramp strengths are the mean of both: 8 kPa over 1 and over 2 s.
StageCase weaker()
{
  StageCase made = ramped("weaker", 0.3, 0.2);
  made.changes = {{"at_strength", "2"}};
  return made;
}
constexpr auto halve = [](Case& now) { now.at_strength = 2.0; };

TEST(Stages, LetStrengthsGoOverTheRampLinearly)
{
  for (const bool varies : {false, true}) {
    Case c = column_without_softening("mpm_gp");
    if (varies) c.materials[0].fields = {{2, [](Vec<2>) { return 8e3; }}, {3, [](Vec<2>) { return 8e3; }}};
    Simulation s(staged(c, {{stage("whole", 0.3), {}}, {weaker(), halve}}));
    s.advance_to(0.3);
    while (s.state.time < 0.58) {
      s.step(1);
      const Real share = std::clamp((s.state.time - s.state.stages_done[0].end) / 0.2, 0.0, 1.0);
      const Real strength = 8e3 * (1.0 - 0.5 * share);
      Real most = 0.0;
      for (const Point& p : points_by_id(s.state))
        most = std::max(most, std::hypot(0.5 * (p.sigma[0] - p.sigma[1]), p.sigma[3]));
      EXPECT_LE(most, strength * (1.0 + 1e-9)) << s.state.time;
      EXPECT_GT(most, strength * (1.0 - 1e-3)) << s.state.time;
    }
  }
}

TEST(Stages, WhoseStrengthIsOnItsWayGoOnWithTheSameBitsFromACheckpointAndOnThreads)
{
  for (const char* scheme : {"mpm_mixed", "mpm_gp"})
    expect_same_bits(
        staged(column(scheme), {{stage("whole", 0.1), {}}, {weaker(), halve}}), {2, 4}, {0.05, 0.1, 0.18, 0.35});
}

TEST(Stages, ShorterThanAStepAreRefused)
{
  const Case chain = staged(settling(), {{stage("a", 1.0), {}}, {stage("b", 1e-5), {}}});
  EXPECT_THAT(refusal<InputError>([&] { build_model(chain, 1); }),
      HasSubstr("stage[1].duration: the stage is shorter than a time step"));
}

}  // namespace stages_test
