#include "import/dstability/json_tree.hpp"

#include "math/errors.hpp"
#include "support/test.hpp"

namespace json_tree_test {

std::string refusal_of(const std::string& text)
{
  return refusal<InputError>([&] { read_json(text, "a.stix, soils.json"); });
}

TEST(JsonTree, HoldsWhatTheTextSays)
{
  const JsonNode tree = read_json("\xEF\xBB\xBF{\"A\":[1,-2.5,\"x\",null,true],\"B\":{\"C\":\"NaN\"}}", "a");
  ASSERT_NE(tree.find("A"), nullptr);
  const auto& list = tree.find("A")->members;
  ASSERT_THAT(list, SizeIs(5));
  EXPECT_EQ(list[1].second.number, -2.5);
  EXPECT_EQ(list[2].second.text, "x");
  EXPECT_EQ(list[3].second.kind, JsonKind::null);
  EXPECT_EQ(list[4].second.kind, JsonKind::boolean);
  EXPECT_EQ(tree.find("B")->find("C")->text, "NaN");
  EXPECT_EQ(tree.find("D"), nullptr);
}

TEST(JsonTree, ThrowsAwayWhatIsSkippedAndNothingBesides)
{
  const JsonNode tree =
      read_json("{\"All\":[{\"All\":[1,{\"B\":2}]},3],\"F\":4,\"L\":[{\"All\":5,\"G\":6}]}", "a", {"All"});
  EXPECT_EQ(tree.find("All"), nullptr);
  EXPECT_EQ(tree.find("F")->number, 4.0);
  const JsonNode& entry = tree.find("L")->members[0].second;
  EXPECT_EQ(entry.find("All"), nullptr);
  EXPECT_EQ(entry.find("G")->number, 6.0);
}

TEST(JsonTree, SaysWhereTheTextIsNoJson)
{
  EXPECT_THAT(refusal_of("{\"A\":1,\n\"B\":}"),
      AllOf(StartsWith("a.stix, soils.json: is no sound JSON\n  line 2, column 5"), HasSubstr("Save the file anew")));
  EXPECT_THAT(refusal_of(""), HasSubstr("is no sound JSON"));
  EXPECT_THAT(refusal_of("{} {}"), HasSubstr("is no sound JSON"));
  EXPECT_THAT(refusal_of("{\"A\":\"\xFF\"}"), HasSubstr("is no sound JSON"));
  EXPECT_THAT(refusal_of("{\"A\":1e999}"), HasSubstr("is no sound JSON"));
}

TEST(JsonTree, RefusesTwoMeaningsAndShapesThatTakeAllMemory)
{
  EXPECT_THAT(refusal_of("{\"A\":1,\"A\":2}"), HasSubstr("has the key `A` twice in one object"));
  EXPECT_THAT(
      refusal_of(std::string(100, '[') + std::string(100, ']')), HasSubstr("has too many levels\n  At most 64."));
  std::string wide = "{\"k\":0";
  for (int k = 0; k < 1200; ++k) wide += ",\"" + std::to_string(k) + "\":0";
  EXPECT_THAT(refusal_of(wide + "}"), HasSubstr("has an object with too many keys\n  At most 1000."));
}

}  // namespace json_tree_test
