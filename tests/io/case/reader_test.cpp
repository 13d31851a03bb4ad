// Every key arrives at its place; keys that are unknown, missing or misplaced: wrong_cases/small_case.wrong.
#include "io/case/reader.hpp"
#include "io/case/key_text.hpp"
#include "io/case/samples.hpp"
#include "support/process.hpp"

namespace reader_test {

const std::string every_key = text_of(source_path("tests/io/case/every_key.toml")),
                  other_keys = text_of(source_path("tests/io/case/other_keys.toml"));

using Numbers = std::vector<Real>;

Case read_every_key() { return read_case_text(every_key, "folder/all.toml").values; }

TEST(Reader, TheSamplesHoldEveryDeclaredKey)
{
  const Node root = parse_toml(every_key), others = parse_toml(other_keys);
  const auto concrete = [](std::string path) {
    const auto swap = [&](const std::string& from, const std::string& to) {
      if (const auto at = path.find(from); at != std::string::npos) path.replace(at, from.size(), to);
    };
    swap("body[].polygon", "body[1].polygon"), swap("situation[].pressure", "situation[1].pressure");
    swap("water.pressure", "water.situation[1].pressure");
    swap("[]", "[0]"), swap("NAME", "clay");
    swap("SIDE.velocity", "right.velocity"), swap("SIDE.slip", "right.slip"), swap("SIDE", "bottom");
    return path;
  };
  for (const KeyInfo& key : all_keys()) {
    const Node* node = find_node(root, concrete(key.path));
    EXPECT_NE(node != nullptr ? node : find_node(others, concrete(key.path)), nullptr) << key.path;
  }
}

TEST(Reader, ABodyForceHasItsFormulasAndSaysWhetherItChanges)
{
  const auto read = [](const std::string& lines) {
    return read_case_text(small_case + "[forces.body]\n" + lines, "case.toml").values.forces.body;
  };
  const BodyForceCase body = read("a = \"2*x0 + y\"\nbx = \"a*3\"\nby = -1.5\n");
  EXPECT_EQ(body.at({9.0, 1.0}, {2.0, 9.0}, 7.0), (Vec<2>{15.0, -1.5}));
  EXPECT_FALSE(body.changes);
  EXPECT_TRUE(read("w = \"6*t\"\nbx = \"sin(w)\"\nby = 0\n").changes);
}

TEST(Reader, FillsTheFloodAndWhatIsGround)
{
  const Case c = read_every_key();
  const FloodCase& f = c.flood;
  EXPECT_EQ((Numbers{f.water_level, f.smallest_freeboard, f.smallest_width, f.intact_below, f.least_depth,
                f.profile_width, f.profile_slope}),
      (Numbers{1.75, 0.15, 2.25, 0.02, 0.85, 3.5, 2.5}));
  EXPECT_EQ(c.flood.river, RiverSide::right);
  EXPECT_FALSE(c.materials[0].ground);
  EXPECT_TRUE(c.materials[1].ground);
}

TEST(Reader, FillsWhatPicturesShow)
{
  const Case c = read_every_key();
  EXPECT_EQ(c.materials[0].color, "#a1B2c3");
  EXPECT_EQ(c.materials[1].color, "");
  ASSERT_EQ(c.slip_planes.size(), 2u);
  const SlipPlaneCase& plane = c.slip_planes[0];
  EXPECT_EQ(plane.name, "wall side");
  EXPECT_EQ(plane.method, "Bishop");
  EXPECT_EQ(plane.factor_of_safety, 1.25);
  EXPECT_THAT(plane.line, ElementsAre(Vec<2>{1.0, 2.0}, Vec<2>{3.0, 0.5}, Vec<2>{6.0, 1.0}));
  ASSERT_EQ(plane.su.size(), 2u);
  EXPECT_EQ((Numbers{plane.su[1].x[0], plane.su[1].x[1], plane.su[1].su}), (Numbers{4.0, 0.75, 6e3}));
  EXPECT_EQ(c.slip_planes[1].method, "");
  EXPECT_TRUE(std::isnan(c.slip_planes[1].factor_of_safety));
}

TEST(Reader, FillsFrameTimeAndMesh)
{
  const Case c = read_every_key();
  EXPECT_EQ(c.title, "all");
  EXPECT_EQ(c.name, "all");
  EXPECT_EQ(c.scheme, "mpm_mixed");
  EXPECT_EQ((Numbers{c.at_strength, c.time.end, c.time.courant}), (Numbers{1.25, 2.5, 0.5}));
  EXPECT_EQ(c.mesh.origin, (Vec<2>{-1.0, 1.0}));
  EXPECT_EQ(c.mesh.size, (Vec<2>{16.0, 3.0}));
  EXPECT_EQ(c.mesh.cell, (Vec<2>{0.5, 0.25}));
}

TEST(Reader, FillsLoads)
{
  const std::vector<LoadCase> loads = read_every_key().loads;
  ASSERT_EQ(loads.size(), 1u);
  const LoadCase& l = loads[0];
  EXPECT_EQ(l.name, "traffic");
  EXPECT_EQ((Numbers{l.from, l.to, l.pressure, l.start, l.end, l.ramp}), (Numbers{1.0, 3.5, 13e3, 0.25, 1.5, 0.125}));
}

TEST(Reader, FillsBodiesAndMaterials)
{
  const Case c = read_every_key();
  ASSERT_EQ(c.bodies.size(), 2u);
  EXPECT_EQ(c.bodies[0].material, "clay");
  EXPECT_EQ(c.bodies[0].points_per_cell, (std::array<Index, 2>{3, 4}));
  EXPECT_EQ(c.bodies[0].velocity, (Vec<2>{0.5, -0.25}));
  EXPECT_EQ(c.bodies[1].points_per_cell, (std::array<Index, 2>{2, 2}));
  EXPECT_THAT(c.bodies[1].polygon, ElementsAre(Vec<2>{9, 1}, Vec<2>{10, 1}, Vec<2>{9, 2}));
  ASSERT_EQ(c.materials.size(), 2u);
  EXPECT_EQ(c.materials[0].name, "clay");
  const auto& softening = c.materials[0].softening;
  EXPECT_EQ((Numbers{softening.length, softening.over_nonlocal, softening.reference_width}), (Numbers{0.75, 1.0, 0.3}));
  EXPECT_TRUE(softening.halo);
  EXPECT_FALSE(c.materials[1].softening.is_nonlocal());
  EXPECT_EQ(c.materials[0].model, "tresca_softening");
  EXPECT_THAT(
      c.materials[0].parameters, ElementsAre(2.0e6, 0.48, 8.0e3, 2.0e3, 50.0, 2.0e3, 0.0, 0.0, INFINITY, INFINITY));
  EXPECT_EQ(c.materials[1].density, 2600.0);
  EXPECT_THAT(c.materials[1].parameters, ElementsAre(1.0e9, 0.25));
}

TEST(Reader, ABodyMayHaveItsStressAtTheStartInNumbers)
{
  const std::string with = small_case + "[forces]\ngravity = [0.0, -9.81]\n[flood]\nwater_level = 1.0\n";
  const auto read = [&](const std::string& stress) {
    std::string text = with;
    text.replace(text.find("[[body]]"), 8, "[[body]]\nstress = " + stress);
    return read_case_text(text, "case.toml");
  };
  const CaseFile file = read("[-5e3, \"-10 kPa\", -5e3, 125]");
  ASSERT_TRUE(file.values.bodies[0].stress);
  EXPECT_THAT(*file.values.bodies[0].stress, ElementsAre(-5e3, -10e3, -5e3, 125.0));
  EXPECT_EQ(file.values.initial.stress, InitialStress::none) << "the flood does not ask for another";
}

TEST(Reader, StartsAtRestWhereThereIsWaterAndGravity)
{
  const auto start = [](const std::string& more) {
    return read_case_text(small_case + more, "case.toml").values.initial.stress;
  };
  const std::string gravity = "[forces]\ngravity = [0.0, -9.81]\n", water = "[water]\nphreatic_line = [[0, 1]]\n";
  EXPECT_EQ(start(gravity + water), InitialStress::equilibrium);
  EXPECT_EQ(start(gravity + "[flood]\nwater_level = 1.0\n"), InitialStress::equilibrium);
  EXPECT_EQ(start(gravity), InitialStress::none);
  EXPECT_EQ(start(water), InitialStress::none);
  EXPECT_EQ(start(gravity + water + "[initial]\nstress = \"k0\"\n"), InitialStress::k0);
  EXPECT_EQ(start(gravity + water + "[initial]\nstress = \"none\"\n"), InitialStress::none);
  EXPECT_THAT(read_case_text(small_case + gravity + water, "case.toml").notes,
      Contains("initial.stress: not given; \"equilibrium\", since the case has water"));
  EXPECT_THAT(read_case_text(small_case + gravity + "[flood]\nwater_level = 1.0\n", "case.toml").notes,
      Contains("initial.stress: not given; \"equilibrium\", since the case has [flood]"));
}

TEST(Reader, FillsForcesAndInitialState)
{
  const Case c = read_every_key();
  EXPECT_EQ(c.forces.gravity, (Vec<2>{0.0, -9.81}));
  EXPECT_EQ((Numbers{c.forces.local_damping, c.forces.averaging_time, c.forces.viscous_damping}),
      (Numbers{0.125, 0.05, 0.25}));
  EXPECT_EQ(c.initial.stress, InitialStress::equilibrium);
  EXPECT_EQ((Numbers{c.initial.k0, c.initial.damping, c.initial.limit}), (Numbers{0.75, 0.7, 1e-4}));
  EXPECT_EQ(c.initial.max_steps, 123);
}

TEST(Reader, FillsTheWater)
{
  const Case c = read_every_key();
  const WaterSituation& start = c.water.start;
  EXPECT_THAT(start.phreatic_line, ElementsAre(Vec<2>{0.0, 2.5}, Vec<2>{8.0, 2.0}, Vec<2>{8.0, 1.5}));
  ASSERT_EQ(start.head_lines.size(), 2u);
  EXPECT_EQ(start.head_lines[1].name, "lower");
  EXPECT_THAT(start.head_lines[1].places, ElementsAre(Vec<2>{0.0, 2.0}, Vec<2>{8.0, 1.0}));
  ASSERT_EQ(start.reference_lines.size(), 2u);
  EXPECT_EQ(start.reference_lines[0].head, "aquifer");
  EXPECT_EQ(start.reference_lines[0].head_bottom, "aquifer");
  EXPECT_EQ(start.reference_lines[1].head, "phreatic");
  EXPECT_EQ(start.reference_lines[1].head_bottom, "lower");
  EXPECT_EQ(c.materials[0].drainage, Drainage::undrained);
  EXPECT_EQ(c.materials[1].drainage, Drainage::undrained_effective);
  EXPECT_EQ((Numbers{c.water.unit_weight, c.water.suction, c.materials[0].k0, c.materials[1].undrained_poisson_ratio}),
      (Numbers{9905.0, 5000.0, 0.625, 0.4875}));
  EXPECT_TRUE(c.materials[1].stores_effective());
  EXPECT_FALSE(c.water.follow_soil);
}

TEST(Reader, AWaterSituationTakesWhatItLeavesOutFromTheStart)
{
  const WaterCase water = read_every_key().water;
  ASSERT_EQ(water.situations.size(), 2u);
  const WaterSituation &high = water.situations[0], &formula = water.situations[1];
  EXPECT_EQ(high.time, 2.0);
  EXPECT_THAT(high.phreatic_line, ElementsAre(Vec<2>{0.0, 2.75}));
  ASSERT_EQ(high.head_lines.size(), 2u);
  EXPECT_EQ(high.head_lines[1].name, "lower");
  ASSERT_EQ(high.reference_lines.size(), 1u);
  EXPECT_TRUE(formula.phreatic_line.empty());
  EXPECT_TRUE(formula.formula_changes);
  EXPECT_DOUBLE_EQ(formula.formula({0.0, 1.5}, 3.0), 4908.0);
}

TEST(Reader, ASoilInTwoPartsIsTwoMaterials)
{
  const Case c = read_case_text(wet_soil, "folder/all.toml").values;
  ASSERT_EQ(c.materials.size(), 2u);
  const MaterialCase &below = c.materials[0], &above = c.materials[1];
  EXPECT_EQ(below.name, "clay below");
  EXPECT_EQ(above.name, "clay above");
  for (const MaterialCase& part : c.materials) EXPECT_EQ(part.called(), "clay");
  EXPECT_EQ(below.zone, Zone::below);
  EXPECT_EQ(above.zone, Zone::above);
  EXPECT_EQ(below.model, "tresca_softening");
  EXPECT_EQ(below.density, 1800.0);
  EXPECT_EQ(below.parameters[2], 8.0e3);
  EXPECT_EQ(above.model, "linear_elastic");
  EXPECT_EQ(above.density, 1600.0);
  EXPECT_THAT(above.parameters, ElementsAre(1.0e6, 0.3));
  EXPECT_FALSE(below.stores_effective());
  EXPECT_TRUE(above.stores_effective());
}

TEST(Reader, FillsSides)
{
  const Case c = read_every_key();
  ASSERT_EQ(c.sides.size(), 4u);
  EXPECT_EQ(c.sides[0].side, "left");
  EXPECT_EQ(c.sides[0].kind, SideKind::roller);
  EXPECT_EQ(c.sides[1].kind, SideKind::velocity);
  EXPECT_EQ(c.sides[1].velocity, (Vec<2>{0.125, 0.5}));
  EXPECT_TRUE(c.sides[1].slip);
  EXPECT_EQ(c.sides[2].kind, SideKind::contact_separating);
  EXPECT_EQ((Numbers{c.sides[2].adhesion, c.sides[2].friction}), (Numbers{8.0e3, 0.5}));
  EXPECT_EQ(c.sides[3].kind, SideKind::fixed);
}

TEST(Reader, TakesAnOpenSide)
{
  const Case c = read_case_text(small_case + "[boundary]\nright = \"open\"\nleft = \"free\"\n", "case.toml").values;
  ASSERT_EQ(c.sides.size(), 2u);
  EXPECT_EQ(c.sides[0].kind, SideKind::open);
  EXPECT_EQ(c.sides[1].kind, SideKind::free);
}

TEST(Reader, FillsHoles)
{
  const std::string holes =
      "box = [[0.0, 0.0], [8.0, 2.0]]\nholes = [[[1, 1], [1, 2], [2, 1]], [[3, 0], [4, 0], [4, 1]]]";
  const Case c = read_case_text(replaced(small_case, "box = [[0.0, 0.0], [8.0, 2.0]]", holes), "case.toml").values;
  ASSERT_EQ(c.bodies[0].holes.size(), 2u);
  EXPECT_THAT(c.bodies[0].holes[0], ElementsAre(Vec<2>{2, 1}, Vec<2>{1, 2}, Vec<2>{1, 1}));
  EXPECT_THAT(c.bodies[0].holes[1], ElementsAre(Vec<2>{3, 0}, Vec<2>{4, 0}, Vec<2>{4, 1}));
  EXPECT_EQ(c.bodies[0].polygon.size(), 4u);
}

TEST(Reader, FillsTheMethod)
{
  EXPECT_EQ(read_every_key().method_form, MethodForm::paper);
  const MethodOptions m = read_every_key().method;
  EXPECT_EQ(m.shares, Shares::overlap);
  EXPECT_EQ(m.weights, Weights::summed);
  EXPECT_FALSE(m.b_bar);
  EXPECT_EQ(m.objective_rate, ObjectiveRate::jaumann);
  EXPECT_EQ(m.remap_contact, RemapContact::across);
  EXPECT_EQ(m.cut_cells, CutCells::slip);
  EXPECT_EQ(m.strain_shares, StrainShares::transposed);
  EXPECT_EQ(m.volume_change, VolumeChange::soil);
  EXPECT_EQ(m.pressure, Pressure::balanced);
  EXPECT_EQ((Numbers{m.filled_fraction, m.relaxation_time, m.flip, m.small_mass}), (Numbers{0.8, 0.05, 0.95, 1e-8}));
}

TEST(Reader, FillsTheOutput)
{
  const OutputCase o = read_every_key().output;
  EXPECT_EQ(
      (Numbers{o.fields_every, o.history_every, o.ledger_every, o.checkpoint_every}), (Numbers{0.5, 0.02, 0.03, 1.5}));
  EXPECT_THAT(o.field_names, ElementsAre("su", "stress"));
  EXPECT_THAT(o.history_points, ElementsAre(std::pair("B", Vec<2>{7.6, 1.9}), std::pair("A", Vec<2>{7.5, 0.5})));
  EXPECT_EQ(o.checkpoint_keep, 3);
  EXPECT_TRUE(o.mesh);
}

TEST(Reader, LeavesDefaultsWhereKeysAreMissing)
{
  const Case c = read_case_text(small_case, "case.toml").values;
  EXPECT_EQ(c.scheme, "mpm_gp");
  EXPECT_EQ(c.time.courant, 0.98);
  EXPECT_EQ(c.method.weights, Weights::hybrid);
  EXPECT_TRUE(c.sides.empty());
}

TEST(Reader, GivesAParameterTheValueOfAnotherWhereTheLawSaysSo)
{
  const auto read = [](const std::string& more) {
    const std::string sand =
        "model = \"mohr_coulomb\"\ndensity = 1800.0\nshear_modulus = 1e7\npoisson_ratio = 0.3\ncohesion = "
        "3e3\nfriction_angle = 33\n";
    return read_case_text(small_case.substr(0, small_case.find("model =")) + sand + more, "case.toml")
        .values.materials[0]
        .parameters;
  };
  const Real inf = std::numeric_limits<Real>::infinity();
  EXPECT_THAT(read(""), ElementsAre(1e7, 0.3, 3e3, 33.0, 0.0, inf, 3e3, 33.0, 0.0, 0.0));
  EXPECT_THAT(read("dilatancy_angle = 5\ncohesion_residual = 1e3\neta = 20\ntension_cutoff = inf\n"),
      ElementsAre(1e7, 0.3, 3e3, 33.0, 5.0, inf, 1e3, 33.0, 5.0, 20.0));
}

}  // namespace reader_test
