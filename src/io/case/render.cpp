// If the key of a problem is not in the file, the nearest table above it is shown, and the default that counts. A value
// that --set gave has no place in the file, so the change itself is shown. The file may hold anything, so all that is
// shown goes through printable().

#include "io/case/render.hpp"

#include "math/utf8.hpp"
#include "io/case/key_text.hpp"
#include "io/case/keys.hpp"
#include "io/case/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace terp {
namespace {

struct Spot {
  Place place;  ///< line 0: none
  std::string override_text;
  bool exact = true;  ///< false: the key is not there, the spot is a table above it
};

std::string line_of(const std::string& text, int line)
{
  std::size_t begin = 0;
  for (int k = 1; k < line && begin != std::string::npos; ++k) {
    begin = text.find('\n', begin);
    if (begin != std::string::npos) ++begin;
  }
  if (begin == std::string::npos) return "";
  std::string found = text.substr(begin, text.find('\n', begin) - begin);
  if (!found.empty() && found.back() == '\r') found.pop_back();
  return printable(found);
}

/// The underline: tabs stay tabs, so that it lines up in any terminal.
std::string carets(const std::string& line, const Place& place)
{
  std::string marks;
  int column = 1;
  for (std::string_view rest = std::string_view(line).substr(0, line.find_last_not_of(" \t") + 1); !rest.empty();) {
    const char c = take_letter(rest).bytes.front();
    const bool inside = column >= place.column && (place.length == 0 || column < place.column + place.length);
    if (inside)
      marks += '^';
    else if (column < place.column)
      marks += c == '\t' ? '\t' : ' ';
    ++column;
  }
  for (; column < place.column; ++column) marks += ' ';
  return marks.find('^') == std::string::npos ? marks + '^' : marks;
}

std::string frame(const std::string& text, const Place& place)
{
  const std::string line = line_of(text, place.line);
  return fmt::format("\n{:>5} | {}\n      | {}\n", place.line, line, carets(line, place));
}

std::string indented(const std::string& detail)
{
  std::string out = "  ";
  for (const char c : detail) {
    out += c;
    if (c == '\n') out += "  ";
  }
  return out + '\n';
}

/// The path without its last part: "body[0].box" -> "body[0]" -> "body" -> "".
std::string above(const std::string& path)
{
  auto parts = split_path(path);
  std::string shorter;
  if (!parts.empty()) parts.pop_back();
  for (const std::string& part : parts) shorter = part.starts_with('[') ? shorter + part : join_path(shorter, part);
  return shorter;
}

/// "--set KEY=VALUE" of a node or of the first one below it that came from there, or an empty text.
std::string find_override(const Node& node)
{
  std::string found = node.override_text;
  for (std::size_t k = 0; found.empty() && k < node.items.size(); ++k) found = find_override(node.items[k]);
  return found;
}

/// The --set that the problem comes from: of its key, or else of the keys that this one does not go with.
std::string find_override(const Problem& problem, const Node& root)
{
  if (problem.key.starts_with("--set ")) return problem.key;
  std::string found;
  if (const Node* own = find_node(root, problem.key)) found = own->override_text;
  for (const std::string& other : problem.others)
    if (const Node* node = find_node(root, other); node != nullptr && found.empty()) found = find_override(*node);
  return found;
}

Spot find_spot(const Problem& problem, const Document& document)
{
  if (const std::string change = find_override(problem, document.root); !change.empty()) return {{}, change, true};
  for (std::string path = problem.key; !path.empty(); path = above(path)) {
    const Node* node = find_node(document.root, path);
    if (node == nullptr) continue;
    const bool exact = path == problem.key;
    const bool at_key = (problem.at_key || !exact) && node->key.line > 0;
    Place place = at_key ? node->key : node->value;
    const bool is_header = node->kind == NodeKind::table && node->key.line > 0 && node->value.line == node->key.line &&
                           node->value.column <= node->key.column;
    if (is_header && !at_key) place = node->key;
    return {place, node->override_text, exact};
  }
  return {{}, "", problem.key.empty()};
}

std::string location(const std::string& path, const Spot& spot)
{
  if (!spot.override_text.empty()) return spot.override_text;
  if (spot.place.line == 0) return path;
  return fmt::format("{}:{}:{}", path, spot.place.line, spot.place.column);
}

/// "`initial.k0` is not given; its default is 1." for a problem with a key that the file does not hold.
std::string note_on_default(const Problem& problem)
{
  const KeyInfo* key = find_key(problem.key);
  if (key == nullptr || key->default_text.empty()) return "";
  return fmt::format("`{}` is not given; its default is {}.", problem.key, key->default_text);
}

/// same: problems that say the same of several places.
std::string render_one(const std::string& word, std::span<const Problem> same, const Document& document)
{
  const Problem& problem = same.front();
  const Spot spot = find_spot(problem, document);
  std::string out = fmt::format("{}: {}: {}\n", word, location(document.path, spot), problem.what);
  if (problem.detail.empty() && word != "error") return printable(out);  // a warning in one line
  if (spot.override_text.empty() && spot.place.line > 0) out += frame(document.text, spot.place);
  std::string elsewhere;
  for (const Problem& other : same.subspan(1))
    elsewhere += (elsewhere.empty() ? "The same at " : ", ") + location(document.path, find_spot(other, document));
  if (!elsewhere.empty()) out += indented(elsewhere);
  if (!problem.detail.empty()) out += indented(problem.detail);
  if (!spot.exact && !note_on_default(problem).empty()) out += indented(note_on_default(problem));
  if (!problem.topic.empty()) out += indented("More: terp explain " + problem.topic);
  return printable(out) + '\n';
}

std::vector<Problem> in_file_order(std::vector<Problem> problems, const Document& document)
{
  const auto rank = [&](const Problem& problem) {
    const Place place = find_spot(problem, document).place;
    return std::pair(place.line == 0 ? std::numeric_limits<int>::max() : place.line, place.column);
  };
  std::ranges::stable_sort(problems, [&](const Problem& a, const Problem& b) { return rank(a) < rank(b); });
  return problems;
}

/// Problems that say the same of several places of the file, together at the first of them.
std::vector<std::vector<Problem>> grouped(const std::vector<Problem>& problems, const Document& document)
{
  std::vector<std::vector<Problem>> groups;
  for (const Problem& problem : problems) {
    const bool has_place = find_spot(problem, document).place.line > 0;
    const auto is_same = [&](const std::vector<Problem>& group) {
      const Problem& first = group.front();
      return has_place && !problem.detail.empty() && first.what == problem.what && first.detail == problem.detail;
    };
    const auto group = std::ranges::find_if(groups, is_same);
    if (group == groups.end())
      groups.push_back({problem});
    else
      group->push_back(problem);
  }
  return groups;
}

std::string render_all(const std::string& word, const std::vector<Problem>& problems, const Document& document)
{
  std::string out;
  const auto groups = grouped(in_file_order(problems, document), document);
  for (std::size_t k = 0; k < std::min(groups.size(), max_shown); ++k) out += render_one(word, groups[k], document);
  if (groups.size() > max_shown) out += fmt::format("and {} more\n\n", groups.size() - max_shown);
  return out;
}

}  // namespace

std::string render_errors(const std::vector<Problem>& problems, const Document& document)
{
  const std::size_t n = grouped(problems, document).size();
  return render_all("error", problems, document) +
         fmt::format("{} {}; nothing was run.\n", n, n == 1 ? "error" : "errors");
}

std::string render_warnings(const std::vector<Problem>& warnings, const Document& document, const std::string& run)
{
  return render_all(run.empty() ? "warning" : "warning: " + run, warnings, document);
}

std::string render_at(const std::string& path, const std::string& text, Place place, const Problem& problem)
{
  std::string out = fmt::format("error: {}: {}\n", location(path, {place, "", true}), problem.what);
  if (place.line > 0) out += frame(text, place);
  return printable(out + indented(problem.detail));
}

}  // namespace terp
