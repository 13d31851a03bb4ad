// What a fault in the syntax of a case file was probably meant to be, and how it is written.
// Not for: what the keys mean. The parser's own words stay where none of this applies.
#pragma once

#include "io/case/document.hpp"

#include <optional>

namespace terp {

struct SyntaxAdvice {
  Place place;       ///< where the fault is; not always where the parser noticed it
  std::string what;  ///< "a number has a decimal point, no comma"
  std::string cure;  ///< "Write 0.2."
};

SyntaxAdvice advise_on_syntax(std::string_view text, const SyntaxError& error);

/// The cure of a number with commas and what stands behind it, as "8,5 kPa": both readings where there are two. None if
/// the text is no such number.
std::optional<std::string> advise_on_commas(std::string_view value);

/// Text in UTF-16, as some editors save it: with its mark, or with a zero in every second byte.
bool is_utf16(std::string_view text);

}  // namespace terp
