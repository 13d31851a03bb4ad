#include "mpm/step/passes.hpp"
#include "support/test.hpp"

namespace passes_test {

std::array<PassCost, n_passes> costs_of(std::string_view scheme) { return pass_costs(*find_scheme(scheme)); }

TEST(Passes, HaveNamesOfTheirOwn)
{
  const std::set<std::string> names(pass_names.begin(), pass_names.end());
  EXPECT_EQ(names.size(), std::size_t{n_passes});
  EXPECT_EQ(pass_names[points_to_cells], std::string("points to cells"));
}

TEST(PassCosts, OnlyPassesOverPointsCount)
{
  for (const Scheme* scheme : all_schemes()) {
    const auto costs = pass_costs(*scheme);
    for (const Pass pass : {points_to_cells, cells_to_points, stress}) {
      EXPECT_GT(costs[pass].flops, 0.0) << scheme->name << ", " << pass_names[pass];
      EXPECT_GT(costs[pass].rows, 0.0) << scheme->name << ", " << pass_names[pass];
    }
    for (const Pass pass : {nodes, velocities, move}) {
      EXPECT_EQ(costs[pass].flops, 0.0) << scheme->name << ", " << pass_names[pass];
      EXPECT_EQ(costs[pass].rows, 0.0) << scheme->name << ", " << pass_names[pass];
    }
  }
}

TEST(PassCosts, MixedWritesStressAndStateButDoesNotReadThemAtPoints)
{
  EXPECT_LT(costs_of("mpm_mixed")[stress].rows, costs_of("mpm_gp")[stress].rows);
  EXPECT_GT(costs_of("mpm_mixed")[points_to_cells].rows, costs_of("mpm_gp")[points_to_cells].rows);
}

TEST(PassCosts, GradientsAtPointsCostStandardMpmMoreWork)
{
  EXPECT_GT(costs_of("standard_mpm")[points_to_cells].flops, costs_of("mpm_gp")[points_to_cells].flops);
  EXPECT_GT(costs_of("standard_mpm")[stress].flops, costs_of("mpm_gp")[stress].flops);
}

TEST(PassCosts, CountEachRowOnceForReadingAndOnceForWriting)
{
  EXPECT_EQ(costs_of("mpm_gp")[cells_to_points].rows, 7.0);  // xi, m, v read, v written
}

}  // namespace passes_test
