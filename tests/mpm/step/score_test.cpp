// How a score is chosen; what stands in it is in tests/golden/score.txt.
#include "mpm/step/score_places.hpp"
#include "mpm/features/rest.hpp"
#include "mpm/features/search.hpp"
#include "mpm/step/kernels.hpp"
#include "support/simulations.hpp"

namespace score_test {

std::vector<std::string> names(const Simulation& s, Workspace& work)
{
  const Score& score = kernels().score(s.model, work);
  std::vector<std::string> names;
  for (int k = 0; k < score.n_kernels; ++k) names.emplace_back(score.kernels[k]->name);
  return names;
}

class EveryScore : public TestWithParam<const Scheme*> {};
INSTANTIATE_TEST_SUITE_P(Schemes, EveryScore, ValuesIn(all_schemes().begin(), all_schemes().end()),
    [](const auto& scheme) { return std::string(scheme.param->name); });

TEST_P(EveryScore, HasItsPlacesInOrderAndEachKernelInOneWalk)
{
  for (const Shares shares : {Shares::point, Shares::overlap}) {
    Case c = column(std::string(GetParam()->name).c_str(), 0.25);
    c.method.shares = shares;
    Simulation s(c);
    const Score& score = kernels().score(s.model, s.work);
    int end = 0;
    for (const ScoreWalk& walk : std::span(score.walks).first(score.n_walks))
      for (const ScoreSegment& segment : score.of(walk)) {
        EXPECT_EQ(segment.first, end);
        end = segment.end;
        for (const Kernel* kernel : score.of(segment)) {
          EXPECT_EQ(score_places[static_cast<std::size_t>(kernel->place)].over, segment.over) << kernel->name;
          EXPECT_NE(kernel->homes & score.home, 0u) << kernel->name;
        }
      }
    EXPECT_EQ(end, score.n_kernels - score.n_strips);
    for (int k = 1; k < end; ++k) EXPECT_LE(score.kernels[k - 1]->place, score.kernels[k]->place);
  }
}

TEST(Score, FollowsWhatARunHasNow)
{
  Simulation s(column("mpm_gp", 0.25));
  const auto before = names(s, s.work);
  EXPECT_THAT(before, Not(Contains("search")));
  begin_search(0.0, s.work);
  watch_speed(true, s.work);
  EXPECT_THAT(names(s, s.work), AllOf(Contains("search").Times(4), Contains("rest").Times(2)));
  s.work.with.search.clear();
  watch_speed(false, s.work);
  EXPECT_EQ(names(s, s.work), before);
}

}  // namespace score_test
