// Letters of a DXF text. Up to the release of 2004 they are in a code page of the header, from 2007 on in UTF-8; any
// may also stand as \U+XXXX. Not for: what the text says (dxf_file.hpp).
#pragma once

#include <string>
#include <string_view>

namespace terp {

/// The text in UTF-8. What is UTF-8 already stays. Bytes of a code page are its letters; an empty name is that of
/// "ANSI_1252". Of a page that is not known each byte above 0x7F is U+FFFD.
std::string dxf_letters(std::string_view text, std::string_view code_page);

/// The letters of the bytes 0x80 to 0xFF; empty: the page is not known. name: of $DWGCODEPAGE, "ANSI_1252", "dos850".
std::u16string_view letters_of_code_page(std::string_view name);

}  // namespace terp
