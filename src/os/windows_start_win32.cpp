// A program starts suspended, enters its job, and only then runs: what it starts itself is then in the job too. It
// inherits the listed handles alone; with all of them, a pipe of one program would stay open in another that starts
// meanwhile.

#include "os/windows_start.hpp"

#include "math/errors.hpp"
#include "os/windows_words.hpp"

#include <algorithm>
#include <string_view>
#include <windows.h>

namespace terp {
namespace {

/// A job whose programs end with it.
HANDLE make_job()
{
  const HANDLE job = CreateJobObjectW(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits);
  return job;
}

/// The handles that a program inherits: no others.
class InheritedList {
 public:
  explicit InheritedList(std::vector<void*>& handles)
  {
    SIZE_T n_bytes = 0;
    InitializeProcThreadAttributeList(nullptr, 1, 0, &n_bytes);
    memory_.resize(n_bytes);
    InitializeProcThreadAttributeList(list(), 1, 0, &n_bytes);
    UpdateProcThreadAttribute(
        list(), 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles.data(), handles.size() * sizeof(void*), nullptr, nullptr);
  }
  ~InheritedList() { DeleteProcThreadAttributeList(list()); }
  InheritedList(const InheritedList&) = delete;
  InheritedList& operator=(const InheritedList&) = delete;
  LPPROC_THREAD_ATTRIBUTE_LIST list() { return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(memory_.data()); }

 private:
  std::vector<char> memory_;
};

}  // namespace

OwnedHandle::~OwnedHandle()
{
  if (handle != nullptr && handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
}

/// In quotes, where backslashes before a quote are doubled: rules of CommandLineToArgvW.
std::wstring in_quotes(const std::wstring& word)
{
  if (!word.empty() && word.find_first_of(L" \t\n\v\"") == std::wstring::npos) return word;
  std::wstring text = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : word) {
    if (c == L'"') text.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    text += c;
  }
  return text.append(backslashes, L'\\') + L"\"";
}

/// "NAME=value" one after the other, each closed by a zero, and a zero at the end.
std::wstring environment_with(const std::vector<std::string>& more)
{
  std::wstring block;
  wchar_t* const ours = GetEnvironmentStringsW();
  for (const wchar_t* entry = ours; *entry != 0; entry += std::wstring_view(entry).size() + 1) {
    const auto is_replaced = [&](const std::string& word) {
      const std::wstring name = wide(word.substr(0, word.find('=') + 1));
      return _wcsnicmp(name.c_str(), entry, name.size()) == 0;
    };
    if (std::ranges::none_of(more, is_replaced)) block.append(entry).push_back(0);
  }
  FreeEnvironmentStringsW(ours);
  for (const std::string& word : more) block.append(wide(word)).push_back(0);
  block.push_back(0);
  return block;
}

StartedProgram start_program(const std::string& name, const std::wstring& program, std::wstring line,
    std::wstring environment, void* const (&streams)[3], std::vector<void*> inherited, bool dies_with_us)
{
  InheritedList list(inherited);
  STARTUPINFOEXW how{};
  how.StartupInfo.cb = sizeof how;
  how.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
  how.StartupInfo.hStdInput = streams[0];
  how.StartupInfo.hStdOutput = streams[1];
  how.StartupInfo.hStdError = streams[2];
  how.lpAttributeList = list.list();
  PROCESS_INFORMATION made{};
  if (!CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE,
          CREATE_UNICODE_ENVIRONMENT | CREATE_SUSPENDED | EXTENDED_STARTUPINFO_PRESENT, environment.data(), nullptr,
          &how.StartupInfo, &made))
    throw FileError("cannot start " + name + ": " + words_of_error(GetLastError()));
  StartedProgram started{OwnedHandle(made.hProcess), OwnedHandle(dies_with_us ? make_job() : nullptr)};
  if (dies_with_us) AssignProcessToJobObject(started.job.handle, made.hProcess);
  ResumeThread(made.hThread);
  CloseHandle(made.hThread);
  return started;
}

}  // namespace terp
