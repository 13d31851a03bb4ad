#include "run/findings/shared_cells.hpp"
#include "model/parts/setup.hpp"
#include "run/findings/setup_warnings.hpp"
#include "support/cases.hpp"
#include "support/problems.hpp"

namespace shared_cells_test {

/// 2 m by 1 m on cells of 0.25 m: soft clay between two levels, in stiff soil.
Case layer_between(Real low, Real high)
{
  Case c = free_box("mpm_gp", {0.0, 0.0}, {2.0, 1.0});
  c.forces.gravity = {0.0, -9.81};
  c.materials.push_back(elastic(2e6, 0.3, 2500.0));
  c.bodies[0].material = "rock";
  c.bodies.push_back(body("clay", {0.0, low}, {2.0, high}));
  return c;
}

TEST(SharedCells, AreThoseWithPointsOfTwoMaterials)
{
  const auto share = [](Real low, Real high) {
    Model model = build_model(layer_between(low, high), 1);
    return shares_in_shared_cells(model, build_state(model))[0];
  };
  EXPECT_EQ(share(0.25, 0.75), 0.0);             // along the cells
  EXPECT_NEAR(share(0.375, 0.875), 0.5, 1e-12);  // one whole row, and half of two
  EXPECT_EQ(share(0.375, 0.625), 1.0);
}

TEST(SharedCells, AThinLayerOfSoilThatYieldsIsTold)
{
  const auto warnings_of = [](const Case& c) {
    Model model = build_model(c, 1);
    return find_warnings(model, build_state(model));
  };
  EXPECT_THAT(warnings_of(layer_between(0.25, 0.875)), ElementsAre());  // a fifth
  Case thin = layer_between(0.375, 0.625);
  const auto in_stronger_soil =
      told("material.\"clay\"", "`clay` is a layer in stronger soil, 0.25 m thick on cells of 0.25 m");
  EXPECT_THAT(warnings_of(thin), ElementsAre(in_stronger_soil));  // its soils do not have one strain
  const auto is_told = [](const std::string& remedy) {
    return ElementsAre(told("material.\"clay\"", "most of `clay` lies in cells that it shares with other soil",
        AllOf(StartsWith("Got 100 % of its volume. Such a cell has the mean strength of its soils:"),
            HasSubstr("Usual: " + remedy + ", cells along the layer, or smaller ones"))));
  };
  thin.scheme = "standard_mpm";
  EXPECT_THAT(warnings_of(thin), is_told("another scheme"));
  thin.scheme = "mpm_gp";
  thin.method.cut_cells = CutCells::mean;
  EXPECT_THAT(warnings_of(thin), is_told("method.cut_cells = \"slip\""));
  thin.materials[0] = elastic(2e6, 0.3, 2500.0);
  thin.materials[0].name = "clay";
  EXPECT_THAT(warnings_of(thin), ElementsAre());  // never yields
}

}  // namespace shared_cells_test
