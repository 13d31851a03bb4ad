#include "import/drawing/dxf_letters.hpp"
#include "support/test.hpp"

namespace dxf_letters_test {

TEST(DxfLetters, OfUtf8Stay) { EXPECT_EQ(dxf_letters("kle\xC3\xAF", "ANSI_1252"), "kle\xC3\xAF"); }

TEST(DxfLetters, OfTheCodePageBecomeUtf8)
{
  EXPECT_EQ(dxf_letters("kle\xEF", "ANSI_1252"), "kle\xC3\xAF");
  EXPECT_EQ(dxf_letters("5 \x80", ""), "5 \xE2\x82\xAC");
  EXPECT_EQ(dxf_letters("h\xF9m\xFAs", "ANSI_1250"), "h\xC5\xAFm\xC3\xBAs");
  EXPECT_EQ(dxf_letters("kle\x8B", "dos850"), "kle\xC3\xAF");
  EXPECT_EQ(dxf_letters("kle\xEF", "ANSI_932"), "kle\xEF\xBF\xBD");
}

TEST(DxfLetters, MayBeEscaped)
{
  EXPECT_EQ(dxf_letters("kle\\U+00EF 2", ""), "kle\xC3\xAF 2");
  EXPECT_EQ(dxf_letters("\\U+D800 \\U+12", ""), "\\U+D800 \\U+12");
}

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

}  // namespace dxf_letters_test
