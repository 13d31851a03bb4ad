// How a case file says that a parameter varies over the soil: a formula, or a table with the name of a kind. A kind of
// field is one entry of the table in field_kinds.cpp. docs/strength.md.
// Not for: the values themselves (model/soils/soil_fields).
#pragma once

#include "io/case/keys.hpp"
#include "io/case/values.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace terp {

/// What a field is read with.
struct FieldContext {
  Entry entry;                ///< key: of the parameter, its unit and range; node and path: of the field
  const std::string& folder;  ///< of the case file, for the names of files
  Findings& findings;
  FieldNeeds& needs;  ///< filled
};

struct FieldKind {
  std::string_view name;     ///< "depth": the key that tells it from others
  std::string_view form;     ///< "{ depth = [[d, value], ...] }"
  std::string_view meaning;  ///< for `terp explain field`
  std::vector<std::string_view> options;
  /// value: of the key `name`; none, with a problem added, if it is not allowed.
  std::optional<FieldValue> (*read)(const Node& value, const FieldContext& context);
};

const std::vector<FieldKind>& field_kinds();

/// True of a text that is meant as a formula: it does not begin with a number and a unit.
bool is_formula(const Node& node);

/// A number, a formula or a table of one kind, as the value at a place; none, with a problem added, if it is neither.
std::optional<FieldValue> read_field(const FieldContext& context);

/// Adds a problem of the field.
std::nullopt_t refuse_field(const FieldContext& context, const std::string& path, std::string what, std::string detail);

/// Adds a problem for each key of the table that has another name. True: there are some.
bool refuse_unknown_keys(const Node& table, const std::vector<std::string>& names, const FieldContext& context);

/// The same key with another unit, range and usual range.
KeyInfo key_like(const KeyInfo& key, std::string_view unit, Range range, Range usual = any_number);

/// The field as text, on which resuming decides whether the case is the same; files by what is in them.
std::string field_text(const Node& node, const std::string& folder);

/// Whether a table `shansep` has a key of that name.
bool is_key_of_shansep(std::string_view name);

/// What `terp explain field` prints.
std::string describe_field_kinds();

}  // namespace terp
