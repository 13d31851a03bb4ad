// Arrays in the file format of numpy: several .npy in one .npz, a zip without compression.
// Not for: which arrays (export).
#pragma once

#include "base/types.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace terp {

/// Builds the bytes of an .npz file. Arrays are little-endian and in row-major order.
class NpzFile {
 public:
  void add(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const Real> values);
  void add(const std::string& name, const std::vector<std::int64_t>& shape, std::span<const std::int64_t> values);
  /// The whole file. Throws std::length_error beyond 4 GB, the limit of a plain zip.
  std::string bytes() const;

 private:
  std::vector<std::pair<std::string, std::string>> members_;  ///< name and bytes of each .npy
};

}  // namespace terp
