/* A library to be preloaded that makes the file system under $MISFORTUNE_FOLDER fail:
 *   MISFORTUNE_AT=N MISFORTUNE_ERROR=28   the Nth call that writes there, and all behind it, fail with this errno
 *   MISFORTUNE_COUNT=FILE                 each such call adds a byte to FILE
 *   MISFORTUNE_NFS=1   no locks, no links; every third exclusive creation says EEXIST though it succeeded (a reply that
 *                      was lost and asked for again)
 *   MISFORTUNE_CLOCK=S the clock of the wall is S seconds off */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#define REAL(name) __typeof__(&name) real = (__typeof__(&name))dlsym(RTLD_NEXT, #name)

static long calls;

static long number(const char* name) {
  const char* text = getenv(name);
  return text ? atol(text) : 0;
}

static int watched(const char* path) {
  const char* folder = getenv("MISFORTUNE_FOLDER");
  return folder && strncmp(path, folder, strlen(folder)) == 0;
}

static int watched_file(int file) {
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = 0;
  return watched(path);
}

static int fails(void) {
  const long at = number("MISFORTUNE_AT");
  const char* count = getenv("MISFORTUNE_COUNT");
  if (count) {
    const int file = (int)syscall(SYS_openat, AT_FDCWD, count, O_WRONLY | O_CREAT | O_APPEND, 0666);
    syscall(SYS_write, file, ".", 1);
    syscall(SYS_close, file);
  }
  ++calls;
  if (at == 0 || calls < at) return 0;
  errno = (int)number("MISFORTUNE_ERROR");
  return 1;
}

static int opened(int (*real)(const char*, int, ...), const char* path, int flags, mode_t mode) {
  if ((flags & (O_CREAT | O_WRONLY | O_RDWR)) && watched(path)) {
    if (fails()) return -1;
    if ((flags & O_EXCL) && number("MISFORTUNE_NFS")) {
      static int exclusive;
      const int file = real(path, flags, mode);
      if (file < 0 || ++exclusive % 3) return file;
      close(file);
      errno = EEXIST;
      return -1;
    }
  }
  return real(path, flags, mode);
}

int open(const char* path, int flags, ...) {
  REAL(open);
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return opened(real, path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  REAL(open64);
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = va_arg(rest, mode_t);
  va_end(rest);
  return opened(real, path, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t size) {
  REAL(write);
  return watched_file(file) && fails() ? -1 : real(file, bytes, size);
}

ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  REAL(pwrite64);
  return watched_file(file) && fails() ? -1 : real(file, bytes, size, at);
}

int fsync(int file) {
  REAL(fsync);
  return watched_file(file) && fails() ? -1 : real(file);
}

int syncfs(int file) {
  REAL(syncfs);
  return watched_file(file) && fails() ? -1 : real(file);
}

int close(int file) {
  REAL(close);
  const int writes = (fcntl(file, F_GETFL) & O_ACCMODE) != O_RDONLY && watched_file(file);
  if (writes && fails()) {
    const int error = errno;
    real(file);
    errno = error;
    return -1;
  }
  return real(file);
}

int rename(const char* from, const char* to) {
  REAL(rename);
  return watched(to) && fails() ? -1 : real(from, to);
}

int mkdir(const char* path, mode_t mode) {
  REAL(mkdir);
  return watched(path) && fails() ? -1 : real(path, mode);
}

int link(const char* from, const char* to) {
  REAL(link);
  if (!number("MISFORTUNE_NFS")) return real(from, to);
  errno = EOPNOTSUPP;
  return -1;
}

int flock(int file, int operation) {
  REAL(flock);
  if (!number("MISFORTUNE_NFS")) return real(file, operation);
  errno = ENOLCK;
  return -1;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  REAL(clock_gettime);
  const int status = real(clock, now);
  if (clock == CLOCK_REALTIME) now->tv_sec += number("MISFORTUNE_CLOCK");
  return status;
}

time_t time(time_t* result) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (result) *result = now.tv_sec;
  return now.tv_sec;
}
