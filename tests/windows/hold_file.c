/* Opens a file as a spreadsheet does: others may read it, and neither write, replace nor remove it. Lets go of it after
   some seconds.

   usage: hold_file FILE SECONDS SIGN      SIGN: a file that is made when the other one is held */
#include <stdlib.h>
#include <windows.h>

int main(int argc, char** argv)
{
  HANDLE file, sign;
  if (argc != 4) return 2;
  file = CreateFileA(argv[1], GENERIC_READ, FILE_SHARE_READ, NULL, OPEN_EXISTING, 0, NULL);
  if (file == INVALID_HANDLE_VALUE) return 1;
  sign = CreateFileA(argv[3], GENERIC_WRITE, 0, NULL, CREATE_ALWAYS, 0, NULL);
  CloseHandle(sign);
  Sleep((DWORD)(1000 * atof(argv[2])));
  CloseHandle(file);
  return 0;
}
