// Letters of code pages, each by one that the pages have apart.
#include "drawing/code_pages.hpp"
#include "support/test.hpp"

namespace code_pages_test {

char16_t letter(std::string_view page, unsigned byte) { return letters_of_code_page(page)[byte - 0x80]; }

TEST(CodePages, HaveTheLettersOfUnicode)
{
  EXPECT_EQ(letter("ANSI_1250", 0x9A), 0x0161);  // s with caron
  EXPECT_EQ(letter("ANSI_1251", 0xE4), 0x0434);  // Cyrillic de
  EXPECT_EQ(letter("ANSI_1252", 0xEF), 0x00EF);  // i with diaeresis
  EXPECT_EQ(letter("ANSI_1253", 0xE1), 0x03B1);  // alpha
  EXPECT_EQ(letter("ANSI_1254", 0xF0), 0x011F);  // g with breve
  EXPECT_EQ(letter("ANSI_1257", 0xE0), 0x0105);  // a with ogonek
  EXPECT_EQ(letter("DOS437", 0x80), 0x00C7);     // C with cedilla
  EXPECT_EQ(letter("DOS850", 0xFF), 0x00A0);     // the last one: a space
}

TEST(CodePages, AreKnownInWhateverLettersTheirNamesAre)
{
  EXPECT_EQ(letters_of_code_page("ansi_1252").size(), 128u);
  EXPECT_EQ(letters_of_code_page("dos850"), letters_of_code_page("DOS_850"));
  EXPECT_TRUE(letters_of_code_page("ANSI_932").empty());
}

}  // namespace code_pages_test
