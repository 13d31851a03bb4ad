// Each of thousands of damaged gmsh files gives a mesh that passes the checks, or a MeshError: no crash, no hang.
#include "model/meshes/check_mesh.hpp"
#include "model/meshes/msh_text.hpp"
#include "support/process.hpp"
#include "support/random.hpp"

namespace damaged_files_test {

const std::string files[] = {text_of(two_layers("41")), text_of(two_layers("41_binary"))};

/// True if the text was read. Anything but MeshError fails the test.
bool is_read(const std::string& text)
{
  try {
    check_mesh(read_gmsh_text("m.msh", text));
    return true;
  } catch (const MeshError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 5), "m.msh");
    return false;
  }
}

TEST(DamagedFiles, CutOffAnywhereAreRefused)
{
  for (const std::string& whole : files) {
    ASSERT_TRUE(is_read(whole));
    const std::size_t end = whole.rfind("$EndElements") + std::string("$EndElements").size();
    for (std::size_t n = 0; n < end; n += 3) EXPECT_FALSE(is_read(whole.substr(0, n))) << "cut off at byte " << n;
  }
}

TEST(DamagedFiles, WithAWrongByteAreReadOrRefused)
{
  for (const std::string& whole : files) {
    Random random(5);
    for (std::size_t at = 0; at < whole.size(); at += 3) {
      std::string text = whole;
      text[at] = static_cast<char>(random.below(256));
      is_read(text);
      text[at] = static_cast<char>(whole[at] ^ (1 << random.below(8)));
      is_read(text);
    }
  }
}

TEST(DamagedFiles, WithAPieceMissingOrDoubledAreReadOrRefused)
{
  for (const std::string& whole : files) {
    Random random(6);
    const auto size = static_cast<Index>(whole.size());
    for (int trial = 0; trial < 1000; ++trial) {
      const Index from = random.below(size), n = 1 + random.below(60), to = random.below(size);
      is_read(std::string(whole).erase(from, n));
      is_read(std::string(whole).insert(to, whole.substr(from, n)));
    }
  }
}

}  // namespace damaged_files_test
