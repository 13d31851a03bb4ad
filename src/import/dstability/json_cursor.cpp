// Each function that reads a key notes it as asked for, has() does not; what nobody asked for is reported as unknown.
// So a key that is read only in some cases must be passed over in the others. A fault gives a value that says nothing,
// and reading goes on, until StixNotes throws.

#include "import/dstability/json_cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace terp {
namespace {

constexpr std::size_t most_faults = 10;
constexpr Real farthest = 1e7;          // [m]; coordinates of national grids are below 1e6 m
constexpr std::size_t most_shown = 40;  // bytes of a text in a message

const JsonNode no_node{.kind = JsonKind::object};

/// What stands there, as a message shows it.
std::string shown(const JsonNode& node)
{
  if (node.kind == JsonKind::number) return fmt::format("the number {}", node.number);
  if (node.kind == JsonKind::text)
    return fmt::format(
        "the text \"{}{}\"", node.text.substr(0, most_shown), node.text.size() > most_shown ? "..." : "");
  return words_of(node.kind);
}

/// What programs write for a number that they do not have.
bool is_empty_number(const std::string& text)
{
  constexpr std::array<std::string_view, 5> words{"", "-", "NaN", "Infinity", "-Infinity"};
  return std::ranges::find(words, text) != words.end();
}

/// Where a key stands in `where`: "soils.json, Soils[0].Name".
std::string path_of_key(const std::string& where, std::string_view key)
{
  return fmt::format("{}{}{}", where, where.find(", ") == std::string::npos ? ", " : ".", key);
}

/// The place without the numbers of members and list entries: "scenarios/scenario.json, Stages[].Label".
std::string without_numbers(const std::string& where)
{
  std::string text;
  for (std::size_t k = 0; k < where.size(); ++k) {
    if (where[k] == '[' || (where[k] == '_' && where.find(".json", k) != std::string::npos)) {
      std::size_t end = k + 1;
      while (end < where.size() && std::isdigit(static_cast<unsigned char>(where[end])) != 0) ++end;
      if (where[k] == '[') text += '[';
      k = end - 1;
      continue;
    }
    text += where[k];
  }
  return text;
}

}  // namespace

void StixNotes::fault(const std::string& where, const std::string& what, const std::string& detail)
{
  faults_.push_back({.key = path_ + ", " + where, .what = what, .detail = detail, .topic = ""});
  if (faults_.size() >= most_faults) throw InputError(faults_);
}

void StixNotes::unknown_key(const std::string& where, const std::string& key)
{
  ++unknown_[path_of_key(without_numbers(where), key)];
}

std::vector<StixRemark> StixNotes::finish()
{
  if (!faults_.empty()) throw InputError(faults_);
  for (const auto& [where, n] : unknown_)
    remark_on_format(where, fmt::format("This key is not known to Terp and was not used{}.",
                                n == 1 ? std::string() : fmt::format(" ({} times)", n)));
  return std::move(remarks_);
}

bool JsonCursor::has(std::string_view key) const
{
  const JsonNode* const value = node_->find(key);
  return value != nullptr && value->kind != JsonKind::null;
}

const JsonNode* JsonCursor::find(const char* key)
{
  asked_.insert(key);
  return node_->find(key);
}

const JsonNode* JsonCursor::find(const char* key, JsonKind kind, const char* wanted)
{
  const JsonNode* const value = find(key);
  if (value == nullptr || value->kind == JsonKind::null) return nullptr;
  if (value->kind == kind) return value;
  fault(
      key, fmt::format("is not {}", wanted), fmt::format("Got {}. Correct the file, or save it anew.", shown(*value)));
  return nullptr;
}

Real JsonCursor::number(const char* key)
{
  const JsonNode* const value = find(key);
  if (value == nullptr || value->kind == JsonKind::null) return not_given;
  if (value->kind == JsonKind::number) return value->number;
  if (value->kind != JsonKind::text || !is_empty_number(value->text))
    fault(key, "is no number", fmt::format("Got {}. An empty number is \"NaN\" or null.", shown(*value)));
  return not_given;
}

