#include "support/catalogue.hpp"
#include "support/process.hpp"

#include <cstdlib>

namespace terp::test {
namespace {

std::string unescaped(std::string text)
{
  for (const auto& [mark, character] : {std::pair{"\\n", '\n'}, std::pair{"\\0", '\0'}})
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
      text.replace(at, 2, 1, character);
  return text;
}

/// The part of `text` up to `mark`, which is taken off it together with the mark.
std::string cut(std::string& text, const std::string& mark)
{
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string part = text.substr(0, end);
  text.erase(0, end + mark.size());
  return unescaped(part);
}

}  // namespace

std::vector<WrongRow> read_catalogue(const std::string& path)
{
  const std::filesystem::path file(path);
  std::istringstream lines(text_of(path));
  std::vector<WrongRow> rows;
  int number = 0;
  WrongRow row;
  row.name = file.stem();
  row.verdict = "refused";
  for (std::string line; std::getline(lines, line);) {
    row.where = file.filename().string() + ':' + std::to_string(++number);
    if (line.starts_with("@ ")) {
      line.erase(0, 2);
      row.name = cut(line, " ");
      row.verdict = line;
    } else if (!line.empty() && line[0] != '#') {
      rows.push_back(row);
      if (line.starts_with("--set ")) {
        std::string changes = ' ' + cut(line, " | ");
        cut(changes, " --set ");
        while (!changes.empty()) rows.back().changes.push_back(cut(changes, " --set "));
      } else {
        rows.back().before = cut(line, " | ");
        rows.back().after = cut(line, " | ");
      }
      rows.back().expected = unescaped(line);
    }
  }
  return rows;
}

void expect_row(const std::string& path, const WrongRow& row, const std::string& said)
{
  if (std::getenv("TERP_UPDATE_GOLDEN") != nullptr && said != row.expected) {
    const int number = std::stoi(row.where.substr(row.where.rfind(':') + 1));
    std::istringstream lines(text_of(path));
    std::string text, line;
    for (int k = 1; std::getline(lines, line); ++k, text += line + '\n') {
      if (k != number) continue;
      std::size_t end = line.find(" | ");
      if (row.changes.empty() && end != std::string::npos) end = line.find(" | ", end + 3);
      line = line.substr(0, end) + (said.empty() ? "" : " | ");
      for (const char c : said) line += c == '\n' ? std::string("\\n") : std::string(1, c);
    }
    write_text(path, text);
  }
  EXPECT_EQ(said, row.expected) << row.where << ": if it is right, TERP_UPDATE_GOLDEN=1 and the same test once more";
}

std::string spoil(const std::string& good, const WrongRow& row)
{
  if (row.before.empty()) return good + row.after;
  const std::size_t at = good.find(row.before);
  EXPECT_NE(at, std::string::npos) << row.where << ": the text does not hold `" << row.before << '`';
  EXPECT_EQ(good.find(row.before, at + 1), std::string::npos) << row.where << ": the text holds it twice";
  return std::string(good).replace(at, row.before.size(), row.after);
}

}  // namespace terp::test
