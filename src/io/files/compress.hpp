// Compressed bytes, their checksum, and bytes as text. Only compress.cpp includes zlib.
// Not for: the compression inside HDF5 files, which is HDF5's own.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace terp {

/// A gzip stream (RFC 1952) with no name and no time in it: equal bytes give equal streams. Throws
/// std::length_error for more than 4 GB.
std::string gzip(std::string_view bytes, int level = 6);

/// The bytes of a gzip stream. Throws FileError if it is damaged.
std::string gunzip(std::string_view stream);

/// RFC 4648, with padding, without line breaks.
std::string base64(std::string_view bytes);

/// The memory of numbers as bytes.
template <class T>
std::string_view bytes_of(std::span<const T> values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace terp
