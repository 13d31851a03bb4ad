// The table below looks at the line where the parser stopped for what people write instead of TOML. A bracket that is
// not closed is noticed lines later: it is found by counting brackets from the start.

#include "io/case/syntax_advice.hpp"

#include "io/case/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <regex>

namespace terp {
namespace {

/// A line; at most its first 500 characters: std::regex calls itself for each, and no line that people write is longer.
std::string_view line_at(std::string_view text, int line)
{
  std::size_t begin = 0;
  for (int k = 1; k < line; ++k) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  return text.substr(begin, std::min<std::size_t>(text.find_first_of("\r\n", begin) - begin, 500));
}

std::string cure_of_unit(std::string number, const std::string& unit)
{
  std::erase(number, '_');  // of 2_000, which are digits of TOML
  const auto quantity = parse_quantity(number + ' ' + unit);
  if (quantity && quantity->unit != nullptr)
    return fmt::format("Write \"{} {}\", in quotes, or {} (in {}).", number, unit, quantity->value(),
        quantity->unit->of_key == "-" ? "parts of one" : quantity->unit->of_key);
  return fmt::format("Write {} in the unit that `terp explain` names: Terp reads SI units, m, kg, s, Pa.", number);
}

constexpr const char* one_number = "Write one number, 8.0e3, or a list in square brackets: [1.0, 2.0].";

/// What people write instead of TOML: a pattern of the line, what is wrong, and the cure from what the pattern found.
struct Habit {
  const char* pattern;
  const char* what;
  std::string (*cure)(const std::smatch& found);
};

#define TERP_NUMBER R"([-+]?\d[\d_]*(?:\.\d+)?(?:[eE][-+]?\d+)?)"
const Habit habits[] = {
    {R"(^\s*([A-Za-z]\w*)[ \t]+([A-Za-z]\w*)\s*=)", "a key is one word",
        [](const std::smatch& m) { return fmt::format("Write {}_{} = ...", m.str(1), m.str(2)); }},
    {R"([=\[,]\s*([-+]?\d{1,3})((?:\.\d{3})+),(\d+)\s*(?:#.*)?$)", "a number has a decimal point, no comma",
        [](const std::smatch& m) {
          std::string rest = m.str(2);
          std::erase(rest, '.');
          return fmt::format("Write {}{}.{}: one point, and none between thousands.", m.str(1), rest, m.str(3));
        }},
    {R"(=\s*([-+]?\d+(?:,\d+)+(?:\.\d+)?(?:[eE][-+]?\d+)?(?:\s*[A-Za-z%][\w/^%]*)?)\s*(?:[,}#].*)?$)",
        "a number has a decimal point, no comma",
        [](const std::smatch& m) { return advise_on_commas(m.str(1)).value_or(one_number); }},
    {R"([\[,]\s*([-+]?\d+),(0\d+)\s*[,\]])", "a number has a decimal point, no comma",
        [](const std::smatch& m) {
          return fmt::format("Write {}.{} if the comma is a decimal one.", m.str(1), m.str(2));
        }},
    {R"(^[^"'#]*==)", "a value stands behind one equals sign",
        [](const std::smatch&) { return std::string("Remove one."); }},
    {R"(=\s*(?:#.*)?$)", "a key has no value",
        [](const std::smatch&) { return std::string("Write it behind the equals sign, in the same line."); }},
    {R"(^[^"'#]*=\s*\()", "a list stands in square brackets",
        [](const std::smatch&) { return std::string("Write [1.0, 2.0], not (1.0, 2.0)."); }},
    {R"(^[^"'#]*;\s*(?:#.*)?$)", "a line ends without a semicolon",
        [](const std::smatch&) { return std::string("Remove it."); }},
    {R"(\d\s*;\s*[-+]?[\d.])", "a comma stands between the entries of a list",
        [](const std::smatch&) { return std::string("Write [1.0, 2.0], not [1.0; 2.0]."); }},
    {R"([\[,]\s*)" TERP_NUMBER R"([ \t]+[-+]?\d+\.)", "a comma stands between the entries of a list",
        [](const std::smatch&) { return std::string("Write [1.0, 2.0], not [1.0 2.0]."); }},
    {R"(^[^"'#]*\s(//|/\*))", "a comment begins with #",
        [](const std::smatch& m) { return fmt::format("Write # in place of {}.", m.str(1)); }},
    {R"([=\[,]\s*([-+]?)(\.\d+))", "a number has a digit before its decimal point",
        [](const std::smatch& m) { return fmt::format("Write {}0{}.", m.str(1), m.str(2)); }},
    {R"([=\[,]\s*)" TERP_NUMBER R"(\s*[*/^+]\s*[-+]?[\d.])", "a value is a number, no calculation",
        [](const std::smatch&) {
          return std::string("Write its result, 8.0e3. Where a key takes a formula, it stands in quotes.");
        }},
    {R"(([-+]?\d+(?:\.\d+)?[eE][-+]?\d+)\.\d*)", "the exponent of a number is a whole number",
        [](const std::smatch& m) { return fmt::format("Write {}, without the point behind it.", m.str(1)); }},
    {R"(=\s*([-+]?\d{1,3}(?:'\d{3})+))", "a number has no apostrophes in it",
        [](const std::smatch& m) {
          std::string digits = m.str(1);
          std::erase(digits, '\'');
          return fmt::format("Write {}.", digits);
        }},
    {R"(([-+]?\d+(?:\.\d*)?)[dD]([-+]?\d+))", "an exponent is written with e",
        [](const std::smatch& m) { return fmt::format("Write {}e{}.", m.str(1), m.str(2)); }},
    {R"(([-+]?\d+)\.(?:[eE]|\s|,|\]|$))", "a number has a digit after its decimal point",
        [](const std::smatch& m) { return fmt::format("Write {}.0.", m.str(1)); }},
    {R"([=\[,]\s*([-+]?)0+(\d))", "a number has no leading zeros",
        [](const std::smatch&) { return std::string("Leave them out: 7, not 007."); }},
    {R"([=\[,]\s*(\d{1,3})((?:\s\d{3})+)\b)", "a number has no blanks in it",
        [](const std::smatch& m) {
          std::string rest = m.str(2);
          std::erase(rest, ' ');
          return fmt::format("Write {}{}.", m.str(1), rest);
        }},
    {R"([=\[,]\s*()" TERP_NUMBER R"()\s*(?![eE][-+]?\d)([A-Za-z%][\w/^%]*)(?![\w/^%]|\s*=))",
        "a number with a unit stands in quotes", [](const std::smatch& m) { return cure_of_unit(m.str(1), m.str(2)); }},
    {R"([=\[,]\s*(True|False|TRUE|FALSE|yes|no|on|off)\b)", "true and false are written in small letters",
        [](const std::smatch& m) {
          const bool is_true = m.str(1) == "yes" || m.str(1) == "on" || m.str(1)[0] == 'T';
          return fmt::format("Write {}.", is_true ? "true" : "false");
        }},
    {R"(^\s*([\w.-]+)\s*(?::\s*|\s)\s*([^=\s].*)$)", "a key and its value stand on both sides of an equals sign",
        [](const std::smatch& m) { return fmt::format("Write {} = {}", m.str(1), m.str(2)); }},
    {R"([{,]\s*([A-Za-z_][\w-]*)(?:\s*:\s*|[ \t]+)([^\s=:,}][^=:,}]*?)\s*[,}])",
        "a key and its value stand on both sides of an equals sign",
        [](const std::smatch& m) { return fmt::format("Write {} = {}", m.str(1), m.str(2)); }},
    {R"(,\s*\})", "no comma stands behind the last entry in braces",
        [](const std::smatch&) { return std::string("Remove the comma before the `}`."); }},
    {R"([=\[,]\s*([A-Za-z][\w.-]*))", "text stands in quotes",
        [](const std::smatch& m) { return fmt::format("Write \"{}\". Numbers are written 8.0e3.", m.str(1)); }},
};
#undef TERP_NUMBER

/// The opening bracket that nothing has closed before `end`; none if there is none.
std::optional<std::size_t> find_open_bracket(std::string_view text, std::size_t end)
{
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < end; ++k) {
    if (text[k] == '"' || text[k] == '\'')
      k = skip_string(text, k) - 1;
    else if (text[k] == '#')
      k = std::min(text.find('\n', k), text.size()) - 1;
    else if (text[k] == '[' || text[k] == '{')
      open.push_back(k);
    else if ((text[k] == ']' || text[k] == '}') && !open.empty())
      open.pop_back();
  }
  if (open.empty()) return std::nullopt;
  return open.back();
}

std::size_t offset_of(std::string_view text, const Place& place)
{
  std::size_t begin = 0;
  for (int k = 1; k < place.line; ++k) begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  return std::min(begin + static_cast<std::size_t>(std::max(place.column - 1, 0)), text.size());
}

/// A bracket is open where a line begins that can only stand outside of it, or where the text ends.
std::optional<SyntaxAdvice> advise_on_bracket(std::string_view text, const SyntaxError& error)
{
  const auto open = find_open_bracket(text, offset_of(text, error.place));
  if (!open) return std::nullopt;
  const std::string_view why = error.what();
  const Place place = place_at(text, *open);
  const std::string line(line_at(text, error.place.line));
  static const std::regex outside(R"(^\s*(\[+\s*[A-Za-z_"]|[\w."-]+\s*=))");
  const std::string_view rest = text.substr(offset_of(text, error.place));
  const std::size_t behind = std::min(rest.find_first_not_of(" \t\r"), rest.size());
  const bool line_ends = behind == rest.size() || rest[behind] == '\n' || rest[behind] == '#';
  if (text[*open] == '{' && place.line == error.place.line && line_ends)
    return SyntaxAdvice{place, "a bracket is not closed", "The `{` here wants its `}` in the same line."};
  const bool elsewhere = place.line != error.place.line;
  const bool at_end = why.find("end-of-file") != std::string_view::npos,
             in_header = why.find("header") != std::string_view::npos;
  if (!at_end && !(elsewhere && std::regex_search(line, outside)) && !(in_header && !elsewhere)) return std::nullopt;
  return SyntaxAdvice{place, "a bracket is not closed",
      fmt::format("The `{}` here wants its `{}`{}.", text[*open], text[*open] == '[' ? ']' : '}',
          elsewhere ? fmt::format("; it is missed in line {}", error.place.line) : "")};
}

/// A line in which more brackets are closed than open, where none was open before.
std::optional<SyntaxAdvice> advise_on_extra_bracket(const std::string& line, const SyntaxError& error)
{
  int open = 0;
  for (std::size_t k = 0; k < line.size() && line[k] != '#'; ++k) {
    if (line[k] == '"' || line[k] == '\'') {
      k = skip_string(line, k) - 1;
      continue;
    }
    open += line[k] == '[' || line[k] == '{' ? 1 : line[k] == ']' || line[k] == '}' ? -1 : 0;
    if (open < 0)
      return SyntaxAdvice{error.place, "a bracket is closed that nobody opened", "Remove it, or open it before."};
  }
  return std::nullopt;
}

/// "cannot redefine existing table 'x'".
std::optional<SyntaxAdvice> advise_on_second(const SyntaxError& error)
{
  const std::string why = error.what();
  std::smatch found;
  if (!std::regex_search(why, found, std::regex("cannot redefine existing ([a-z -]+) '([^']*)'"))) return std::nullopt;
  const std::string name = found.str(2);
  return SyntaxAdvice{error.place, fmt::format("`{}` is there twice", name),
      found.str(1) == "table"
          ? fmt::format(
                "Join the two sections [{0}]. Sections of which there may be many have two brackets: [[body]].", name)
          : "Remove one of the two."};
}

/// A letter that is no plain one: of a word processor, or of another encoding.
std::optional<SyntaxAdvice> advise_on_letter(std::string_view text, const SyntaxError& error)
{
  const std::string why = error.what();
  if (why.find("invalid utf-8") != std::string::npos)
    return SyntaxAdvice{
        error.place, "this letter is not UTF-8", "Save the file as UTF-8: in the editor, \"Save as\", encoding UTF-8."};
  const std::string_view at = text.substr(offset_of(text, error.place));
  for (const std::string_view quote : {"\u201C", "\u201D", "\u201E", "\u2018", "\u2019", "\u00AB", "\u00BB"})
    if (at.starts_with(quote))
      return SyntaxAdvice{error.place, "a text stands between plain quotes",
          "Write \"clay\": a word processor has made others of them."};
  if (at.starts_with("\u00B0"))
    return SyntaxAdvice{error.place, "a number with a unit stands in quotes", "Write \"30 deg\", in quotes, or 30."};
  return std::nullopt;
}

}  // namespace

