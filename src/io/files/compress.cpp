// Compression is one call, since zlib bounds the size of the result beforehand. Decompression goes in parts, since that
// size is not known. zlib verifies the checksum of the stream, so one that is damaged or cut short ends with another
// status than Z_STREAM_END.

#include "io/files/compress.hpp"

#include "math/errors.hpp"

#include <stdexcept>

#include <zlib.h>

namespace terp {
namespace {

constexpr std::size_t most_bytes = 4'000'000'000;  // of one stream: zlib counts what it is given with 32 bits
constexpr int gzip_window = 15 + 16;               // 32 kB window; 16: with the header of gzip (zlib.h, deflateInit2)

Bytef* input_of(std::string_view bytes) { return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); }

}  // namespace

std::string gzip(std::string_view bytes, int level)
{
  if (bytes.size() > most_bytes) throw std::length_error("more than 4 GB in one stream");
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, gzip_window, 9, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = input_of(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);  // ends the stream: there is room for it
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string gunzip(std::string_view stream_bytes)
{
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  stream.next_in = input_of(stream_bytes);
  stream.avail_in = static_cast<uInt>(stream_bytes.size());
  std::string out, part(1 << 18, '\0');
  int status = Z_OK;
  while (status == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = static_cast<uInt>(part.size());
    status = inflate(&stream, Z_NO_FLUSH);
    out.append(part, 0, part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END) throw FileError("the compressed bytes are damaged or cut short");
  return out;
}

std::string base64(std::string_view bytes)
{
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j) text += k + j <= bytes.size() ? letters[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

}  // namespace terp
