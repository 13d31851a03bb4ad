/* Kills a program at one of its calls that change files: LD_PRELOAD this, with KILL_AT=N for its N-th such call. A write is done by
   half before the program dies, so that the sweep of N meets every state that a kill can leave. Without KILL_AT the calls are
   counted into the file that KILL_COUNT names. Only the files of a run count: those below the folder KILL_IN. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_long n_calls;

#define REAL(name) __extension__((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int in_folder(const char* path)
{
  const char* folder = getenv("KILL_IN");
  return folder != NULL && path != NULL && strncmp(path, folder, strlen(folder)) == 0;
}

static int is_ours(int descriptor)
{
  char link[64], path[4096];
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t n = readlink(link, path, sizeof path - 1);
  if (n < 0) return 0;
  path[n] = 0;
  return in_folder(path);
}

/* True if the program is to die at this call. */
static int is_last(void)
{
  const long n = atomic_fetch_add(&n_calls, 1) + 1;
  const char* at = getenv("KILL_AT");
  return at != NULL && n == atol(at);
}

static void die(void) { kill(getpid(), SIGKILL); pause(); }

ssize_t write(int descriptor, const void* from, size_t n)
{
  if (is_ours(descriptor) && is_last()) {
    REAL(write)(descriptor, from, n / 2);
    die();
  }
  return REAL(write)(descriptor, from, n);
}

ssize_t pwrite(int descriptor, const void* from, size_t n, off_t at)
{
  if (is_ours(descriptor) && is_last()) {
    REAL(pwrite)(descriptor, from, n / 2, at);
    die();
  }
  return REAL(pwrite)(descriptor, from, n, at);
}

ssize_t pwrite64(int descriptor, const void* from, size_t n, off_t at) { return pwrite(descriptor, from, n, at); }

int ftruncate(int descriptor, off_t size)
{
  if (is_ours(descriptor) && is_last()) die();
  return REAL(ftruncate)(descriptor, size);
}

int ftruncate64(int descriptor, off_t size) { return ftruncate(descriptor, size); }

int posix_fallocate(int descriptor, off_t at, off_t n)
{
  if (is_ours(descriptor) && is_last()) die();
  return REAL(posix_fallocate)(descriptor, at, n);
}

int posix_fallocate64(int descriptor, off_t at, off_t n) { return posix_fallocate(descriptor, at, n); }

int fsync(int descriptor)
{
  if (is_ours(descriptor) && is_last()) die();
  return REAL(fsync)(descriptor);
}

int rename(const char* from, const char* to)
{
  if (in_folder(to) && is_last()) die();
  return REAL(rename)(from, to);
}

int unlink(const char* path)
{
  if (in_folder(path) && is_last()) die();
  return REAL(unlink)(path);
}

int remove(const char* path)
{
  if (in_folder(path) && is_last()) die();
  return REAL(remove)(path);
}

__attribute__((destructor)) static void tell(void)
{
  const char* name = getenv("KILL_COUNT");
  FILE* file = name != NULL ? fopen(name, "w") : NULL;
  if (file == NULL) return;
  fprintf(file, "%ld\n", atomic_load(&n_calls));
  fclose(file);
}
