// Every key of a case file, each declared once: where it is kept, unit, range, meaning. Reading, checks, warnings and
// help all follow from these tables. Not for: what the keys contradict among each other (check_case.hpp).
#pragma once

#include "soil/laws/material.hpp"
#include "model/case/case.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace terp {

/// A choice from KeyInfo::words, kept as an enum: the index of the word.
struct WordField {
  std::function<int()> get;
  std::function<void(int)> set;
};
/// A number, or a field instead.
struct VaryingNumber {
  Real* value;
  std::function<void(ParameterField)> set;  ///< takes the field, whose number of the parameter is not set
  const ParameterField* field;              ///< that is set; or nullptr
  const std::string* folder;                ///< of the case file
};
struct NumberOrPair {
  Vec<2>* value;
};  ///< 0.1 means [0.1, 0.1]
struct CountOrPair {
  std::array<Index, 2>* value;
};  ///< 5 means [5, 5]
struct Box {
  std::vector<Vec<2>>* corners;
};  ///< two corners in the file, four in the case
struct BoxCorners {
  Vec<2>*low, *high;
};
struct PolygonField {
  std::vector<Vec<2>>* corners;
  bool keeps_order = false;  ///< otherwise turned counter-clockwise
};
struct PolygonList {
  std::vector<std::vector<Vec<2>>>* polygons;
};
struct Polyline {
  std::vector<Vec<2>>* places;
};
struct EdgesList {
  std::vector<EdgesCase>* sides;
};
struct VelocityPair {
  Vec<2>* value;
  VelocityField* at;  ///< filled instead if one of the two is a formula
};
struct NameList {
  std::vector<std::string>* names;
};
struct NamedPlaces {
  std::vector<std::pair<std::string, Vec<2>>>* places;
};

struct Entry;
struct Findings;
/// A value with a form of its own.
struct OwnForm {
  std::string type;                                   ///< what it is, in words
  std::function<bool(const Entry&, Findings&)> read;  ///< false, with a problem added, if it is not allowed
  std::function<std::string()> text;                  ///< how it reads back; empty: not given
};

/// Where a key is kept. Its type is the key's type.
using Field =
    std::variant<Real*, VaryingNumber, Index*, bool*, std::string*, Vec<2>*, WordField, NumberOrPair, CountOrPair, Box,
        BoxCorners, PolygonField, PolygonList, Polyline, EdgesList, VelocityPair, NameList, NamedPlaces, OwnForm>;

struct KeyInfo {
  std::string path;  ///< "time.end", "body[].box", "material.NAME.density", "boundary.SIDE.contact"
  std::function<Field(Case&, std::size_t)> field;  ///< in the body, refinement, material or side of that number
  std::string unit = "-";
  Range range = any_number;                       ///< of the number or of each of its numbers
  Range usual = any_number;                       ///< of |number|; outside, but not 0: warn
  std::vector<std::string> (*words)() = nullptr;  ///< allowed texts; none: any
  bool more_words = false;                        ///< of a case: texts that a check of the whole case allows, too
  bool required = false;
  std::string instead = "";       ///< key of the same section that may stand for it
  std::string required_for = "";  ///< where it is not always required: what needs it, in words
  bool may_be_infinite = false;
  bool in_stage = false;  ///< may change in a stage
  std::string meaning;
  std::string equation = "";
  std::string default_text = "";  ///< where it is empty, filled in from the structs of case.hpp
};

struct SectionInfo {
  std::string path;  ///< "time", "body[]", "material.NAME", "output.fields"
  std::string meaning;
  bool required = false;
};

const std::vector<KeyInfo>& all_keys();  ///< without those of the laws
const std::vector<SectionInfo>& all_sections();
std::vector<KeyInfo> keys_of_law(const MaterialType& law);  ///< as "material.NAME.eta"
std::vector<std::string> output_field_names();              ///< that output.fields.names may hold
std::vector<std::string> material_model_names();
const std::vector<std::string>& side_names();  ///< of the built-in rectangle

/// "material.clay"; of the two parts of a soil "material.clay.below".
std::string material_path(const MaterialCase& material);

const KeyInfo* find_key(std::string_view path);
const SectionInfo* find_section(std::string_view path);

/// Unit of the value at a path of a file, of one of its numbers too: "material.clay.eta", "body[0].box[1][0]"; empty
/// where the path is of no key.
std::string unit_at(std::string_view path);

/// Names that a section may hold: its keys, then the sections directly inside. "" is the file itself.
std::vector<std::string> names_in_section(std::string_view section);

}  // namespace terp
