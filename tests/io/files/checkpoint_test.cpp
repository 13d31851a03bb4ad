#include "io/files/checkpoint.hpp"
#include "io/files/hdf5_file.hpp"
#include "io/files/run_folder.hpp"
#include "io/files/samples.hpp"
#include "io/files/small_disk.hpp"
#include "model/case/method_form.hpp"
#include "support/process.hpp"
#include "support/scratch.hpp"
#include "support/leaks.hpp"
#include <fmt/format.h>

namespace checkpoint_test {

bool same(const StateImage& a, const StateImage& b)
{
  const auto equal = [](const NamedArray& x, const NamedArray& y) {
    return x.name == y.name && x.shape == y.shape && x.values == y.values;
  };
  return a.time == b.time && a.step == b.step &&
         std::equal(a.arrays.begin(), a.arrays.end(), b.arrays.begin(), b.arrays.end(), equal);
}

std::string write_sample(const std::string& folder, std::int64_t step)
{
  const std::string path = path_in(folder, checkpoint_file(step));
  CheckpointWriter(path).append(sample_image(step));
  return path;
}

/// Changes a file without care, as a failing disk does.
void flip_bit(const std::string& path, std::size_t k)
{
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(static_cast<std::streamoff>(k));
  const char byte = static_cast<char>(file.get() ^ 0x10);
  file.seekp(static_cast<std::streamoff>(k));
  file.put(byte);
}

void cut_in_half(const std::string& path) { std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2); }

struct Checkpoint : ScratchTest {
  const std::string path = path_in(folder, "a.h5");
};

TEST_F(Checkpoint, ComesBackToTheBit)
{
  const StateImage image = read_checkpoint(write_sample(folder, 1234));
  EXPECT_TRUE(same(image, sample_image(1234)));
  EXPECT_TRUE(std::signbit(std::get<std::vector<Real>>(image.arrays[0].values)[2]));  // -0.0
}

TEST_F(Checkpoint, LeavesNoTemporaryFile)
{
  EXPECT_FALSE(std::filesystem::exists(temporary_name(write_sample(folder, 1))));
}

TEST_F(Checkpoint, TheChecksumOfNoArraysIsThatOfTheTwoNumbers)
{
  // FNV-1a of 16 zero bytes, by hand: basis * prime^16 modulo 2^64.
  std::uint64_t expected = 0xcbf29ce484222325u;
  for (int k = 0; k < 16; ++k) expected *= 0x100000001b3u;
  EXPECT_EQ(checksum_of(StateImage{}), expected);
}

TEST_F(Checkpoint, TheChecksumSeesNamesShapesAndValues)
{
  const StateImage image = sample_image(5);
  StateImage renamed = image, reshaped = image, altered = image;
  renamed.arrays[0].name = "y";
  reshaped.arrays[0].shape = {4, 1};
  std::get<std::vector<Real>>(altered.arrays[0].values)[2] = 0.0;  // was -0.0: one bit
  for (const auto& other : {renamed, reshaped, altered}) EXPECT_NE(checksum_of(other), checksum_of(image));
}

TEST_F(Checkpoint, ThatIsTruncatedIsRefusedByName)
{
  const std::string path = write_sample(folder, 1);
  cut_in_half(path);
  EXPECT_THAT(
      file_error_of([&] { read_checkpoint(path); }), AllOf(HasSubstr("cannot read " + path), HasSubstr("truncated")));
}

TEST_F(Checkpoint, WhoseNumbersWereAlteredIsRefusedByName)
{
  const std::string path = write_sample(folder, 1);
  {
    Hdf5File file(path, Hdf5File::Mode::change);
    file.set_real("/", "time", 0.0010000001);
    file.close();
  }
  EXPECT_EQ(file_error_of([&] { read_checkpoint(path); }),
      "cannot use " + path + ": its checksum does not match; the file was altered or damaged");
}

