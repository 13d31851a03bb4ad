// What each pass must do at least: which passes count, and that schemes differ where their kernels do.
#include "simulation/pass_costs.hpp"

#include <gmock/gmock.h>

namespace terp {
namespace {

TEST(PassCosts, OnlyPassesOverPointsCount)
{
  for (const char* scheme : {"mpm_gp", "mpm_mixed", "standard_mpm"}) {
    const auto costs = pass_costs(scheme);
    for (const Pass pass : {points_to_cells, cells_to_points, stress}) {
      EXPECT_GT(costs[pass].flops, 0.0) << scheme << ", " << pass_names[pass];
      EXPECT_GT(costs[pass].bytes, 0.0) << scheme << ", " << pass_names[pass];
    }
    for (const Pass pass : {nodes, velocities, move}) {
      EXPECT_EQ(costs[pass].flops, 0.0) << scheme << ", " << pass_names[pass];
      EXPECT_EQ(costs[pass].bytes, 0.0) << scheme << ", " << pass_names[pass];
    }
  }
}

TEST(PassCosts, MixedWritesStressAndStateButDoesNotReadThemAtPoints)
{
  EXPECT_LT(pass_costs("mpm_mixed")[stress].bytes, pass_costs("mpm_gp")[stress].bytes);
  EXPECT_GT(pass_costs("mpm_mixed")[points_to_cells].bytes, pass_costs("mpm_gp")[points_to_cells].bytes);
}

TEST(PassCosts, GradientsAtPointsCostStandardMpmMoreWork)
{
  EXPECT_GT(pass_costs("standard_mpm")[points_to_cells].flops, pass_costs("mpm_gp")[points_to_cells].flops);
  EXPECT_GT(pass_costs("standard_mpm")[stress].flops, pass_costs("mpm_gp")[stress].flops);
}

TEST(PassCosts, RowsAreOfDoubles)
{
  EXPECT_EQ(pass_costs("mpm_gp")[cells_to_points].bytes, 7 * 8.0);  // xi, m, v read, v written
}

}  // namespace
}  // namespace terp
