/* Runs a program and presses Ctrl-C for it as soon as a file is there: the program has a console with us. Its exit
   status is ours; 99: the file did not come within two minutes.

   usage: press_ctrl_c FILE COMMAND-LINE */
#include <windows.h>

static BOOL WINAPI ignore(DWORD event)
{
  (void)event;
  return TRUE;
}

int main(int argc, char** argv)
{
  STARTUPINFOA how = {sizeof how};
  PROCESS_INFORMATION made;
  DWORD status = 98;
  int k;
  if (argc != 3) return 2;
  SetConsoleCtrlHandler(ignore, TRUE);
  if (!CreateProcessA(NULL, argv[2], NULL, NULL, TRUE, 0, NULL, NULL, &how, &made)) return 97;
  for (k = 0; k < 1200 && GetFileAttributesA(argv[1]) == INVALID_FILE_ATTRIBUTES; ++k) Sleep(100);
  if (k == 1200) TerminateProcess(made.hProcess, 99);
  GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0);
  WaitForSingleObject(made.hProcess, INFINITE);
  GetExitCodeProcess(made.hProcess, &status);
  return (int)status;
}
