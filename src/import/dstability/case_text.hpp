// A case folder before it is written: what case.toml says, with a comment for each value, and its text.
// Not for: where the values come from (case_folder.hpp, drawing_folder.hpp).
#pragma once

#include "math/sentence.hpp"
#include "model/bodies/polygon.hpp"

#include <string>
#include <utility>
#include <vector>

namespace terp {

/// A line `key = value  # comment`; the value as TOML has it.
struct CaseLine {
  std::string key, value, comment;
};

/// What the name of a body has that is in no file, after that of the layer above it.
inline constexpr const char* below_the_base = ", fill below the base";

struct CaseBodyText {
  std::string name, material, comment;  ///< name: empty: none
  Polygon polygon;                      ///< [m]
  std::vector<Polygon> holes;           ///< that no other body fills [m]
};

struct CaseMaterialText {
  std::string name, comment;
  std::vector<CaseLine> lines;
};

/// A table of its own: [water], [[water.situation]], [[load]], [[stage]], ...
struct CaseTableText {
  std::string header;   ///< with its brackets
  std::string comment;  ///< may have several lines; stands above it
  std::vector<CaseLine> lines;
};

struct SectionText {
  std::string title;
  std::vector<std::string> head;  ///< comments at the top of the file
  std::vector<CaseTableText> before;
  std::vector<CaseBodyText> bodies;
  std::vector<CaseMaterialText> materials;
  std::vector<CaseTableText> after;
};

/// Gives each body a name that no other has: its own, with a number where it is taken. A name is no number.
void name_bodies(std::vector<CaseBodyText>& bodies);

/// case.toml. Comments have question marks for control characters and for what is not UTF-8.
std::string text_of(const SectionText& text);

/// A text in quotes; control characters are spaces, what is not UTF-8 is U+FFFD.
std::string in_quotes(const std::string& text);

/// A number as short as it can be with ten decimals.
std::string number_text(Real value);

/// [[1.0, 2.0], ...], in lines of at most 120 columns that begin `indent` columns to the right, but for the first.
std::string list_text(const std::vector<std::vector<Real>>& rows, std::size_t indent, std::size_t first_column);

/// The same of places.
std::string places_text(const std::vector<Vec<2>>& places, std::size_t indent, std::size_t first_column);

/// A name that TOML takes as a key: lower case letters without accents, digits, _. Signs before numbers are the words
/// minus and plus; `otherwise` if nothing is left. Two names may have one key.
std::string key_of_name(const std::string& name, const std::string& otherwise = "soil");

struct CaseFolder {
  std::vector<std::pair<std::string, std::string>> files;  ///< name, contents; case.toml first
  std::vector<Sentence> notes;                             ///< what is worth a line on the terminal
};

}  // namespace terp
