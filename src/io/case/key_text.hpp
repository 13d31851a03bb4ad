// What the table of keys says, in words: types, ranges, defaults, paths.
#pragma once

#include "io/case/keys.hpp"

#include <string>
#include <string_view>

namespace terp {

/// One function for each type that a Field may hold.
template <class... Ts>
struct Overload : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overload(Ts...) -> Overload<Ts...>;

Field example_of(const KeyInfo& key);  ///< of a case with one of everything: for the type, not for the value

std::string number_text(Real value, std::string_view unit);  ///< "2e+06 Pa", "0.3"
/// A number that was converted from another unit: six digits are more than what was typed has.
std::string converted_text(Real value, std::string_view unit);
std::string range_text(const Range& range, std::string_view unit);  ///< "more than 0 s"; empty if any number will do
std::string usual_text(const Range& usual, std::string_view unit);  ///< "500 to 5000 kg/m^3"
std::string type_text(const KeyInfo& key);                          ///< "a number", "true or false", "[x, y]"
std::string allowed_text(const KeyInfo& key);                       ///< "a number, more than 0 s" or the words
std::string value_text(
    const KeyInfo& key, const Field& field);   ///< what is kept there, exact: "0.1", "[5, 5]"; empty if nothing is
std::string default_text(const KeyInfo& key);  ///< from a default Case; empty if required or there is none

std::string quoted_list(const std::vector<std::string>& words);  ///< "none", "k0"
std::string plain_list(const std::vector<std::string>& words);   ///< none, k0

std::string last_part(std::string_view path);     ///< "body[].box" -> "box"; "body[]" -> "body"
std::string parent_path(std::string_view path);   ///< "body[].box" -> "body[]"; "material.NAME" -> ""
std::string topic_of(std::string_view path);      ///< "material.NAME.density" -> "material.density"
std::string header_of(std::string_view section);  ///< "time" -> "[time]"; "body[]" -> "[[body]]"

}  // namespace terp
