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

}  // namespace shared_cells_test
