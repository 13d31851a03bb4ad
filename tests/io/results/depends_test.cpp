#include "io/results/depends.hpp"
#include "io/results/runs.hpp"
#include <nlohmann/json.hpp>

namespace depends_test {

using nlohmann::json;

std::string outcome(const std::string& folder, const std::function<void(Summary&)>& change)
{
  const ScratchFolder scratch;
  return outcome_of_run(write_run(scratch.path() + "/" + folder, change));
}

TEST(Depends, WithoutAFloodSoilThatMovedAtTheEndDoesNotRest)
{
  const auto stages = [](bool at_rest, Real fastest) {
    return outcome("run", [&](Summary& s) {
      s.flood.reset(), s.slides.clear();
      s.stages = {{"a", {.start = 0.0, .end = 1.0, .at_rest = at_rest, .fastest = fastest}}};
    });
  };
  EXPECT_EQ(stages(true, 1e-5), "rests");
  EXPECT_EQ(stages(false, 0.5), "still moves");
  EXPECT_EQ(stages(false, std::nan("")), "no slide") << "nothing waited for rest";
}

TEST(Depends, OneSizeOfCellsIsNoChange)
{
  const auto decided = [](const std::vector<SolvedInput>& runs) { return json::parse(decide("dike", runs).json); };
  const json one = decided({{"cells", "cells of 1 m", "stands", "a"}, {"S", "S x 0.85", "stands", "b"}});
  EXPECT_EQ(one.at("does_not_turn_on"), json({"S"}));
  const json two = decided({{"cells", "cells of 1 m", "stands", "a"}, {"cells", "cells of 0.5 m", "stands", "b"}});
  EXPECT_EQ(two.at("does_not_turn_on"), json({"cells"}));
}

TEST(Depends, NamesWhatWasNotVaried)
{
  const Decision decision = decide("dike", {{"cells", "cells of 1 m", "stands", "a"}}, {"S_u (a table in a file)"});
  EXPECT_EQ(json::parse(decision.json).at("not_varied"), json({"S_u (a table in a file)"}));
  EXPECT_THAT(decision.text, HasSubstr("turns on: nothing that was changed\nnot varied: S_u (a table in a file)\n"));
}

}  // namespace depends_test
