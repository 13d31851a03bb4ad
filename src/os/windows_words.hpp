// Texts and errors as Windows has them.
// Not for: files that Linux compiles; only NAME_win32.cpp includes this.
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// Of a text in UTF-8; what is no UTF-8 becomes U+FFFD.
std::wstring wide(std::string_view text);

/// In UTF-8.
std::string narrow(std::wstring_view text);

/// errno for an error of Windows (GetLastError).
int errno_of(unsigned long error);

/// What Windows says about its error, in one line.
std::string words_of_error(unsigned long error);

}  // namespace terp
