// Each row of tests/mpm/features.toml: the same bits, no allocation, energy that is explained.
#include "io/case/case_file.hpp"
#include "io/case/document.hpp"
#include "mpm/step/count_allocations.hpp"
#include "run/loop/guards.hpp"
#include "support/process.hpp"
#include "support/simulations.hpp"

namespace features_test {

Case case_of(const Node& row)
{
  std::vector<std::string> changes{"mesh.cell=0.25", "body[0].velocity=[2,0]", "body[0].points_per_cell=3"};
  for (const Node& change : find_node(row, "set")->items) changes.push_back(change.text);
  return read_case(source_path("tests/support/column.toml"), changes).values;
}

TEST(Features, GiveTheSameBitsWithoutAllocationsAndExplainTheirEnergy)
{
  const Node table = parse_toml(text_of(source_path("tests/mpm/features.toml")));
  for (const Node& row : find_node(table, "row")->items) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, find_node(row, "name")->text);
    const Case c = case_of(row);
    Simulation s(c);
    expect_same_bits(c, {2, 4}, {60.0 * s.model.dt}, 120);
    make_steps(s, 2);
    EXPECT_EQ(allocations_during(s, 100) > 0, find_node(row, "allocates") != nullptr);
    EXPECT_LT(unexplained_share(s.state), 0.05);
  }
}

}  // namespace features_test