std::optional<std::string> advise_on_commas(std::string_view value)
{
  static const std::regex pattern(
      R"(^\s*([-+]?)(\d+)((?:,\d+)+)(\.\d+)?((?:[eE][-+]?\d+)?)\s*([A-Za-z%][\w/^%]*)?\s*$)");
  std::smatch found;
  const std::string text(value.substr(0, 100));  // std::regex calls itself for each character
  if (!std::regex_match(text, found, pattern)) return std::nullopt;
  const std::string first = found.str(2), groups = found.str(3), unit = found.str(6);
  std::string digits = first + groups;
  std::erase(digits, ',');
  const auto written = [&](const std::string& number) {
    const std::string whole = found.str(1) + number + found.str(4) + found.str(5);
    return unit.empty() ? whole : fmt::format("\"{} {}\"", whole, unit);
  };
  const bool decimal = std::ranges::count(groups, ',') == 1 && !found[4].matched;
  const bool thousands = first.size() <= 3 && first[0] != '0' && groups.size() % 4 == 0 &&
                         std::regex_match(groups, std::regex(R"((,\d{3})+)"));
  const std::string as_decimal = decimal ? written(first + '.' + groups.substr(1)) : "";
  if (thousands && decimal)
    return fmt::format(
        "Write {} if the comma stands between thousands, {} if it is a decimal one.", written(digits), as_decimal);
  if (thousands) return fmt::format("Write {}: no comma stands between thousands.", written(digits));
  return decimal ? fmt::format("Write {}.", as_decimal) : one_number;
}

