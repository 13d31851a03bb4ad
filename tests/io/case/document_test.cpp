#include "io/case/document.hpp"
#include "support/test.hpp"

namespace document_test {

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
  EXPECT_THAT(split_path("body[0].box"), ElementsAre("body", "[0]", "box"));
  EXPECT_THAT(split_path("material.'a.b'.eta"), ElementsAre("material", "a.b", "eta"));
  EXPECT_EQ(join_path("material", "clay"), "material.clay");
  EXPECT_EQ(join_path("material", "a.b"), "material.\"a.b\"");
}

TEST(Document, WritesWhatItRead)
{
  const std::string written = write_toml(parse_toml(text));
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

struct Refused {
  int line, column;
  std::string words;
};

Refused refused(const std::string& text)
{
  try {
    parse_toml(text);
  } catch (const SyntaxError& error) {
    return {error.place.line, error.place.column, error.what()};
  }
  return {};
}

TEST(Document, SaysWhereTheTextIsNotToml)
{
  EXPECT_GE(refused("a = 1\nb = [1,\n").line, 2);
  EXPECT_THAT(refused("a = 1\nb = [1,\n").words, HasSubstr("array"));
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
  const auto [line, column, words] = refused("a = \"ä\"\nb = \"ä\"\u00a0\n");
  EXPECT_EQ(line, 2);
  EXPECT_EQ(column, 8);
  EXPECT_THAT(words, StartsWith("Letters beyond a to z"));
}

TEST(Document, GivesBackTheLettersThatTomlMustNotSee)
{
  const Node root = parse_toml("\uFEFF\"gr\u00f6\u00dfe\" = \"\u00e9\u4e2d\"\n# \u00e9\n");
  ASSERT_EQ(root.items.size(), 1u);
  EXPECT_EQ(root.items[0].name, "gr\u00f6\u00dfe");
  EXPECT_EQ(root.items[0].text, "\u00e9\u4e2d");
  EXPECT_EQ(root.items[0].value.column, 11);
  for (const std::string text :
      {"\u00a0", "\u2003\uffff", "x\uFEFF", "\u07ff\u0800\ud7ff\ue000", "\U0001F600\U00020000"})
    EXPECT_EQ(parse_toml("a = \"" + text + '"').items[0].text, text);
}

TEST(Document, RefusesBytesThatAreNoUtf8AndLettersOfPrivateUse)
{
  for (const std::string text :
      {"\x80", "\xff\xfe", "\xc3", "\xc3(", "\xe2\x82", "\xf0\x9f\x98", "a\xe2(\xa1", "\U000F00E9"})
    EXPECT_THROW(parse_toml("a = \"" + text + '"'), SyntaxError) << text;
  EXPECT_EQ(refused("a = \"\u00e9\U000F00E9\"").column, 7);
  EXPECT_THROW(parse_toml("x = 1977-29-50T01:32:00Z\"\"\"\"m\u023d8\uFEFF8"), SyntaxError);
  EXPECT_THROW(parse_toml("x = 1977-29-50 =\"\u00e9"), SyntaxError);
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
      const Refused here = refused("# a.b\n" + bad + '\n');
      EXPECT_EQ(here.line, 2) << bad.substr(0, 20);
      EXPECT_EQ(here.words, "A key has at most 100 parts.");
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

}  // namespace document_test
