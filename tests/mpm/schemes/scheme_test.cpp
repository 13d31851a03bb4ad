#include "mpm/schemes/scheme.hpp"
#include "support/simulations.hpp"

namespace scheme_test {

TEST(Schemes, ListsEverySchemeOnceWithALineOfText)
{
  std::vector<std::string> names;
  for (const Scheme* scheme : all_schemes()) {
    names.emplace_back(scheme->name);
    EXPECT_FALSE(scheme->summary.empty()) << scheme->name;
    EXPECT_FALSE(scheme->title.empty()) << scheme->name;
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"standard_mpm", "mpm_mixed", "mpm_gp"}));
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(Schemes, AreFoundByNameAndOnlyByName)
{
  for (const Scheme* scheme : all_schemes()) EXPECT_EQ(find_scheme(scheme->name), scheme);
  EXPECT_EQ(find_scheme("mpm"), nullptr);
}

StateImage after_steps(std::string_view scheme, void (*change)(MethodOptions&))
{
  Case c = column(std::string(scheme));
  c.bodies[0].velocity = {2.0, 0.5};
  c.method.shares = Shares::overlap;
  change(c.method);
  Simulation s(c);
  s.step(40);
  return make_image(s.state);
}

TEST(Schemes, SaysTruthfullyWhichOptionsChangeNothing)
{
  using Change = std::pair<const char*, void (*)(MethodOptions&)>;
  const Change changes[] = {
      {"weights", [](MethodOptions& m) { m.weights = Weights::summed; }},
      {"filled_fraction", [](MethodOptions& m) { m.filled_fraction = 0.5; }},
      {"b_bar", [](MethodOptions& m) { m.b_bar = false; }},
      {"strain_shares", [](MethodOptions& m) { m.strain_shares = StrainShares::plain; }},
      {"volume_change", [](MethodOptions& m) { m.volume_change = VolumeChange::centre; }},
      {"pressure", [](MethodOptions& m) { m.pressure = Pressure::constant; }},
      {"objective_rate", [](MethodOptions& m) { m.objective_rate = ObjectiveRate::jaumann; }},
      {"flip", [](MethodOptions& m) { m.flip = 0.9; }},
  };
  for (const Scheme* scheme : all_schemes()) {
    const StateImage plain = after_steps(scheme->name, [](MethodOptions&) {});
    for (const auto& [option, change] : changes) {
      const bool changes_nothing = first_difference(plain, after_steps(scheme->name, change)).empty();
      EXPECT_EQ(changes_nothing, !looks_at(*scheme, option)) << scheme->name << ' ' << option;
    }
  }
}

Case falling_block(std::string_view scheme, Drainage drainage)
{
  Case c = free_box(std::string(scheme), {0.5, 0.5}, {2.0, 1.5}, elastic(2.0e5, 0.2, 1700.0));
  c.materials[0].drainage = drainage;
  c.materials[0].undrained_poisson_ratio = 0.48;
  c.bodies[0].velocity_at = [](Vec<2> x) { return Vec<2>{-0.5 * x[0], 0.0}; };
  c.forces.gravity = {0.0, -10.0};
  return c;
}

TEST(Schemes, GiveDrainedSoilThePullOfTheWaterAroundIt)
{
  for (const Scheme* scheme : all_schemes()) {
    Case c = falling_block(scheme->name, Drainage::drained);
    c.bodies[0].velocity_at = {};
    c.water.start.phreatic_line = {{0.0, 3.0}};
    Simulation s(c);
    s.step(5);
    const Real weight = 1.5 * 1700.0 * 10.0, uplift = 1.5 * c.water.unit_weight;
    const Real momentum = keep_ledger(s.model, s.state, s.work)["momentum_y"];
    EXPECT_NEAR(momentum / s.state.time, uplift - weight, 1e-3 * weight) << scheme->name;
  }
}

TEST(Schemes, PressThePoreWaterOfUndrainedSoil)
{
  for (const Scheme* scheme : all_schemes()) {
    Simulation s(falling_block(scheme->name, Drainage::undrained_effective));
    s.step(1);  // the middle of the block knows nothing of its surface yet
    Real middle = 0.0;
    for_each_point(s.state.points, [&](const PointBlock<2>& block, Index lane) {
      const Real x = block.row(Rows::x)[lane], y = block.row(Rows::x + 1)[lane];
      if (std::hypot(x - 1.25, y - 1.0) < 0.2) middle = block.row(s.model.materials[0].excess_row)[lane];
    });
    const Real stiffness = 2.0e5 * (2.0 * 1.48 / 0.12 - 2.0 * 1.2 / 1.8), rate = 0.5;  // K_w/n [Pa], [1/s]
    EXPECT_NEAR(middle, stiffness * rate * s.state.time, 1e-6 * stiffness) << scheme->name;
    s.step(1);
    const TableRow row = keep_ledger(s.model, s.state, s.work);
    EXPECT_GT(row["pore_elastic"], row["elastic"]) << scheme->name;
    EXPECT_EQ(row["water_work"], 0.0) << scheme->name;
  }
}

}  // namespace scheme_test
