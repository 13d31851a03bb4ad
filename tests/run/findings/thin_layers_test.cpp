#include "run/findings/thin_layers.hpp"
#include "model/parts/setup.hpp"
#include "support/cases.hpp"

namespace thin_layers_test {

MaterialCase clay_of(const std::string& name, Real su)
{
  MaterialCase material = clay({.su_peak = su, .su_residual = su});
  material.name = name;
  return material;
}

/// 4 m by 2 m on cells of 0.25 m. A layer of clay of 2 kPa, `low` to `high` at x = 0, rises by `rise` to x = 4 m. The
/// soil around it has another strength.
Case layer(Real low, Real high, Real rise, Real around = 8e3)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {4.0, 2.0}, clay_of("firm", around));
  c.forces.gravity = {0.0, -9.81};
  c.materials.push_back(clay_of("weak", 2e3));
  c.bodies.push_back(body("weak", {0.0, low}, {4.0, high}));
  c.bodies[1].polygon = {{0.0, low}, {4.0, low + rise}, {4.0, high + rise}, {0.0, high}};
  return c;
}

std::vector<ThinLayer> layers_of(const Case& c)
{
  Model model = build_model(c, 1);
  return find_layers(model, build_state(model));
}

TEST(ThinLayers, AreMeasuredAcrossThemselves)
{
  const std::vector<ThinLayer> found = layers_of(layer(0.5, 1.0, 0.75));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].material, 1);
  EXPECT_FALSE(found[0].at_surface);
  const Real across = 4.0 / std::hypot(4.0, 0.75);  // cosine of the dip
  EXPECT_NEAR(found[0].thickness, 0.5 * across, 1e-9);
  EXPECT_NEAR(found[0].cell, 0.25, 1e-12);
  EXPECT_NEAR(found[0].cells(), 2.0 * across, 1e-9);
  EXPECT_NEAR(found[0].driving, 0.75 / std::hypot(4.0, 0.75), 1e-9);
}

TEST(ThinLayers, AtTheSurfaceHaveNothingAbove)
{
  const auto at_surface = [](Vec<2> gravity) {
    Case c = layer(1.0, 1.5, 0.0);
    c.bodies[0].polygon = {{0.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}, {0.0, 1.0}};
    c.forces.gravity = gravity;
    return layers_of(c);
  };
  ASSERT_EQ(at_surface({3.0, -4.0}).size(), 1u);
  EXPECT_TRUE(at_surface({3.0, -4.0})[0].at_surface);
  EXPECT_NEAR(at_surface({3.0, -4.0})[0].driving, 0.6, 1e-9);
  EXPECT_NEAR(at_surface({0.0, -9.81})[0].driving, 0.0, 1e-9);
}

TEST(ThinLayers, HaveSoilAroundThemThatIsHalfAsStrongAgain)
{
  EXPECT_EQ(layers_of(layer(0.5, 1.0, 0.0, 3.01e3)).size(), 1u);
  EXPECT_TRUE(layers_of(layer(0.5, 1.0, 0.0, 2.99e3)).empty());
  EXPECT_TRUE(layers_of(layer(0.5, 1.0, 0.0, 1e3)).empty());
  Case rock = layer(0.5, 1.0, 0.0);
  rock.materials[0] = elastic(2e6, 0.3, 2000.0);
  rock.materials[0].name = "firm";
  EXPECT_EQ(layers_of(rock).size(), 1u);
  std::swap(rock.bodies[0].material, rock.bodies[1].material);  // a stiff layer in clay
  EXPECT_TRUE(layers_of(rock).empty());
}

TEST(ThinLayers, OfSandAreComparedAtThePressureOfTheirDepth)
{
  Case c = layer(0.5, 1.0, 0.0, 5e3);  // above the layer some 20 kPa
  MaterialCase& sand = c.materials[1];
  sand = {
      "weak", "mohr_coulomb", 2000.0, find_material("mohr_coulomb")->complete(std::vector<Real>{2e6, 0.3, 0.0, 6.0})};
  EXPECT_EQ(layers_of(c).size(), 1u) << "20 kPa tan 6 = 2.1 kPa";
  sand.parameters = find_material("mohr_coulomb")->complete(std::vector<Real>{2e6, 0.3, 0.0, 30.0});
  EXPECT_TRUE(layers_of(c).empty());
}

TEST(ThinLayers, AreNoLenses)
{
  Case c = layer(0.5, 1.0, 0.0);
  c.bodies[1] = body("weak", {1.0, 0.5}, {3.0, 1.0});  // four times as long as thick
  EXPECT_TRUE(layers_of(c).empty());
}

}  // namespace thin_layers_test
