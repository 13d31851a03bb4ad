// Runs a harness over the files of its corpus, whole, cut off, with bytes changed and with pieces of other files:
// fuzzing for a compiler without libFuzzer.
//
// usage: replay NAME N FOLDER...      harness NAME; N inputs are made from each file
#include "replay.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

void try_input(const Harness& harness, const std::string& bytes)
{
  harness.input(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

/// A few bytes changed, a piece doubled, taken out or put in from another input, the end cut off.
std::string changed(std::string bytes, const std::string& other, std::mt19937& random)
{
  const auto any = [&](const std::string& text) { return random() % (text.size() + 1); };
  for (auto n = random() % 4; n > 0 && !bytes.empty(); --n)
    bytes[random() % bytes.size()] = static_cast<char>(random());
  switch (random() % 6) {
    case 0: bytes.insert(any(bytes), other.substr(any(other), random() % 40)); break;
    case 1: bytes.erase(any(bytes), random() % 40); break;
    case 2: bytes.insert(any(bytes), bytes.substr(any(bytes), random() % 40)); break;
    case 3: bytes.resize(any(bytes)); break;
    default: break;
  }
  return bytes;
}

std::vector<std::string> read_folders(char** begin, char** end)
{
  std::vector<std::filesystem::path> paths;
  for (char** folder = begin; folder != end; ++folder)
    for (const auto& entry : std::filesystem::directory_iterator(*folder)) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> inputs;
  for (const auto& path : paths) {
    std::ifstream file(path, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return inputs;
}

}  // namespace

int main(int argc, char** argv)
{
  if (argc < 4) return 2;
  const auto harness =
      std::find_if(harnesses().begin(), harnesses().end(), [&](const Harness& h) { return h.name == argv[1]; });
  if (harness == harnesses().end()) return 2;
  const int n_changed = std::atoi(argv[2]);
  const std::vector<std::string> inputs = read_folders(argv + 3, argv + argc);
  std::mt19937 random(1);  // the same inputs every time
  for (const std::string& input : inputs) {
    try_input(*harness, input);
    for (int k = 0; k < n_changed; ++k) try_input(*harness, changed(input, inputs[random() % inputs.size()], random));
  }
  std::printf("%zu inputs\n", inputs.size() * (1 + static_cast<std::size_t>(n_changed)));
  return inputs.empty() ? 1 : 0;
}
