// npz files, as numpy itself reads them.
#include "results/npz.hpp"

#include "output/files.hpp"
#include "support/paths.hpp"

#include <cstdio>

#include <gmock/gmock.h>

namespace terp {
namespace {

/// What numpy has to say.
std::string told_by_python(const std::string& path)
{
  const std::string command = "/usr/bin/python3 -c \"import numpy as np, zipfile\nassert zipfile.ZipFile('" + path +
                              "').testzip() is None\na = np.load('" + path +
                              "')\nprint(sorted(a), a['x'].shape, a['x'].dtype, a['x'].tolist(), a['id'].tolist(), "
                              "a['time'].shape, float(a['time']))\" 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  pclose(pipe);
  return text;
}

TEST(Npz, IsReadByNumpyWithNamesShapesAndValues)
{
  const test::ScratchFolder scratch;
  const std::string path = scratch.path() + "/a.npz";
  NpzFile file;
  const std::vector<Real> x{0.1, 0.2, 0.3, 1e-300, -5.0, 6.5};
  const std::vector<std::int64_t> id{7, -8, 9007199254740993};
  const Real time = 0.25;
  file.add("x", {3, 2}, x);
  file.add("id", {3}, id);
  file.add("time", {}, std::span(&time, 1));
  write_file_atomically(path, file.bytes());
  EXPECT_EQ(told_by_python(path),
      "['id', 'time', 'x'] (3, 2) float64 [[0.1, 0.2], [0.3, 1e-300], [-5.0, 6.5]] [7, -8, 9007199254740993] () "
      "0.25\n");
}

TEST(Npz, EqualArraysGiveEqualBytes)
{
  const std::vector<Real> x{1.0, 2.0};
  NpzFile a, b;
  a.add("x", {2}, x);
  b.add("x", {2}, x);
  EXPECT_EQ(a.bytes(), b.bytes());
  EXPECT_EQ(a.bytes().substr(0, 4), "PK\x03\x04");
}

}  // namespace
}  // namespace terp
