// Letters of DXF texts: UTF-8, code pages, escapes.
#include "drawing/dxf_letters.hpp"
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

}  // namespace dxf_letters_test
