// Runs a harness over the files of its corpus, whole, cut off and with bytes changed: fuzzing for a compiler without libFuzzer.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);

namespace {

constexpr int n_changed = 20;  // inputs made from each file

void try_input(const std::string& bytes) { LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()); }

std::string changed(std::string bytes, std::mt19937& random)
{
  if (bytes.empty()) return bytes;
  const auto any = [&] { return random() % bytes.size(); };
  for (auto n = 1 + random() % 4; n > 0; --n) bytes[any()] = static_cast<char>(random());
  if (random() % 4 == 0) bytes.resize(any());
  return bytes;
}

}  // namespace

int main(int argc, char** argv)
{
  int n = 0;
  std::mt19937 random(1);  // the same inputs every time
  for (int k = 1; k < argc; ++k) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[k])) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      try_input(bytes);
      for (int trial = 0; trial < n_changed; ++trial) try_input(changed(bytes, random));
      n += 1 + n_changed;
    }
  }
  std::printf("%d inputs\n", n);
  return n > 0 ? 0 : 1;
}