TEST_F(Checkpoint, WithAnyByteFlippedIsRefusedOrComesBackToTheBit)
{
  const std::string path = write_sample(folder, 1);
  const std::size_t n_bytes = std::filesystem::file_size(path);
  int n_refused = 0;
  for (std::size_t k = 0; k < n_bytes; ++k) {
    flip_bit(path, k);
    try {
      EXPECT_TRUE(same(read_checkpoint(path), sample_image(1))) << "byte " << k;
    } catch (const FileError& error) {
      EXPECT_THAT(error.what(), HasSubstr(path));
      ++n_refused;
    }
    flip_bit(path, k);  // back
  }
  EXPECT_GT(n_refused, 64 + 16);  // at least the numbers of the four arrays
}

TEST_F(Checkpoint, OfAnotherFormatNamesBothVersions)
{
  const std::string path = write_sample(folder, 1);
  for (const int version : {7, 99}) {
    Hdf5File file(path, Hdf5File::Mode::change);
    file.set_integers("/", "format_version", {version});
    file.close();
    EXPECT_THAT(file_error_of([&] { read_checkpoint(path); }),
        AllOf(HasSubstr(fmt::format("checkpoint format {}", version)),
            HasSubstr("reads format 8\n  Go on with the terp that wrote it, or solve the case anew."),
            EndsWith(version < 8 ? "anew.\n  " + std::string(defaults_before) : "anew.")));
  }
}

TEST_F(Checkpoint, KeepsWhatTheRunBeganWithUnderItsChecksum)
{
  StateImage image = sample_image(3);
  image.case_record = "time.end = 0.2\nmaterial.clay.eta = 4.5\n";
  image.tables = "ledger.csv = 85944171f73967e8\n";
  CheckpointWriter(path, image.case_record, image.tables).append(image);
  EXPECT_EQ(read_checkpoint(path).case_record, image.case_record);
  EXPECT_EQ(read_checkpoint(path).tables, image.tables);
  const std::string bytes = text_of(path);
  const std::size_t at = bytes.find("eta = 4.5");
  ASSERT_NE(at, std::string::npos);
  write_file_atomically(path, std::string(bytes).replace(at, 9, "eta = 4.6"));
  EXPECT_THAT(file_error_of([&] { read_checkpoint(path); }), HasSubstr("its checksum does not match"));
  write_file_atomically(path, std::string(bytes).replace(bytes.find("85944171f73967e8"), 1, "9"));
  EXPECT_THAT(file_error_of([&] { read_checkpoint(path); }), HasSubstr("its checksum does not match"));
}

TEST_F(Checkpoint, AnArrayWhoseShapeDoesNotFitIsRefused)
{
  const StateImage image{0.0, 0, {{"x", {3}, std::vector<Real>{1.0}}}};
  EXPECT_THAT(file_error_of([&] { CheckpointWriter(path).append(image); }),
      HasSubstr("array `x` holds 1 values, its shape says 3"));
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Checkpoint, TheNewestGoodOneIsFoundAndTheBadOnesAreReported)
{
  write_sample(folder, 100);
  const std::string good = write_sample(folder, 200), bad = write_sample(folder, 300);
  const std::string no_hdf5 = path_in(folder, checkpoint_file(1000000000));  // ten digits: later, not earlier
  cut_in_half(bad);
  write_file_atomically(no_hdf5, "");
  const CheckpointSearch search = newest_good_checkpoint(folder);
  EXPECT_EQ(search.path, good);
  ASSERT_TRUE(search.image);
  EXPECT_EQ(search.image->step, 200);
  ASSERT_EQ(search.skipped.size(), 2u);
  EXPECT_EQ(search.skipped[0].path, no_hdf5);
  EXPECT_EQ(search.skipped[1].path, bad);
  EXPECT_THAT(search.skipped[1].reason, HasSubstr("truncated"));
}

TEST_F(Checkpoint, ALinkToItselfDoesNotHideTheOlderOnes)
{
  write_sample(folder, 7);
  std::filesystem::create_symlink(checkpoint_file(9), path_in(folder, checkpoint_file(9)));
  EXPECT_EQ(newest_good_checkpoint(folder).image->step, 7);
}

