#include "input/lifted_text.hpp"
#include "input/document.hpp"
#include "support/test.hpp"

namespace lifted_text_test {

TEST(LiftedText, MovesLettersToPlane15AndBack)
{
  EXPECT_EQ(lift("a\u00e9b"), "a\U000F00E9b");
  EXPECT_EQ(lift("\u2003\uffff"), "\U000F2003\U000FFFFF");
  for (const std::string text : {"", "plain", "\u00a0", "Deich \u00fc\u4e2d \U0001F600", "\u07ff\u0800\ud7ff\ue000"}) {
    EXPECT_EQ(lower(lift(text)), text);
    EXPECT_EQ(find_lifted(text), std::string::npos) << text;
  }
}

TEST(LiftedText, LeavesAsciiLettersBeyondU_FFFFAndAMarkAtTheStart)
{
  for (const std::string text : {"x = 1\n", "\U0001F600\U00020000", "\uFEFFx = 1"}) EXPECT_EQ(lift(text), text);
  EXPECT_EQ(lift("x\uFEFF"), "x\U000FFEFF");
}

TEST(LiftedText, LeavesBytesThatAreNoUtf8)
{
  for (const std::string text : {"\x80", "\xff\xfe", "\xc3", "\xc3(", "\xe2\x82", "\xf0\x9f\x98", "a\xe2(\xa1"}) {
    EXPECT_EQ(lift(text), text);
    EXPECT_EQ(lower(text), text);
  }
}

TEST(LiftedText, FindsWhatItWouldMoveBackWithoutHavingMovedIt) { EXPECT_EQ(find_lifted("ab\U000F00E9"), 2u); }

TEST(LiftedText, TextsAndKeysOfADocumentComeBack)
{
  const Node root = parse_toml("\"gr\u00f6\u00dfe\" = \"\u00e9\u4e2d\"\n# \u00e9\n");
  ASSERT_EQ(root.items.size(), 1u);
  EXPECT_EQ(root.items[0].name, "gr\u00f6\u00dfe");
  EXPECT_EQ(root.items[0].text, "\u00e9\u4e2d");
  EXPECT_EQ(root.items[0].value.column, 11);
}

TEST(LiftedText, ALetterInABrokenDateIsRefused)
{
  EXPECT_THROW(parse_toml("x = 1977-29-50T01:32:00Z\"\"\"\"m\u023d8\uFEFF8"), SyntaxError);
  EXPECT_THROW(parse_toml("x = 1977-29-50 =\"\u00e9"), SyntaxError);
  EXPECT_THROW(parse_toml("x = \"\U000F00E9\""), SyntaxError);
}

}  // namespace lifted_text_test