SyntaxAdvice advise_on_syntax(std::string_view text, const SyntaxError& error)
{
  if (const auto second = advise_on_second(error)) return *second;
  const std::string why = error.what(), line(line_at(text, error.place.line));
  if (const auto letter = advise_on_letter(text, error)) return *letter;
  if (why.find("parsing string") != std::string::npos || why.find("parsing literal string") != std::string::npos)
    return {error.place, "a text has no closing quote", "A text stands in one line, between two quotes: \"clay\"."};
  if (const auto bracket = advise_on_bracket(text, error)) return *bracket;
  if (const auto bracket = advise_on_extra_bracket(line, error)) return *bracket;
  const bool of_parser = why.find("rror while parsing") != std::string::npos;
  for (const Habit& habit : habits) {
    std::smatch found;
    if (of_parser && std::regex_search(line, found, std::regex(habit.pattern)))
      return {error.place, habit.what, habit.cure(found)};
  }
  return {error.place, "", why};
}

bool is_utf16(std::string_view text)
{
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
  if (text.size() < 4) return false;
  const auto zeros_only_at = [&](std::size_t parity) {
    for (std::size_t k = 0; k < std::min<std::size_t>(text.size(), 64); ++k)
      if ((text[k] == '\0') != (k % 2 == parity)) return false;
    return true;
  };
  return zeros_only_at(0) || zeros_only_at(1);
}

}  // namespace terp
