#include "base/utf8.hpp"
#include "support/test.hpp"

namespace utf8_test {

TEST(Utf8, PutsASignForEachByteThatIsNone)
{
  EXPECT_EQ(as_utf8("d\xC3\xAFjk"), "d\xC3\xAFjk");
  EXPECT_EQ(as_utf8("d\xEFjk"), "d\xEF\xBF\xBDjk");  // Windows-1252
  EXPECT_EQ(as_utf8("\xEF\xBB\xBF{}"), "\xEF\xBB\xBF{}");
}

TEST(Utf8, MeasuresCharacters)
{
  EXPECT_EQ(utf8_length("a"), 1u);
  EXPECT_EQ(utf8_length("\xC3\xA9t"), 2u);
  EXPECT_EQ(utf8_length("\xE2\x82\xAC"), 3u);
  EXPECT_EQ(utf8_length("\xE9t"), 0u);
}

TEST(Utf8, WritesANumberAsACharacter)
{
  EXPECT_EQ(utf8_of(0x41), "A");
  EXPECT_EQ(utf8_of(0xEF), "\xC3\xAF");
  EXPECT_EQ(utf8_of(0x20AC), "\xE2\x82\xAC");
}

}  // namespace utf8_test
