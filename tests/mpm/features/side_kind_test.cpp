#include "mpm/features/side_kind.hpp"
#include "support/test.hpp"

namespace side_kind_test {

TEST(SideKinds, StandInTheOrderOfTheirWordsAndAreWhole)
{
  std::set<std::pair<std::string_view, std::string_view>> names;
  int place = 0;
  for (const SideKindInfo& info : side_kinds()) {
    EXPECT_EQ(static_cast<int>(info.kind), place++);
    EXPECT_EQ(&info_of(info.kind), &info);
    EXPECT_TRUE(names.emplace(info.key, info.word).second) << info.key << info.word << " twice";
    EXPECT_FALSE(info.key.empty() && info.word.empty()) << info.label << ": no case file can name it";
    EXPECT_FALSE(info.label.empty() || info.legend.empty() || info.colour.empty()) << info.label;
    EXPECT_EQ(info.word.empty(), info.meaning.empty()) << info.label;
  }
  EXPECT_EQ(place, static_cast<int>(SideKind::velocity) + 1);
}

TEST(SideKinds, ActInOneOfTheWaysThatANodeKnows)
{
  for (const SideKindInfo& info : side_kinds()) {
    const SideAction& action = info.action;
    EXPECT_EQ(action.along == Along::resisted, action.strength != nullptr) << info.label;
    EXPECT_TRUE(action.along != Along::prescribed || action.across == Across::prescribed) << info.label;
    EXPECT_TRUE(action.along == Along::free || action.across != Across::free) << info.label;
    EXPECT_TRUE(!info.soil_leaves || action == SideAction{}) << info.label;
    EXPECT_EQ(info.marks == SideMarks::none, action == SideAction{}) << info.label;
  }
}

TEST(SideKinds, AreFoundByTheKeyThatNamesThem)
{
  EXPECT_EQ(keys_of_kinds(), (std::vector<std::string_view>{"contact", "velocity"}));
  std::vector<std::string_view> words;
  for (const SideKindInfo* info : kinds_named_by("contact")) words.push_back(info->word);
  EXPECT_EQ(words, (std::vector<std::string_view>{"bilateral", "separating"}));
  EXPECT_TRUE(kinds_named_by("spring").empty());
}

std::string described(SideKind kind, Real adhesion = 0.0, Real friction = 0.0)
{
  SideCondition side;
  side.kind = kind, side.adhesion = adhesion, side.friction = friction;
  return describe(side);
}

TEST(SideKinds, AConditionIsDescribedByWhatItDoes)
{
  EXPECT_EQ(described(SideKind::free), "free");
  EXPECT_EQ(described(SideKind::roller), "roller, no motion across");
  EXPECT_EQ(described(SideKind::open), "open, soil leaves there");
  EXPECT_EQ(described(SideKind::fixed), "fixed");
  EXPECT_EQ(described(SideKind::contact_bilateral, 8e3), "contact that never opens, adhesion 8 kPa");
  EXPECT_EQ(described(SideKind::contact_separating), "contact that may open, smooth");
  EXPECT_EQ(described(SideKind::contact_separating, 0.0, 0.4), "contact that may open, friction 0.4");
}

TEST(SideKinds, ADrivenSideHasAVelocityOrAFormulaOfOne)
{
  SideCondition side;
  side.kind = SideKind::velocity;
  EXPECT_FALSE(is_driven(side));
  side.velocity = {0.0, -0.01}, side.slip = true;
  EXPECT_TRUE(is_driven(side));
  EXPECT_EQ(describe(side), "velocity [0, -0.01] m/s, smooth");
  side.velocity = {0.0, 0.0}, side.slip = false, side.velocity_at = [](Vec<2> x) { return x; };
  EXPECT_TRUE(is_driven(side));
  EXPECT_EQ(describe(side), "velocity by a formula");
}

}  // namespace side_kind_test
