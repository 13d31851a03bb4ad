// Against the published values of RFC 9923.
#include "math/checksum.hpp"
#include "support/test.hpp"

namespace checksum_test {

std::uint64_t hash_of(std::string_view text)
{
  Fnv1a hash;
  hash.add(text);
  return hash.value();
}

TEST(Checksum, IsTheFnv1aOfTheStandard)
{
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325u);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cu);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8u);
  EXPECT_EQ(Fnv1a().digits(), "cbf29ce484222325");
}

}  // namespace checksum_test
