// Reads the numbers of a gmsh mesh file one after the other, as text or as bytes, and says where it stands when one is
// wrong. Not for: what the numbers mean (msh_content.hpp).
#pragma once

#include "base/types.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace terp {

/// Bytes of a whole number in the binary form.
enum class Width { four = 4, eight = 8 };

class MshScanner {
 public:
  /// path: for messages. text: the whole file.
  MshScanner(std::string path, std::string text);

  /// From here on numbers are bytes in this machine's order (true), or text (false).
  void set_binary(bool binary) { binary_ = binary; }

  /// Name of the next line "$Name", empty at the end of the file. Text between sections is passed over.
  std::string next_section();
  /// Expects "$EndName".
  void end_section(const std::string& name);
  /// Goes on behind "$EndName", whatever the section holds.
  void skip_section(const std::string& name);

  /// what: of the number, for messages, e.g. "a node number".
  std::int64_t integer(Width width, const char* what);
  Real real(const char* what);
  /// Text in quotes on the current line.
  std::string quoted(const char* what);
  /// How many items follow, refused when they cannot be in the rest of the file. numbers: least numbers per item.
  std::int64_t count(Width width, int numbers, const char* what);
  /// Where the next number begins, in bytes from the start of the file.
  std::size_t at() const { return at_; }
  /// In text the line must end here; bytes have no lines.
  void end_record();

  /// Throws MeshError with path and line or byte of the number read last.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string_view rest() const { return std::string_view(text_).substr(at_); }
  std::string_view rest_of_line() const;
  void skip_blanks();
  std::string_view token(const char* what);
  template <class T>
  T bytes(const char* what);

  std::string path_, text_;
  std::size_t at_ = 0;    // next byte to read
  std::size_t last_ = 0;  // first byte of the number read last
  bool binary_ = false;
};

}  // namespace terp
