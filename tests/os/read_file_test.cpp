#include "os/read_file.hpp"
#include "math/errors.hpp"
#include "support/process.hpp"

namespace read_file_test {

TEST(ReadFile, GivesTheBytesOrThePathWithTheReason)
{
  const ScratchFolder scratch;
  const std::string path = scratch.path() + "/a", bytes("a\0\r\n\xff", 5);
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_EQ(read_file(path), bytes);
  EXPECT_EQ(
      refusal<FileError>([] { read_file("/no/such/file"); }), "cannot read /no/such/file: No such file or directory");
  EXPECT_THAT(
      refusal<FileError>([&] { read_file(scratch.path()); }), HasSubstr("a folder is in the place of the file"));
  EXPECT_EQ(refusal<FileError>([] { read_file("/proc/self/mem"); }), "cannot read /proc/self/mem: Input/output error");
}

}  // namespace read_file_test
