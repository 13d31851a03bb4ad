// The checksum of checkpoints and journals.
#pragma once

#include <cstddef>
#include <cstdint>

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
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace terp
