#include "math/utf8.hpp"
#include "support/test.hpp"

namespace utf8_test {

TEST(Utf8, PutsASignForEachByteThatIsNone)
{
  EXPECT_EQ(as_utf8("d\xC3\xAFjk"), "d\xC3\xAFjk");
  EXPECT_EQ(as_utf8("d\xEFjk"), "d\xEF\xBF\xBDjk");  // Windows-1252
  EXPECT_EQ(as_utf8("\xEF\xBB\xBF{}"), "\xEF\xBB\xBF{}");
}

TEST(Utf8, TakesLettersOff)
{
  for (const auto& [text, code] :
      {std::pair{"a", 0x61u}, {"\u00e9t", 0xE9u}, {"\u20ac", 0x20ACu}, {"\U0001F600", 0x1F600u},
          {"\xE9t", Letter::none}, {"\xED\xA0\x80", Letter::none}, {"\xC0\x80", Letter::none}}) {
    std::string_view rest = text;
    const Letter letter = take_letter(rest);
    EXPECT_EQ(letter.code, code) << text;
    EXPECT_EQ(std::string(letter.bytes) + std::string(rest), text);
  }
  EXPECT_EQ(count_letters("d\u00efjk\u20ac"), 5u);
}

TEST(Utf8, WritesANumberAsACharacter)
{
  EXPECT_EQ(utf8_of(0x41), "A");
  EXPECT_EQ(utf8_of(0xEF), "\xC3\xAF");
  EXPECT_EQ(utf8_of(0x20AC), "\xE2\x82\xAC");
  EXPECT_EQ(utf8_of(0x1F600), "\U0001F600");
}

}  // namespace utf8_test
