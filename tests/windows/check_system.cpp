// What src/os asks of Windows, as a program of its own: it runs under Wine in seconds, without the
// rest of Terp. Prints what fails; the exit status is the number of failures.
//
// usage: check_system FOLDER [child|hold|faulty]      FOLDER: empty, for its files
#include "math/errors.hpp"
#include "os/threads.hpp"
#include "os/children.hpp"
#include "os/files.hpp"
#include "os/folder_claim.hpp"
#include "os/process.hpp"
#include "os/stop.hpp"
#include "os/terminal.hpp"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <windows.h>

namespace {

using namespace terp;
namespace fs = std::filesystem;

int n_failures = 0;

void expect(bool holds, const char* what)
{
  if (holds) return;
  std::printf("FAILED: %s\n", what);
  ++n_failures;
}
#define EXPECT(...) expect((__VA_ARGS__), #__VA_ARGS__)

std::string text_of(const std::string& path)
{
  std::ifstream file(fs::path(path), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& text)
{
  const int file = open_to_write(path, OpenAs::new_file);
  EXPECT(write_all(file, text) == 0 && close_file(file) == 0);
}

void test_files(const std::string& folder)
{
  const std::string a = folder + "/ä b", b = folder + "/b";
  EXPECT(open_to_write(a, OpenAs::there_already) == -1 && errno == ENOENT);
  write(a, "one\n");
  const int file = open_to_write(a, OpenAs::end_of_file);
  EXPECT(write_all(file, "two\n") == 0 && size_of(file) == 8);
  EXPECT(reserve(file, 10) == 0 && size_of(file) == 18 && resize(file, 8) == 0);
  EXPECT(close_file(file) == 0 && text_of(a) == "one\ntwo\n");
  EXPECT(fs::exists(fs::path(fs::path(folder).wstring() + L"/\u00e4 b")));
  EXPECT(fs::path("\xf0\x9f\x8c\x8a ä\xff").wstring() == L"\xd83c\xdf0a \u00e4\ufffd");  // a wave, of two wide letters
  write(b, "old");
  EXPECT(wait_for_disk(a) == 0 && wait_for_disk(folder) == 0);
  EXPECT(replace_file(a, b) == 0 && text_of(b) == "one\ntwo\n" && !fs::exists(fs::path(a)));
  EXPECT(replace_file(a, b) == ENOENT);
  EXPECT(may_read(b) == 0 && may_read(a) == ENOENT && may_write(b) == 0 && may_write(folder) == 0);
  const std::string first = make_unique_folder(folder + "/x-"), second = make_unique_folder(folder + "/x-");
  EXPECT(first != second && fs::is_directory(first) && fs::is_directory(second));
}

/// As a spreadsheet has it: shared for reading alone.
void test_held_file(const std::string& folder)
{
  const std::string held = folder + "/held", other = folder + "/other";
  write(held, "held");
  write(other, "other");
  const HANDLE file = CreateFileA(held.c_str(), GENERIC_READ, FILE_SHARE_READ, nullptr, OPEN_EXISTING, 0, nullptr);
  EXPECT(replace_file(other, held) == EBUSY);
  EXPECT(open_to_write(held, OpenAs::new_file) == -1 && errno == EBUSY);
  CloseHandle(file);
  EXPECT(replace_file(other, held) == 0 && text_of(held) == "other");
}

void test_claims(const std::string& folder, const std::string& program)
{
  int one = -1, other = -1;
  EXPECT(look_at_claim(folder) == ClaimResult::taken);
  EXPECT(claim_folder(folder, one) == ClaimResult::taken);
  EXPECT(claim_folder(folder, other) == ClaimResult::held_by_another && other == -1);
  EXPECT(look_at_claim(folder) == ClaimResult::held_by_another);
  std::error_code error;
  EXPECT(!fs::is_empty(folder, error) && !error);  // who holds it may list it
  write(folder + "/inside", "may change");
  EXPECT(replace_file(folder + "/inside", folder + "/inside 2") == 0);
  EXPECT(run_process({program, folder, "hold"}, 60.0).status == 3);  // from another process
  release_claim(one);
  EXPECT(claim_folder(folder, other) == ClaimResult::taken);
  release_claim(other);
  EXPECT(claim_folder(folder + "/none", one) == ClaimResult::no_folder && errno == ENOENT);
}

void test_processes(const std::string& folder, const std::string& program)
{
  EXPECT(!run_process({"no-such-program-here"}, 10.0).found);
  const ProcessResult said = run_process({"cmd", "/c", "echo one & exit 3"}, 60.0);
  EXPECT(said.found && said.status == 3 && said.output.starts_with("one"));
  EXPECT(run_process({program, folder, "environment"}, 60.0, {"TERP_X=ü y"}).output == "ü y");
  const ProcessResult words = run_process({program, folder, "words", "a b", "c\"d\\", "", "é"}, 60.0);
  EXPECT(words.output == "a b|c\"d\\||é|");
  const ProcessResult late = run_process({program, folder, "sleep"}, 0.5);
  EXPECT(late.timed_out && !late.succeeded());
}

/// In the process that `Children` starts: 0 counts and ends, 1 waits for the wish to stop, 2 has a fault.
int be_child(const OwnTask& task)
{
  auto* const counts = static_cast<std::atomic<int>*>(task.shared);
  listen_for_stop();
  ++counts[task.number];
  if (task.number == 1)
    while (!stop_requested) wait_seconds(0.05);
  if (task.number == 2) *static_cast<volatile int*>(nullptr) = 1;
  return 40 + static_cast<int>(task.number);
}

void test_children()
{
  Children children(3 * sizeof(std::atomic<int>));
  auto* const counts = static_cast<std::atomic<int>*>(children.shared());
  for (std::size_t k = 0; k < 3; ++k) children.begin(k, "a test", {});
  for (int k = 0; k < 600 && (counts[0] == 0 || counts[1] == 0); ++k) wait_seconds(0.05);
  EXPECT(counts[0] == 1 && counts[1] == 1);
  children.ask_to_stop();
  int n_ends = 0;
  for (int k = 0; k < 600 && n_ends < 3; ++k) {
    const auto end = children.next_end();
    if (!end) {
      wait_seconds(0.05);
      continue;
    }
    ++n_ends;
    EXPECT(end->number == 2 ? !end->killed_by.empty() : end->status == 40 + static_cast<int>(end->number));
  }
  EXPECT(n_ends == 3);
}

void test_threads()
{
  EXPECT(available_processors() >= 1);
  Threads threads(4);
  std::atomic<long> sum{0};
  for (int round = 0; round < 300; ++round) {
    threads.for_each_chunk(64, [&](Index chunk, int) { sum += chunk; });
    if (round % 30 == 0) Sleep(5);  // until the threads sleep
  }
  EXPECT(sum == 300L * 63 * 64 / 2);
}

}  // namespace

int main(int argc, char** argv)
{
  if (!prepare_standard_streams() || argc < 2) return 99;
  const std::string folder = argv[1], what = argc > 2 ? argv[2] : "";
  if (const auto task = own_task()) return be_child(*task);
  int claim = -1;
  if (what == "hold") return claim_folder(folder, claim) == ClaimResult::held_by_another ? 3 : 4;
  if (what == "sleep") return Sleep(60000), 0;
  if (what == "environment") return std::printf("%s", std::getenv("TERP_X")), 0;
  if (what == "words") {
    for (int k = 3; k < argc; ++k) std::printf("%s|", argv[k]);
    return 0;
  }
  const std::string program = fs::absolute(argv[0]).string();
  test_files(folder);
  test_held_file(folder);
  test_claims(folder, program);
  test_processes(folder, program);
  test_children();
  test_threads();
  std::printf("%d failures\n", n_failures);
  return n_failures;
}
