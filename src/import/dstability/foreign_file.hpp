// What a file of a section is, by its content and its ending, and the way in for files of other programs.
// Not for: whether a D-Stability file or a drawing is sound (read_stix.hpp, drawing/dxf_file.hpp).
#pragma once

#include <string>
#include <string_view>

namespace terp {

enum class SectionFile { dstability, drawing, profile };

/// By its content, else by its ending. Throws InputError with what the file is and the way in for all others, and for
/// folders.
SectionFile kind_of_section(const std::string& path);

/// The same of a file that was read.
SectionFile kind_of_section(const std::string& path, std::string_view content);

}  // namespace terp
