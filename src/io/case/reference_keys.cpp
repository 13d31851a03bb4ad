// No key of [reference] changes a run: it says where the section comes from, and what other methods found for it. So
// texts are checked here but not kept; the report page reads them from the file again. Doubts become one warning, and
// slip planes are kept in the case for comparison.

#include "io/case/document.hpp"
#include "io/case/key_table.hpp"
#include "io/case/key_text.hpp"
#include "io/case/units.hpp"
#include "io/case/values.hpp"
#include "os/read_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace terp {
namespace {

constexpr const char* list_of_texts = "a list of texts";
constexpr const char* keys_of_plane = "Keys of a slip plane: name, method, factor_of_safety, line, su";

bool refuse_value(
    const Entry& entry, const Node& item, const std::string& path, const char* allowed, Findings& findings)
{
  return refuse(entry, path, fmt::format("`{}` of a slip plane must be {}", item.name, allowed),
      fmt::format("Got {}; allowed: {}.", describe_value(item), allowed), findings);
}

/// [[x, y, S_u], ...]
bool read_strengths(const Node& list, std::vector<SlipPlaneCase::Strength>& strengths)
{
  for (const Node& item : list.items) {
    if (item.kind != NodeKind::list || item.items.size() != 3) return false;
    const auto x = number_of(item.items[0], "m"), y = number_of(item.items[1], "m"),
               su = number_of(item.items[2], "Pa");
    if (!x || !y || !su || !std::isfinite(*x + *y) || !positive.contains(*su)) return false;
    strengths.push_back({{*x, *y}, *su});
  }
  return list.kind == NodeKind::list && !strengths.empty();
}

bool read_item(const Entry& entry, const Node& item, const std::string& path, Findings& findings, SlipPlaneCase& plane)
{
  if (item.name == "line") {
    if (!read_places(entry, item, path, findings, plane.line)) return false;
    return plane.line.size() >= 2 || refuse_value(entry, item, path, "two or more places [[x, y], ...]", findings);
  }
  if (item.name == "su")
    return read_strengths(item, plane.su) ||
           refuse_value(entry, item, path, "a list of [x, y, S_u], S_u more than 0 Pa", findings);
  if (item.name == "factor_of_safety") {
    const auto number = number_of(item, "-");
    if (!number || !positive.contains(*number))
      return refuse_value(entry, item, path, "a number, more than 0", findings);
    plane.factor_of_safety = *number;
    return true;
  }
  if (item.name != "name" && item.name != "method")
    return refuse(entry, path, fmt::format("unknown key `{}`", item.name), keys_of_plane, findings);
  if (item.kind != NodeKind::text) return refuse_value(entry, item, path, "text", findings);
  (item.name == "name" ? plane.name : plane.method) = item.text;
  return true;
}

bool read_slip_planes(const Entry& entry, Findings& findings, std::vector<SlipPlaneCase>& planes)
{
  if (entry.node.kind != NodeKind::list)
    return refuse(entry, entry.path, fmt::format("`{}` must be {}", last_part(entry.path), type_text(entry.key)),
        fmt::format("Got {}.", describe_value(entry.node)), findings);
  bool good = true;
  for (std::size_t k = 0; k < entry.node.items.size(); ++k) {
    const Node& table = entry.node.items[k];
    const std::string path = fmt::format("{}[{}]", entry.path, k);
    SlipPlaneCase& plane = planes.emplace_back();
    for (const Node& item : table.items)
      good = read_item(entry, item, join_path(path, item.name), findings, plane) && good;
    if (good && (plane.name.empty() || plane.line.empty()))
      good = refuse(entry, path, fmt::format("a slip plane has no `{}`", plane.name.empty() ? "name" : "line"),
          "Give name = \"TEXT\" and line = [[x, y], ...] in m; method, factor_of_safety and su may be left out.",
          findings);
  }
  return good;
}

std::string slip_planes_text(const std::vector<SlipPlaneCase>& planes)
{
  std::string text;
  for (const SlipPlaneCase& plane : planes) {
    text += fmt::format("{}{{{}, {}, {}", text.empty() ? "" : ", ", plane.name, plane.method, plane.factor_of_safety);
    for (const Vec<2>& x : plane.line) text += fmt::format(", [{}, {}]", x[0], x[1]);
    for (const auto& [x, su] : plane.su) text += fmt::format(", [{}, {}, {}]", x[0], x[1], su);
    text += '}';
  }
  return text;
}

/// Nothing of the texts is kept.
bool read_texts(const Entry& entry, Findings& findings)
{
  const std::string name = last_part(entry.path);
  const auto is_text = [](const Node& item) { return item.kind == NodeKind::text; };
  if (entry.node.kind != NodeKind::list || !std::ranges::all_of(entry.node.items, is_text))
    return refuse(entry, entry.path, fmt::format("`{}` must be {}", name, list_of_texts),
        fmt::format("Got {}.", describe_value(entry.node)), findings);
  if (std::ranges::any_of(entry.node.items,
          [](const Node& item) { return item.text.find_first_not_of(" \t\r\n") == std::string::npos; }))
    return refuse(entry, entry.path, fmt::format("a text of `{}` is empty", name),
        fmt::format("Write what {}, or take the text out of the list.",
            name.starts_with("doubts") ? "is in doubt" : "was assumed"),
        findings);
  return true;
}

bool read_doubts(const Entry& entry, Findings& findings)
{
  if (!read_texts(entry, findings)) return false;
  std::string all;
  for (const Node& item : entry.node.items) all += (all.empty() ? "" : "\n") + item.text;
  if (!all.empty())
    findings.warnings.push_back({entry.path, "the import was in doubt", all, topic_of(entry.key.path), true});
  return true;
}

/// The name of a file with TOML in it, which must be there (other_files).
bool read_imported(const Entry& entry, const std::string& folder, Findings& findings)
{
  if (entry.node.kind != NodeKind::text)
    return refuse(entry, entry.path, "`imported` must be text: the name of a file",
        fmt::format("Got {}.", describe_value(entry.node)), findings);
  const auto path = std::filesystem::path(folder) / entry.node.text;
  if (!std::filesystem::is_regular_file(path)) return true;  // check_files says so
  try {
    static_cast<void>(parse_toml(read_file(path.string())));
  } catch (const SyntaxError& error) {
    return refuse(entry, entry.path, fmt::format("`{}` is not valid TOML", entry.node.text),
        fmt::format("{}, line {}. It is the case as terp import wrote it: change case.toml and leave this file.",
            error.what(), error.place.line),
        findings);
  }
  return true;
}

KeyInfo texts_key(const char* path, const char* meaning)
{
  return {.path = path,
      .field =
          [](Case&, std::size_t) {
            return OwnForm{list_of_texts, read_texts, [] { return std::string(); }};
          },
      .meaning = meaning,
      .default_text = "none"};
}

}  // namespace

