#include "input/document.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace terp {
namespace {

const std::string text = R"(title = "a \"b\" \\ ä"
n = 3
x = 0.1
whole = 8.0e3
big = 1e300
low = -inf
yes = true
pair = [1, [2.5, "c"]]
empty = []
[part]
z = 1
a = { b.c = 2, "d e" = 3 }
[[body]]
name = "one"
[[body]]
name = "two"
[body.below]
k = 1
)";

TEST(Document, KnowsWhereKeysAndValuesStand)
{
  const Node root = parse_toml(text);
  const Node* z = find_node(root, "part.z");
  ASSERT_NE(z, nullptr);
  EXPECT_EQ(z->key.line, 11);
  EXPECT_EQ(z->key.column, 1);
  EXPECT_EQ(z->value.column, 5);
  EXPECT_EQ(z->value.length, 1);
}

TEST(Document, KeepsTheOrderOfTheFile)
{
  const Node root = parse_toml(text);
  EXPECT_EQ(root.items[0].name, "title");
  EXPECT_EQ(root.items[1].name, "n");
  EXPECT_EQ(find_node(root, "part")->items[1].name, "a");
}

TEST(Document, FindsEntriesOfListsAndQuotedKeys)
{
  const Node root = parse_toml(text);
  EXPECT_EQ(find_node(root, "body[1].name")->text, "two");
  EXPECT_EQ(find_node(root, "pair[1][0]")->number, 2.5);
  EXPECT_EQ(find_node(root, "part.a.\"d e\"")->integer, 3);
  EXPECT_EQ(find_node(root, "body[2].name"), nullptr);
  EXPECT_EQ(find_node(root, "body.name"), nullptr);
  EXPECT_EQ(find_node(root, "part.z.deeper"), nullptr);
}

TEST(Document, SplitsAndJoinsPaths)
{
  EXPECT_THAT(split_path("body[0].box"), testing::ElementsAre("body", "[0]", "box"));
  EXPECT_THAT(split_path("material.'a.b'.eta"), testing::ElementsAre("material", "a.b", "eta"));
  EXPECT_EQ(join_path("material", "clay"), "material.clay");
  EXPECT_EQ(join_path("material", "a.b"), "material.\"a.b\"");
}

TEST(Document, WritesWhatItRead)
{
  const Node root = parse_toml(text);
  const std::string written = write_toml(root);
  EXPECT_EQ(write_toml(parse_toml(written)), written);
  const Node again = parse_toml(written);
  EXPECT_EQ(find_node(again, "title")->text, "a \"b\" \\ ä");
  EXPECT_EQ(find_node(again, "x")->number, 0.1);
  EXPECT_EQ(find_node(again, "whole")->kind, NodeKind::number);
  EXPECT_EQ(find_node(again, "big")->number, 1e300);
  EXPECT_TRUE(std::isinf(find_node(again, "low")->number));
  EXPECT_EQ(find_node(again, "n")->kind, NodeKind::integer);
  EXPECT_EQ(find_node(again, "part.a.b.c")->integer, 2);
  EXPECT_EQ(find_node(again, "body[1].below.k")->integer, 1);
}

TEST(Document, SaysWhereTheTextIsNotToml)
{
  try {
    parse_toml("a = 1\nb = [1,\n");
    FAIL();
  } catch (const SyntaxError& error) {
    EXPECT_GE(error.place.line, 2);
    EXPECT_THAT(error.what(), testing::HasSubstr("array"));
  }
}

TEST(Document, TakesForeignLettersInStringsAndCommentsOnly)
{
  const char* const good[] = {"a = \"ä \\\" ö\" # ü\nb = 'ä\\' # 'ß", "a = \"\"\"ä\n\"ö\"\n\"\"\" # é",
      "a = '''ä\nö'''\n'ü' = 1",
      "\xEF\xBB\xBF"
      "a = 1",
      "a = \"\" # ä", "#ä\n#\nb = 1"};
  for (const char* good_text : good) EXPECT_NO_THROW(parse_toml(good_text)) << good_text;
  const char* const bad[] = {"a = ä", "ä = 1", "a = 1 # x\nb = 2\u00a0", "a = \"\"ö", "[ü]", "#\nä"};
  for (const char* bad_text : bad) EXPECT_THROW(parse_toml(bad_text), SyntaxError) << bad_text;
}

TEST(Document, SaysWhereAForeignLetterStands)
{
  try {
    parse_toml("a = \"ä\"\nb = \"ä\"\u00a0\n");
    FAIL();
  } catch (const SyntaxError& error) {
    EXPECT_EQ(error.place.line, 2);
    EXPECT_EQ(error.place.column, 8);
    EXPECT_THAT(error.what(), testing::StartsWith("Letters beyond a to z"));
  }
}

/// "a.a.a", of so many parts.
std::string key_of(int n_parts)
{
  std::string key = "a";
  for (int k = 1; k < n_parts; ++k) key += k % 2 == 0 ? ".a" : ".'a'";
  return key;
}

TEST(Document, RefusesKeysOfVeryManyPartsAtTheirPlace)
{
  for (const int n_parts : {101, 20000}) {
    for (const std::string& bad : {key_of(n_parts) + " = 1", '[' + key_of(n_parts) + ']', "[[" + key_of(n_parts) + "]]",
             "b = { " + key_of(n_parts) + " = 1 }"}) {
      try {
        parse_toml("# a.b\n" + bad + '\n');
        ADD_FAILURE() << bad.substr(0, 20);
      } catch (const SyntaxError& error) {
        EXPECT_EQ(error.place.line, 2);
        EXPECT_STREQ(error.what(), "A key has at most 100 parts.");
      }
    }
  }
  EXPECT_NO_THROW(parse_toml('[' + key_of(100) + "]\nb." + key_of(99) + " = 1.5\n"));
  std::string dots;
  for (int k = 0; k < 200; ++k) dots += "1.5, ";
  EXPECT_NO_THROW(
      parse_toml("a = [" + dots + "]\nb = \"" + std::string(200, '.') + "\"  # " + std::string(200, '.') + '\n'));
}

TEST(Document, TheDeepestThatItTakesIsWalkedWithoutTrouble)
{
  std::string open = "[" + key_of(100) + "]\nb = ", close;
  for (int k = 0; k < 30; ++k) open += "{ " + key_of(100) + " = ", close += " }";
  EXPECT_NO_THROW(write_toml(parse_toml(open + '1' + close)));
  std::string lists = "1";
  for (int k = 0; k < 20000; ++k) lists = '[' + lists;
  EXPECT_THROW(parse_toml("b = " + lists), SyntaxError);
}

TEST(Document, ReportsAHeaderThatStartsWithASign) { EXPECT_THROW(parse_toml("[=a]\n"), SyntaxError); }

}  // namespace
}  // namespace terp