Real JsonCursor::required(const char* key, Real unit)
{
  const JsonNode* const value = find(key);
  if (value != nullptr && value->kind == JsonKind::number) return unit * value->number;
  fault(key, "needs a number", fmt::format("Got {}.", value == nullptr ? "nothing" : shown(*value)));
  return 0.0;
}

bool JsonCursor::flag(const char* key)
{
  const JsonNode* const value = find(key, JsonKind::boolean, "true or false");
  return value != nullptr && value->number != 0.0;
}

std::string JsonCursor::text(const char* key)
{
  const JsonNode* const value = find(key, JsonKind::text, "a text");
  return value == nullptr ? std::string() : value->text;
}

std::string JsonCursor::id(const char* key)
{
  const JsonNode* const value = find(key, JsonKind::text, "a text");
  if (value != nullptr && !value->text.empty()) return value->text;
  if (!has(key) || value != nullptr) fault(key, "needs an id", "Got nothing. Ids link the parts of the file.");
  return {};
}

JsonCursor JsonCursor::object(const char* key)
{
  const JsonNode* const value = find(key, JsonKind::object, "an object");
  return {value == nullptr ? no_node : *value, path_of_key(where_, key), *notes_};
}

std::vector<JsonCursor> JsonCursor::list(const char* key)
{
  std::vector<JsonCursor> entries;
  const JsonNode* const value = find(key, JsonKind::list, "a list");
  if (value == nullptr) return entries;
  entries.reserve(value->members.size());
  for (const auto& [none, entry] : value->members) {
    const std::string where = fmt::format("{}[{}]", path_of_key(where_, key), entries.size());
    if (entry.kind != JsonKind::object)
      notes_->fault(where, "is not an object", fmt::format("Got {}.", shown(entry)));
    else
      entries.emplace_back(entry, where, *notes_);
  }
  return entries;
}

Vec<2> JsonCursor::as_place()
{
  const Vec<2> place{required("X"), required("Z")};
  for (std::size_t k = 0; k < 2; ++k)
    if (std::abs(place[k]) > farthest)
      fault(k == 0 ? "X" : "Z", "is out of range",
          fmt::format("Got {} m, at most {:g} m either way.", place[k], farthest));
  return place;
}

Vec<2> JsonCursor::place(const char* key)
{
  if (!has(key)) fault(key, "needs a place", "Got nothing; an object with X and Z in m.");
  return has(key) ? object(key).as_place() : Vec<2>{};
}

StixLine JsonCursor::line(const char* key, std::size_t least)
{
  StixLine places;
  for (JsonCursor& entry : list(key)) places.push_back(entry.as_place());
  if (places.size() < least)
    fault(key, "has too few places", fmt::format("Got {}, at least {}.", places.size(), least));
  return places;
}

Vec<2> JsonCursor::place_if_given(const char* key)
{
  JsonCursor place = object(key);
  return {place.number("X"), place.number("Z")};
}

StixLine JsonCursor::places_given(const char* key)
{
  StixLine places;
  for (JsonCursor& entry : list(key))
    if (const Vec<2> place{entry.number("X"), entry.number("Z")}; !std::isnan(place[0] + place[1]))
      places.push_back(place);
  return places;
}

StixLine JsonCursor::line_to_the_right(const char* key)
{
  StixLine places = line(key, 0);
  if (!places.empty() && places.back()[0] < places.front()[0]) std::ranges::reverse(places);
  if (!std::ranges::is_sorted(places, {}, [](const Vec<2>& p) { return p[0]; }))
    remark(filled<reported_texts::runs_back>());
  return places;
}

void JsonCursor::tell_unknown() const
{
  for (const auto& [key, value] : node_->members)
    if (!asked_.contains(key)) notes_->unknown_key(where_, key);
}

void JsonCursor::fault(const char* key, const std::string& what, const std::string& detail) const
{
  notes_->fault(path_of_key(where_, key), what, detail);
}

}  // namespace terp
