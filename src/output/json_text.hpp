// Writes JSON piece by piece, for documents too large or too regular for a tree of values.
// Not for: reading JSON (summary_json).
#pragma once

#include "base/types.hpp"

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace terp {

/// Commas and quotation marks come by themselves. A number that is not finite becomes null. Text is UTF-8; "<" is
/// written
/// "\u003c", so that the document may stand inside a <script> of a page, whatever its texts hold.
class JsonText {
 public:
  JsonText& begin_object() { return open('{'); }
  JsonText& end_object() { return close('}'); }
  JsonText& begin_array() { return open('['); }
  JsonText& end_array() { return close(']'); }
  JsonText& key(std::string_view name);

  JsonText& value(Real number);
  JsonText& value(bool truth) { return put(truth ? "true" : "false"); }
  JsonText& value(std::integral auto number) { return put(std::to_string(number)); }
  JsonText& value(std::string_view text);
  JsonText& value(const char* text) { return value(std::string_view(text)); }
  JsonText& value(const std::string& text) { return value(std::string_view(text)); }
  JsonText& value(const std::optional<Real>& number) { return number ? value(*number) : null(); }
  JsonText& null() { return put("null"); }
  /// A value that is JSON already.
  JsonText& raw(std::string_view json);

  JsonText& entry(std::string_view name, const auto& what) { return key(name).value(what); }

  const std::string& text() const { return text_; }

 private:
  JsonText& open(char bracket);
  JsonText& close(char bracket);
  JsonText& put(std::string_view token);
  void separate();

  std::string text_;
  bool first_ = true;  ///< nothing stands in the open bracket yet, or a key waits for its value
};

}  // namespace terp