std::vector<KeyInfo> reference_keys()
{
  return {texts_key("reference.assumed",
              "what was assumed for the section, which the report page lists; `terp import` writes it"),
      texts_key("reference.assumed_nl", "the same in Dutch, for the page in Dutch"),
      texts_key("reference.doubts_nl",
          "the texts of `reference.doubts` in Dutch, for the page in Dutch: as many, in the same order. Else the page "
          "has those in English"),
      {.path = "reference.imported",
          .field =
              [](Case& c, std::size_t) {
                return OwnForm{"text",
                    [&folder = c.folder](const Entry& e, Findings& f) { return read_imported(e, folder, f); },
                    [] { return std::string(); }};
              },
          .meaning = "name of the file with the case as `terp import` wrote it, beside this one: `terp check` and the "
                     "report page name each value that you changed since",
          .default_text = "none"},
      {.path = "reference.doubts",
          .field =
              [](Case&, std::size_t) {
                return OwnForm{list_of_texts, read_doubts, [] { return std::string(); }};
              },
          .meaning = "what speaks against the section, which every command that reads the case repeats as a "
                     "warning; `terp import` writes it. Take out what you have looked at",
          .default_text = "none"},
      {.path = "reference.slip_planes",
          .field =
              [](Case& c, std::size_t) {
                std::vector<SlipPlaneCase>& planes = c.slip_planes;
                return OwnForm{
                    "a list of tables { name = \"...\", method = \"...\", factor_of_safety = F, line = [[x, y], ...] }",
                    [&planes](const Entry& e, Findings& f) { return read_slip_planes(e, f, planes); },
                    [&planes] { return slip_planes_text(planes); }};
              },
          .unit = "m",
          .meaning =
              "slip planes that another method found, which the report page draws over the slip surface; method and "
              "factor_of_safety may be left out. With su = [[x, y, S_u], ...], the undrained strength [Pa] that it "
              "took, `terp check` compares the strength of the soil",
          .default_text = "none"}};
}

}  // namespace terp
