#include "io/files/compress.hpp"
#include "math/errors.hpp"
#include "support/test.hpp"

namespace compress_test {

TEST(Compress, ComesBackToTheByte)
{
  std::string bytes;
  for (std::uint32_t k = 0; k < 1'000'000; ++k) bytes += static_cast<char>(k * k >> 7);
  for (const std::string& text : {bytes, std::string(), std::string("\0\0a", 3)}) EXPECT_EQ(gunzip(gzip(text)), text);
}

TEST(Compress, RefusesMoreThanAStreamCanCount)
{
  const char start = '\0';  // the rest is not looked at
  EXPECT_THROW(static_cast<void>(gzip(std::string_view(&start, 5'000'000'000))), std::length_error);
}

TEST(Compress, EqualBytesGiveEqualStreamsOfGzip)
{
  const std::string stream = gzip("soil soil soil soil soil soil soil soil");
  EXPECT_EQ(stream, gzip("soil soil soil soil soil soil soil soil"));
  EXPECT_EQ(stream.substr(0, 3), "\x1f\x8b\x08");        // RFC 1952
  EXPECT_EQ(stream.substr(4, 4), std::string(4, '\0'));  // no time
  EXPECT_LT(stream.size(), 39);
}

TEST(Compress, DamagedBytesAreRefused)
{
  std::string stream = gzip("a column of soil");
  EXPECT_THROW(gunzip(stream.substr(0, stream.size() - 1)), FileError);
  stream[stream.size() / 2] ^= 4;
  EXPECT_THROW(gunzip(stream), FileError);
}

TEST(Compress, Base64IsThatOfRfc4648)
{
  const char* pairs[][2] = {{"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="},
      {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : pairs) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace compress_test
