// A disk of a given size that a test of output or of the program may fill.
#pragma once

#include "support/paths.hpp"

#include <sys/mount.h>

namespace terp::test {

/// A tmpfs of n_bytes in a scratch folder; mounting needs the rights of root, so ask `is_there` first.
class SmallDisk {
 public:
  explicit SmallDisk(long n_bytes)
  {
    const std::string options = "size=" + std::to_string(n_bytes);
    is_there_ = ::mount("none", path().c_str(), "tmpfs", 0, options.c_str()) == 0;
  }
  ~SmallDisk()
  {
    if (is_there_) ::umount2(path().c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_there() const { return is_there_; }
  const std::string& path() const { return folder_.path(); }

  void fill() const
  {
    std::ofstream out(path() + "/filler", std::ios::binary);
    const std::string block(4096, 'x');
    while (out.write(block.data(), 4096).flush()) {
    }
  }

 private:
  ScratchFolder folder_;
  bool is_there_ = false;
};

}  // namespace terp::test
