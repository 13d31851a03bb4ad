// Files as they are read: the whole content, or an error that names the path.
// Not for: files that are there whole or not at all (io/files/files.hpp).
#pragma once

#include <string>
#include <string_view>
#include <system_error>

namespace terp {

/// Throws FileError "cannot <doing> <path>: <the system's reason>". error_number: errno of the failed call.
[[noreturn]] void throw_file_error(std::string_view doing, const std::string& path, int error_number);
[[noreturn]] void throw_file_error(std::string_view doing, const std::string& path, const std::error_code& error);

/// Throws FileError if a folder, pipe or device stands in the place of a file: a pipe would be waited for without end.
void check_is_file(const std::string& path);

/// Throws FileError with the system's reason if a file may not be read, as for want of permission.
void check_readable(const std::string& path);

/// The whole content of a file.
std::string read_file(const std::string& path);

}  // namespace terp
