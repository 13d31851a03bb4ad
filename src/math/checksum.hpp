// The checksum of checkpoints, tables, cases and kept meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace terp {

/// FNV-1a, 64 bit, with its published offset basis and prime (RFC 9923).
class Fnv1a {
 public:
  void add(const void* data, std::size_t n_bytes)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < n_bytes; ++k) hash_ = (hash_ ^ bytes[k]) * 0x100000001b3u;
  }
  void add(std::int64_t value) { add(&value, sizeof value); }
  void add(std::string_view text) { add(text.data(), text.size()); }
  std::uint64_t value() const { return hash_; }
  std::string digits() const { return fmt::format("{:016x}", hash_); }  ///< 16, hexadecimal

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// 16 digits that depend on every character.
inline std::string digits_of(std::string_view text)
{
  Fnv1a hash;
  hash.add(text);
  return hash.digits();
}

}  // namespace terp
