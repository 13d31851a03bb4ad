#include "io/case/printable.hpp"
#include "support/test.hpp"

namespace printable_test {

TEST(Printable, KeepsLettersOfAnyAlphabetTabsAndLineFeeds)
{
  const std::string text = "a\tb\n\xC3\xA4 \xE2\x82\xAC \xF0\x9F\x8C\x8D";  // a umlaut, euro sign, globe
  EXPECT_EQ(printable(text), text);
}

TEST(Printable, ShowsAQuestionMarkForEachControlCharacter)
{
  EXPECT_EQ(printable(std::string("\x1B[31mred\x7F\r\b", 11)), "?[31mred???");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
      "?31m");  // U+009B, which some terminals take for ESC [
}

TEST(Printable, ShowsAQuestionMarkForEachByteThatIsNotUtf8)
{
  EXPECT_EQ(printable("\x89HDF"), "?HDF");
  EXPECT_EQ(printable("\xC3("), "?(");          // cut short
  EXPECT_EQ(printable("\xE2\x82"), "??");       // cut short at the end
  EXPECT_EQ(printable("\xC0\x80"), "??");       // NUL in two bytes
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");  // half a surrogate pair
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");
}

}  // namespace printable_test
