// Names and comments come from files of others. Texts go through in_quotes and comments through printable(), so that
// none can end its line and be read as a key.

#include "import/dstability/case_text.hpp"

#include "math/utf8.hpp"
#include "io/case/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace terp {
namespace {

constexpr std::size_t most_columns = 120, comment_column = 41;

constexpr std::string_view minus_signs[] = {"-", "−", "–"};  // of a keyboard, of print, and a dash

/// The letters of Latin-1 as those of a key; empty: no such letter.
std::string without_accent(std::string_view letter)
{
  constexpr std::pair<std::string_view, const char*> plain[] = {{"àáâãäåÀÁÂÃÄÅ", "a"}, {"æÆ", "ae"}, {"çÇ", "c"},
      {"èéêëÈÉÊË", "e"}, {"ìíîïÌÍÎÏ", "i"}, {"ñÑ", "n"}, {"òóôõöøÒÓÔÕÖØ", "o"}, {"ß", "ss"}, {"ùúûüÙÚÛÜ", "u"},
      {"ýÿÝ", "y"}};
  for (const auto& [letters, word] : plain)
    if (letter.size() == 2 && letters.find(letter) != std::string_view::npos) return word;
  return "";
}

std::string comment_text(const std::string& raw)
{
  const std::string comment = printable(raw);
  std::string text;
  std::size_t from = 0;
  while (from < comment.size()) {
    const std::size_t end = std::min(comment.find('\n', from), comment.size());
    std::string line = comment.substr(from, end - from);
    while (line.size() > most_columns - 2) {
      std::size_t cut = line.rfind(' ', most_columns - 2);
      if (cut == std::string::npos || cut == 0)  // no space: between two letters
        for (cut = most_columns - 2; (static_cast<unsigned char>(line[cut]) & 0xC0U) == 0x80U;) --cut;
      text += "# " + line.substr(0, cut) + "\n";
      line = line.substr(line[cut] == ' ' ? cut + 1 : cut);
    }
    text += "# " + line + "\n";
    from = end + 1;
  }
  return text;
}

std::string lines_text(const std::vector<CaseLine>& lines)
{
  std::size_t width = 0;
  for (const CaseLine& line : lines) width = std::max(width, line.key.size());
  std::string text;
  for (const CaseLine& line : lines) {
    const std::string pair = fmt::format("{:<{}} = {}", line.key, width, line.value);
    if (line.comment.empty()) {
      text += pair + "\n";
    } else if (const std::string whole = fmt::format("{:<{}}# {}", pair, comment_column, line.comment);
               whole.size() <= most_columns && pair.size() < comment_column) {
      text += whole + "\n";
    } else {
      text += comment_text(line.comment) + pair + "\n";
    }
  }
  return text;
}

std::string table_text(const CaseTableText& table)
{
  return "\n" + comment_text(table.comment) + table.header + "\n" + lines_text(table.lines);
}

std::string body_text(const CaseBodyText& body)
{
  std::string text = "\n" + comment_text(body.comment) + "[[body]]\n";
  if (!body.name.empty()) text += fmt::format("name     = {}\n", in_quotes(body.name));
  text += fmt::format("material = {}\n", in_quotes(body.material));
  text += "polygon  = " + places_text(body.polygon, 2, 11) + "\n";
  if (!body.holes.empty()) {
    text += "holes    = [\n";
    for (const Polygon& hole : body.holes) text += "  " + places_text(hole, 4, 2) + ",\n";
    text += "]\n";
  }
  return text + "points_per_cell = [4, 4]\n";
}

}  // namespace

std::string in_quotes(const std::string& raw)
{
  std::string out = "\"";
  for (const char c : as_utf8(raw))
    if (c == '"' || c == '\\')
      out += std::string("\\") + c;
    else if (static_cast<unsigned char>(c) < 32 || c == 127)
      out += ' ';
    else
      out += c;
  return out + "\"";
}

std::string number_text(Real value)
{
  std::string text = fmt::format("{:.10f}", value);
  while (text.back() == '0' && text[text.size() - 2] != '.') text.pop_back();
  return text == "-0.0" ? "0.0" : text;
}

std::string list_text(const std::vector<std::vector<Real>>& rows, std::size_t indent, std::size_t first_column)
{
  std::string text = "[", line(first_column + 1, ' ');
  bool is_first_line = true;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::string row;
    for (const Real number : rows[k]) row += (row.empty() ? "[" : ", ") + number_text(number);
    row += k + 1 == rows.size() ? "]]" : "], ";
    if (line.size() + row.size() > most_columns) {
      while (line.ends_with(' ')) line.pop_back();
      text += is_first_line ? line.substr(std::min(first_column + 1, line.size())) : line;
      text += "\n";
      line = std::string(indent, ' ');
      is_first_line = false;
    }
    line += row;
  }
  return text + (is_first_line ? line.substr(first_column + 1) : line);
}

std::string places_text(const std::vector<Vec<2>>& places, std::size_t indent, std::size_t first_column)
{
  std::vector<std::vector<Real>> rows;
  for (const Vec<2>& place : places) rows.push_back({place[0], place[1]});
  return list_text(rows, indent, first_column);
}

std::string key_of_name(const std::string& name, const std::string& otherwise)
{
  std::string key;
  const auto add_word = [&key](const char* word) {
    if (!key.empty() && key.back() != '_') key += '_';
    key += word;
  };
  const std::string text = as_utf8(name);
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t at = text.size() - rest.size();
    const std::string letter(take_letter(rest).bytes);
    const char next = rest.empty() ? ' ' : rest.front(), before = at == 0 ? ' ' : text[at - 1];
    const bool is_number_next = next >= '0' && next <= '9';
    const bool is_sign = is_number_next && (std::string_view(" (=:~").find(before) != std::string_view::npos ||
                                               key == "nap" || key.ends_with("_nap"));
    if (const auto c = static_cast<unsigned char>(letter[0]); c < 128 && std::isalnum(c))
      key += static_cast<char>(std::tolower(c));
    else if (is_sign && std::ranges::find(minus_signs, letter) != std::end(minus_signs))
      add_word("minus_");
    else if (is_sign && letter == "+")
      add_word("plus_");
    else if (const std::string plain = without_accent(letter); !plain.empty())
      key += plain;
    else if (!key.empty() && key.back() != '_')
      key += '_';
  }
  while (key.ends_with('_')) key.pop_back();
  return key.empty() ? otherwise : key;
}

void name_bodies(std::vector<CaseBodyText>& bodies)
{
  std::set<std::string> used;
  for (CaseBodyText& body : bodies) {
    const bool is_number = body.name.find_first_not_of("0123456789") == std::string::npos;
    const std::string wanted = is_number ? "layer " + body.name : body.name;
    body.name = wanted;
    for (int k = 2; !used.insert(body.name).second; ++k) body.name = fmt::format("{} ({})", wanted, k);
  }
}

std::string text_of(const SectionText& text)
{
  std::string out;
  for (const std::string& line : text.head) out += comment_text(line);
  out += fmt::format("\ntitle  = {}\nscheme = \"mpm_gp\"\n", in_quotes(text.title));
  for (const CaseTableText& table : text.before) out += table_text(table);
  for (const CaseBodyText& body : text.bodies) out += body_text(body);
  for (const CaseMaterialText& material : text.materials)
    out += table_text({fmt::format("[material.{}]", material.name), material.comment, material.lines});
  for (const CaseTableText& table : text.after) out += table_text(table);
  return out;
}

}  // namespace terp
