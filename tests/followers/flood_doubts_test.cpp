#include "warnings/flood_warnings.hpp"

#include "followers/flood_dike.hpp"

namespace flood_doubts_test {

std::vector<std::string> doubts_of(const Case& c)
{
  const Drawn s(c);
  std::vector<std::string> texts;
  for (const Problem& p : find_flood_warnings(s.model, s.state))
    texts.push_back(p.key + ": " + p.what + ". " + p.detail);
  return texts;
}

TEST(Flood, ACrestThatIsNarrowerThanTwoCellsIsDoubted)
{
  Case c = dike();
  c.flood.water_level = 3.0;
  EXPECT_THAT(doubts_of(c), IsEmpty());
  c.bodies.push_back(body("clay", {19.75, 5.0}, {20.25, 5.5}));
  EXPECT_THAT(doubts_of(c), ElementsAre(AllOf(StartsWith("mesh.cell: the crest is narrower than two cells. At x = 20 m "
                                                         "the ground reaches 5.5 m;"),
                                HasSubstr("0.5 m wide, on cells of 0.5 m.\nIt counts as 5.25 m high"))));
  c.bodies.back() = body("clay", {19.0, 5.0}, {21.0, 5.5});
  EXPECT_THAT(doubts_of(c), IsEmpty());
}

}  // namespace flood_doubts_test
