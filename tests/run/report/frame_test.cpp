#include "run/report/frame.hpp"
#include "run/report/frame_fields.hpp"
#include "support/simulations.hpp"
#include <tuple>

namespace frame_test {

const PointField& field(const Frame& frame, const std::string& name)
{
  for (const PointField& f : frame.fields)
    if (f.name == name) return f;
  throw std::runtime_error("no field " + name);
}

std::vector<std::string> names(const Frame& frame)
{
  std::vector<std::string> list;
  for (const PointField& f : frame.fields)
    list.push_back(f.name + " [" + f.unit + "] x" + std::to_string(f.n_components));
  return list;
}

TEST(Frame, HoldsTheFieldsOfEveryPointAndOfItsMaterial)
{
  const Simulation s(column("mpm_gp"));
  EXPECT_THAT(names(make_frame(s.model, s.state)),
      ElementsAre("velocity [m/s] x3", "volume [m^2] x1", "stress [Pa] x4", "eps_eq_p [-] x1", "displacement [m] x3",
          "material [-] x1", "cell [-] x1", "eps_deviatoric [-] x1", "su [Pa] x1"));
}

TEST(Frame, HoldsTheFieldsThatTheCaseChooses)
{
  Case c = column("mpm_gp");
  c.output.field_names = {"su", "velocity"};
  const Simulation s(c);
  EXPECT_THAT(names(make_frame(s.model, s.state)), ElementsAre("velocity [m/s] x3", "su [Pa] x1"));
}

TEST(Frame, EntryKIsThePointWithIdK)
{
  Case c = column("mpm_gp");
  c.output.field_names = {
      "velocity", "displacement", "stress", "volume", "strain", "eps_deviatoric", "eps_eq_p", "su", "material", "cell"};
  c.bodies[0].velocity = {3.0, 0.0};
  Simulation s(c);
  s.step(100);  // the blocks no longer lie in the order of ids
  const Frame frame = make_frame(s.model, s.state);
  EXPECT_EQ(frame.time, s.state.time);
  EXPECT_EQ(frame.step, 100);
  const auto points = points_by_id(s.state);
  ASSERT_EQ(frame.x.size(), 2 * points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point& p = points[k];
    for (int d = 0; d < 2; ++d) {
      EXPECT_EQ(frame.x[2 * k + d], p.x[d]);
      EXPECT_EQ(field(frame, "velocity").values[3 * k + d], p.v[d]);
      EXPECT_EQ(field(frame, "displacement").values[3 * k + d], p.x[d] - s.state.x_initial[2 * k + d]);
    }
    EXPECT_EQ(field(frame, "velocity").values[3 * k + 2], 0.0);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(field(frame, "stress").values[4 * k + i], p.sigma[i]);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(field(frame, "strain").values[4 * k + i], p.strain[i]);
    EXPECT_EQ(field(frame, "cell").values[k], p.cell);
    EXPECT_EQ(field(frame, "eps_eq_p").values[k], p.eps_eq_p());
    EXPECT_NEAR(field(frame, "su").values[k], 2000.0 + 6000.0 * std::exp(-50.0 * p.eps_eq_p()), 1e-8);
    EXPECT_EQ(field(frame, "eps_deviatoric").values[k], deviatoric_strain(p.strain));
  }
}

TEST(Frame, OfSomePointsIsAPartOfTheWhole)
{
  Case c = column("mpm_gp");
  c.bodies[0].velocity = {3.0, 0.0};
  Simulation s(c);
  s.step(100);
  s.state.left.push_back({.time = 0.2, .id = 700, .x = {9.5, 0.25}, .v = {1.0, 0.0}, .mass = 2.0});
  const Frame whole = make_frame(s.model, s.state), part = make_frame(s.model, s.state, 600, 250);
  EXPECT_EQ(part.first, 600);
  EXPECT_EQ(part.n_points(), 250);
  EXPECT_EQ(part.n_whole(), 1600);
  EXPECT_FALSE(part.ends());
  EXPECT_TRUE(make_frame(s.model, s.state, 1350, 250).ends());
  EXPECT_TRUE(std::equal(part.x.begin(), part.x.end(), whole.x.begin() + 1200));
  for (std::size_t f = 0; f < whole.fields.size(); ++f) {
    const auto begin = whole.fields[f].values.begin() + 600 * whole.fields[f].n_components;
    EXPECT_TRUE(std::equal(part.fields[f].values.begin(), part.fields[f].values.end(), begin)) << whole.fields[f].name;
  }
}

TEST(Frame, AFieldThatAMaterialDoesNotHaveIsNotANumber)
{
  Case c = free_box("mpm_gp", {1.0, 0.5}, {1.5, 1.0});
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies.push_back(body("rock", {1.25, 0.5}, {1.5, 1.0}));
  const Simulation s(c);
  const Frame frame = make_frame(s.model, s.state);
  for (const Point& p : points_by_id(s.state)) {
    EXPECT_EQ(field(frame, "material").values[p.id], p.material);
    EXPECT_EQ(std::isnan(field(frame, "eps_eq_p").values[p.id]), p.material == 1);
    EXPECT_EQ(std::isnan(field(frame, "su").values[p.id]), p.material == 1);
  }
}

TEST(FrameFields, OfARunAreAmongThoseThatACaseMayName)
{
  Case c = column("mpm_gp");
  c.materials[0].fields = {{.parameter = 2, .value_at = [](Vec<2> x) { return 8e3 + x[0]; }}};
  const Simulation s(c);
  const std::vector<FrameField> known = all_frame_fields();
  for (const FrameField& there : frame_fields(s.model, s.state)) {
    const auto same = std::ranges::find(known, there.name, &FrameField::name);
    ASSERT_NE(same, known.end()) << there.name;
    EXPECT_EQ(std::tie(same->unit, same->label, same->meaning, same->n_components, same->by_default),
        std::tie(there.unit, there.label, there.meaning, there.n_components, there.by_default));
    EXPECT_FALSE(there.label.empty() || there.meaning.empty()) << there.name;
    EXPECT_TRUE(there.read && !same->read);
  }
  const auto peak = std::ranges::find(known, "parameter_su_peak", &FrameField::name);
  EXPECT_EQ(peak->label, "peak undrained shear strength S_u");
}

TEST(DeviatoricStrain, IsTheNormOfTheDeviatorByHand)
{
  // Simple shear of 2 %: e_xy = 0.01, sqrt(1/2 * 2 * 0.01^2) = 0.01.
  EXPECT_NEAR(deviatoric_strain({0.0, 0.0, 0.0, 0.01}), 0.01, 1e-16);
  // Pure volume change has none.
  EXPECT_NEAR(deviatoric_strain({0.03, 0.03, 0.03, 0.0}), 0.0, 1e-16);
  // (0.02, -0.01, -0.01): 1/2 (4 + 1 + 1) 1e-4.
  EXPECT_NEAR(deviatoric_strain({0.02, -0.01, -0.01, 0.0}), std::sqrt(3e-4), 1e-16);
}

}  // namespace frame_test
