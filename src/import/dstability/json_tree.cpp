// Values that are not wanted are never made. Pointers to open nodes stay valid as a node gets no further member while
// one of its members is open.

#include "import/dstability/json_tree.hpp"

#include "math/errors.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace terp {
namespace {

constexpr std::size_t most_levels = 64;  // D-Stability writes about ten
constexpr std::size_t most_keys = 1000;  // in one object; D-Stability writes about fifty

/// Where a byte stands in the text, for a message.
std::string line_of(std::string_view text, std::size_t byte)
{
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("line {}, column {}", line, before.size() - start + 1);
}

class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, const std::string& where, const std::vector<std::string>& skipped)
      : text_(text), where_(where), skipped_(skipped)
  {
  }
  JsonNode take() { return std::move(root_); }

  bool null() override { return put({}); }
  bool boolean(bool value) override { return put({.kind = JsonKind::boolean, .number = value ? 1.0 : 0.0}); }
  bool number_integer(number_integer_t value) override { return put_number(static_cast<Real>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return put_number(static_cast<Real>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return put_number(value); }
  bool string(string_t& value) override { return put({.kind = JsonKind::text, .text = std::move(value)}); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool start_array(std::size_t) override { return open(JsonKind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override
  {
    const JsonNode& object = *open_.back();
    if (skip_level_ == 0 && object.find(name) != nullptr)
      fail(fmt::format("has the key `{}` twice in one object", name), "Which one holds cannot be known.");
    if (object.members.size() >= most_keys)
      fail("has an object with too many keys", fmt::format("At most {}.", most_keys));
    key_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override
  {
    const std::string_view words = error.what();
    const std::size_t text = words.find("; ");  // what follows the library's own name and place of the error
    fail("is no sound JSON",
        fmt::format("{}: {}. Save the file anew in D-Stability.", line_of(text_, position == 0 ? 0 : position - 1),
            text == std::string_view::npos ? words.substr(words.rfind(": ") + 2) : words.substr(text + 2)));
  }

 private:
  [[noreturn]] void fail(const std::string& what, const std::string& detail) const
  {
    throw InputError({.key = where_, .what = what, .detail = detail, .topic = ""});
  }
  /// Where the next value goes; null while a value is skipped.
  JsonNode* place()
  {
    if (skip_level_ > 0) return nullptr;
    if (open_.empty()) return &root_;
    JsonNode& parent = *open_.back();
    if (parent.kind == JsonKind::object && std::ranges::find(skipped_, key_) != skipped_.end()) return nullptr;
    return &parent.members.emplace_back(parent.kind == JsonKind::object ? key_ : std::string(), JsonNode{}).second;
  }
  bool put(JsonNode value)
  {
    if (JsonNode* const to = place()) *to = std::move(value);
    return true;
  }
  bool put_number(Real value)
  {
    if (!std::isfinite(value)) fail("has a number that is too large", "At most 1.8e308.");
    return put({.kind = JsonKind::number, .number = value});
  }
  bool open(JsonKind kind)
  {
    if (++level_ > most_levels) fail("has too many levels", fmt::format("At most {}.", most_levels));
    if (JsonNode* const to = place()) {
      to->kind = kind;
      open_.push_back(to);
    } else
      ++skip_level_;
    return true;
  }
  bool close()
  {
    --level_;
    if (skip_level_ > 0)
      --skip_level_;
    else
      open_.pop_back();
    return true;
  }

  std::string_view text_;
  const std::string& where_;
  const std::vector<std::string>& skipped_;
  JsonNode root_;
  std::vector<JsonNode*> open_;  ///< a parent grows only while none of its children is open
  std::string key_;
  std::size_t level_ = 0, skip_level_ = 0;
};

}  // namespace

const JsonNode* JsonNode::find(std::string_view key) const
{
  const auto found = std::ranges::find_if(members, [key](const auto& m) { return m.first == key; });
  return kind != JsonKind::object || found == members.end() ? nullptr : &found->second;
}

const char* words_of(JsonKind kind)
{
  switch (kind) {
    case JsonKind::null: return "null";
    case JsonKind::boolean: return "true or false";
    case JsonKind::number: return "a number";
    case JsonKind::text: return "a text";
    case JsonKind::list: return "a list";
    case JsonKind::object: return "an object";
  }
  return "";
}

JsonNode read_json(std::string_view text, const std::string& where, const std::vector<std::string>& skipped)
{
  TreeBuilder builder(text, where, skipped);
  nlohmann::json::sax_parse(text.begin(), text.end(), &builder);  // a byte order mark is passed over by the library
  return builder.take();
}

}  // namespace terp
