#include "io/case/syntax_advice.hpp"
#include "io/case/samples.hpp"
#include "support/catalogue.hpp"
#include "support/paths.hpp"

namespace syntax_advice_test {

SyntaxAdvice advice_for(const std::string& text)
{
  try {
    parse_toml(text);
  } catch (const SyntaxError& error) {
    return advise_on_syntax(text, error);
  }
  ADD_FAILURE() << "this is TOML: " << text;
  return {};
}

TEST(SyntaxAdvice, SaysHowItIsWritten)
{
  const std::string path = source_path("tests/io/case/syntax.wrong");
  for (const WrongRow& row : read_catalogue(path)) {
    const SyntaxAdvice advice = advice_for(row.before);
    expect_row(path, row, advice.what + '\n' + advice.cure);
  }
  EXPECT_EQ(advice_for("title = \"d\xFCne\"").what, "this letter is not UTF-8");
}

TEST(SyntaxAdvice, FindsTheBracketThatIsNotClosed)
{
  const SyntaxAdvice list = advice_for("a = 1\nbox = [[0.0, 0.0], [8.0, 2.0]\n[time]\nend = 4.0\n");
  EXPECT_EQ(list.what, "a bracket is not closed");
  EXPECT_EQ(list.place.line, 2);
  EXPECT_EQ(list.place.column, 7);
  EXPECT_THAT(list.cure, StartsWith("The `[` here wants its `]`; it is missed in line "));
  const SyntaxAdvice header = advice_for("[time\nend = 4.0\n");
  EXPECT_EQ(header.what, "a bracket is not closed");
  EXPECT_EQ(header.place.line, 1);
  EXPECT_EQ(header.cure, "The `[` here wants its `]`.");
}

TEST(SyntaxAdvice, KeepsTheWordsOfTheParserForWhatItDoesNotKnow)
{
  const SyntaxAdvice advice = advice_for("a = 1.0.0");
  EXPECT_EQ(advice.what, "");
  EXPECT_THAT(advice.cure, HasSubstr("Error while parsing"));
  EXPECT_FALSE(advice_for("a = " + std::string(200000, '1') + "x").cure.empty());  // a line as no one writes it
}

TEST(SyntaxAdvice, IsWhatTheUserReads)
{
  EXPECT_EQ(message_for("title = \"a\"\n[time]\nend = 0,2\n"),
      "error: case.toml:3:8: this is not valid TOML: a number has a decimal point, no comma\n\n    3 | end = 0,2\n"
      "      |        ^\n  Write 0.2.\n  The format: https://toml.io\n\n1 error; nothing was run.\n");
}

TEST(SyntaxAdvice, KnowsUtf16)
{
  using namespace std::string_literals;
  EXPECT_TRUE(is_utf16("\xFF\xFE[\0t\0"s));
  EXPECT_TRUE(is_utf16("[\0t\0i\0"s));
  EXPECT_FALSE(is_utf16("[time]\n"));
  EXPECT_FALSE(is_utf16("[\0\0\0\0"s));
  EXPECT_THAT(message_for("\xFF\xFE[\0t\0"s),
      HasSubstr(
          "case.toml: this is text in UTF-16\n  Save it as UTF-8: in the editor, \"Save as\", encoding UTF-8.\n"));
}

}  // namespace syntax_advice_test
