// Letters of code pages.
#pragma once

#include <string_view>

namespace terp {

/// The letters of the bytes 0x80 to 0xFF; empty: the page is not known. name: of $DWGCODEPAGE, "ANSI_1252", "dos850".
std::u16string_view letters_of_code_page(std::string_view name);

}  // namespace terp
