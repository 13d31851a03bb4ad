#include "os/terminal.hpp"

#include <initializer_list>
#include <fcntl.h>
#include <io.h>
#include <windows.h>

extern "C" {
/// Read before main: "*.stix" among the arguments is all those files, as the shells of Linux make it.
int _dowildcard = -1;
}

namespace terp {

bool prepare_standard_streams()
{
  if (GetConsoleOutputCP() != CP_UTF8) SetConsoleOutputCP(CP_UTF8);
  for (std::FILE* stream : {stdin, stdout, stderr}) {
    if (_fileno(stream) < 0 && std::freopen("NUL", stream == stdin ? "rb" : "wb", stream) == nullptr) return false;
    _setmode(_fileno(stream), _O_BINARY);
    const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream)));
    DWORD mode = 0;
    if (stream != stdin && GetConsoleMode(handle, &mode))
      SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);  // for the line that renews itself
  }
  return true;
}

bool is_terminal(std::FILE* stream)
{
  DWORD mode = 0;
  return GetConsoleMode(reinterpret_cast<HANDLE>(_get_osfhandle(_fileno(stream))), &mode) != 0;
}

void wait_seconds(double seconds) { Sleep(static_cast<DWORD>(1e3 * seconds)); }

}  // namespace terp
