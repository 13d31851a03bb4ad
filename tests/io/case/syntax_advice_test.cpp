#include "io/case/syntax_advice.hpp"
#include "io/case/samples.hpp"

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

struct Written {
  const char* text;
  const char* what;
  const char* cure;
};

TEST(SyntaxAdvice, SaysHowItIsWritten)
{
  const Written habits[] = {
      {"end = 0,2", "a number has a decimal point, no comma", "Write 0.2."},
      {"su_peak = 8,000", "a number has a decimal point, no comma",
          "Write 8000 if the comma stands between thousands, 8.000 if it is a decimal one."},
      {"su_peak = 8,000 kPa", "a number has a decimal point, no comma",
          "Write \"8000 kPa\" if the comma stands between thousands, \"8.000 kPa\" if it is a decimal one."},
      {"su_peak = 8,5e3 # Pa", "a number has a decimal point, no comma", "Write 8.5e3."},
      {"G = 2,000,000", "a number has a decimal point, no comma", "Write 2000000: no comma stands between thousands."},
      {"rho = 1,990.0", "a number has a decimal point, no comma", "Write 1990.0: no comma stands between thousands."},
      {"end = 0,200", "a number has a decimal point, no comma", "Write 0.200."},
      {"box = 0,0,8,2", "a number has a decimal point, no comma",
          "Write one number, 8.0e3, or a list in square brackets: [1.0, 2.0]."},
      {"damping = { local = 0,1 }", "a number has a decimal point, no comma", "Write 0.1."},
      {"gravity = [0,0, -9,08]", "a number has a decimal point, no comma",
          "Write -9.08 if the comma is a decimal one."},
      {"G = 2'000'000", "a number has no apostrophes in it", "Write 2000000."},
      {"G = 8e3.0", "the exponent of a number is a whole number", "Write 8e3, without the point behind it."},
      {"G = 8*1000", "a value is a number, no calculation",
          "Write its result, 8.0e3. Where a key takes a formula, it stands in quotes."},
      {"G = 1 / 3", "a value is a number, no calculation",
          "Write its result, 8.0e3. Where a key takes a formula, it stands in quotes."},
      {"damping = { local 0.1 }", "a key and its value stand on both sides of an equals sign", "Write local = 0.1"},
      {"damping = { local: 0.1 }", "a key and its value stand on both sides of an equals sign", "Write local = 0.1"},
      {"damping = { local = 0.1, }", "no comma stands behind the last entry in braces",
          "Remove the comma before the `}`."},
      {"damping = { local = 0.1\nb = 1", "a bracket is not closed", "The `{` here wants its `}` in the same line."},
      {"bottom = { contact = \"bilateral\", adhesion = 8.0e3 # Pa\nb = 1", "a bracket is not closed",
          "The `{` here wants its `}` in the same line."},
      {"su_peak = 8 kPa", "a number with a unit stands in quotes", "Write \"8 kPa\", in quotes, or 8000 (in Pa)."},
      {"density = 1.99 t/m^3", "a number with a unit stands in quotes",
          "Write \"1.99 t/m^3\", in quotes, or 1990 (in kg/m^3)."},
      {"local = 5 %", "a number with a unit stands in quotes", "Write \"5 %\", in quotes, or 0.05 (in parts of one)."},
      {"end = 4 weeks", "a number with a unit stands in quotes",
          "Write 4 in the unit that `terp explain` names: Terp reads SI units, m, kg, s, Pa."},
      {"cell = .2", "a number has a digit before its decimal point", "Write 0.2."},
      {"gravity = [0.0, -.5]", "a number has a digit before its decimal point", "Write -0.5."},
      {"G = 2.0d6", "an exponent is written with e", "Write 2.0e6."},
      {"end = 4.\n", "a number has a digit after its decimal point", "Write 4.0."},
      {"end = 007", "a number has no leading zeros", "Leave them out: 7, not 007."},
      {"G = 2 000 000", "a number has no blanks in it", "Write 2000000."},
      {"mesh = True", "true and false are written in small letters", "Write true."},
      {"end : 4.0", "a key and its value stand on both sides of an equals sign", "Write end = 4.0"},
      {"end 4.0", "a key and its value stand on both sides of an equals sign", "Write end = 4.0"},
      {"scheme = mpm_gp", "text stands in quotes", "Write \"mpm_gp\". Numbers are written 8.0e3."},
      {"shear modulus = 1e6", "a key is one word", "Write shear_modulus = ..."},
      {"density = 2.000,0", "a number has a decimal point, no comma",
          "Write 2000.0: one point, and none between thousands."},
      {"end == 4.0", "a value stands behind one equals sign", "Remove one."},
      {"end =\nb = 1", "a key has no value", "Write it behind the equals sign, in the same line."},
      {"size = (1.0, 2.0)", "a list stands in square brackets", "Write [1.0, 2.0], not (1.0, 2.0)."},
      {"end = 4.0;", "a line ends without a semicolon", "Remove it."},
      {"size = [1.0; 2.0]", "a comma stands between the entries of a list", "Write [1.0, 2.0], not [1.0; 2.0]."},
      {"size = [1.0 2.0]", "a comma stands between the entries of a list", "Write [1.0, 2.0], not [1.0 2.0]."},
      {"size = [1.0\t2.0]", "a comma stands between the entries of a list", "Write [1.0, 2.0], not [1.0 2.0]."},
      {"end = 4.0 // s", "a comment begins with #", "Write # in place of //."},
      {"size = 1.0]", "a bracket is closed that nobody opened", "Remove it, or open it before."},
      {"model = 'a\nb = 1", "a text has no closing quote", "A text stands in one line, between two quotes: \"clay\"."},
      {"model = \u201Ca\u201D", "a text stands between plain quotes",
          "Write \"clay\": a word processor has made others of them."},
      {"angle = 30\u00B0", "a number with a unit stands in quotes", "Write \"30 deg\", in quotes, or 30."},
      {"title = \"d\xFCne\"", "this letter is not UTF-8",
          "Save the file as UTF-8: in the editor, \"Save as\", encoding UTF-8."},
      {"title = \"a\nb = 1", "a text has no closing quote", "A text stands in one line, between two quotes: \"clay\"."},
      {"end = 1\nend = 2", "`end` is there twice", "Remove one of the two."},
      {"[time]\n[time]", "`time` is there twice",
          "Join the two sections [time]. Sections of which there may be many have two brackets: [[body]]."},
  };
  for (const auto& [text, what, cure] : habits) {
    const SyntaxAdvice advice = advice_for(text);
    EXPECT_EQ(advice.what, what) << text;
    EXPECT_EQ(advice.cure, cure) << text;
  }
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
