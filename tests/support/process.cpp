#include "support/process.hpp"

#include <csignal>

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace terp::test {
namespace {

/// In the child: standard output or error to a file.
void redirect(int descriptor, const std::string& path)
{
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(126);
}

}  // namespace

Process::Process(const std::vector<std::string>& arguments, const std::string& working_folder)
{
  std::vector<std::string> words = with({program()}, arguments);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("cannot start a process");
  if (pid_ > 0) return;
  redirect(STDOUT_FILENO, output_.path() + "/out");
  redirect(STDERR_FILENO, output_.path() + "/err");
  if (!working_folder.empty() && ::chdir(working_folder.c_str()) != 0) ::_exit(126);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

Process::~Process()
{
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Process::send(int signal) const { ::kill(pid_, signal); }

Finished Process::wait()
{
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
      .out = text_of(output_.path() + "/out"),
      .err = text_of(output_.path() + "/err")};
}

Finished terp(const std::vector<std::string>& arguments, const std::string& working_folder)
{
  return Process(arguments, working_folder).wait();
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Finished succeeded(const Finished& f, std::source_location where)
{
  error_with(0, f, where);
  return f;
}

std::string error_with(int status, const Finished& f, std::source_location where)
{
  const testing::ScopedTrace caller(where.file_name(), static_cast<int>(where.line()), "");
  EXPECT_EQ(f.status, status) << f.err << f.out;
  return f.err;
}

std::string text_of(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::vector<std::string> names_in(const std::string& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace terp::test