TEST_F(Checkpoint, WhoseArraysAreMoreThanItsFileCanHoldIsRefused)
{
  StateImage image{0.0, 1, {{"x", {1000}, std::vector<Real>(1000, 1.5)}}};
  const std::string path = path_in(folder, checkpoint_file(1));
  CheckpointWriter(path).append(image);
  std::string names;
  for (int k = 0; k < 8000; ++k) names += "x\n";  // 64 MB
  Hdf5File(path, Hdf5File::Mode::change).set_text("/arrays", "names", names);
  EXPECT_EQ(file_error_of([&] { read_checkpoint(path); }),
      "cannot read " + path + ": its values are more than it can hold, at /arrays/x");
}

TEST_F(Checkpoint, AFolderWithoutAGoodOneGivesNone)
{
  EXPECT_FALSE(newest_good_checkpoint(folder).image);
  EXPECT_THAT(
      file_error_of([] { newest_good_checkpoint("/no/such"); }), HasSubstr("cannot open the run folder /no/such: "));
}

TEST_F(Checkpoint, OnlyTheNewestAreKept)
{
  for (const std::int64_t step : {100, 300, 200}) write_sample(folder, step);
  remove_old_checkpoints(folder, 0);
  EXPECT_TRUE(std::filesystem::exists(path_in(folder, checkpoint_file(100))));
  remove_old_checkpoints(folder, 2);
  EXPECT_FALSE(std::filesystem::exists(path_in(folder, checkpoint_file(100))));
  EXPECT_TRUE(std::filesystem::exists(path_in(folder, checkpoint_file(200))));
  remove_checkpoints_after(folder, 200);
  EXPECT_FALSE(std::filesystem::exists(path_in(folder, checkpoint_file(300))));
  EXPECT_TRUE(std::filesystem::exists(path_in(folder, checkpoint_file(200))));
}

TEST_F(Checkpoint, AFullDiskLeavesTheEarlierOneAndNoHalfOne)
{
  const SmallDisk disk(256 << 10);
  if (!disk.is_there()) GTEST_SKIP() << "cannot mount a small disk";
  const std::string earlier = write_sample(disk.path(), 1), later = path_in(disk.path(), checkpoint_file(2));
  const StateImage big{0.0, 2, {{"x", {100000}, std::vector<Real>(100000, 1.5)}}};
  EXPECT_THAT(file_error_of([&] { CheckpointWriter(later).append(big); }),
      AllOf(HasSubstr(temporary_name(later)), HasSubstr(": No space left on device")));
  EXPECT_TRUE(same(read_checkpoint(earlier), sample_image(1)));
  EXPECT_FALSE(std::filesystem::exists(later));
  EXPECT_FALSE(std::filesystem::exists(temporary_name(later)));
}

TEST_F(Checkpoint, InPartsIsThatOfTheWhole)
{
  const StateImage whole = sample_image(7);
  const std::string path = path_in(folder, checkpoint_file(7));
  {
    CheckpointWriter writer(path);
    writer.append({whole.time, 7, {{"points/x", {2, 2}, std::vector<Real>{0.1, 1.0 / 3.0}, 0}}, 0, false});
    EXPECT_FALSE(std::filesystem::exists(path));
    writer.append(
        {whole.time, 7, {{"points/x", {2, 2}, std::vector<Real>{-0.0, 1e-300}, 1}, whole.arrays[1]}, 1, false});
    writer.append({whole.time, 7, {whole.arrays[2], whole.arrays[3]}, 2, true});
  }
  EXPECT_TRUE(same(read_checkpoint(path), whole));
}

TEST_F(Checkpoint, WhosePartsDoNotAllComeIsNotThere)
{
  const std::string path = path_in(folder, checkpoint_file(7));
  {
    StateImage part = sample_image(7);
    part.last = false;
    CheckpointWriter(path).append(part);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace checkpoint_test
