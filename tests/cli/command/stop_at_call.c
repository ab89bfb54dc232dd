/* To be preloaded: counts the calls by which a process makes, fills, renames and removes regular files, and stops it at one of them.
 * STOP_AT: number of the call, from 1. STOP_HOW: "kill", half of what that call would write is written, then SIGKILL; "interrupt",
 * SIGINT before it; "insist", two of them; "full", that call and all writes after it find the disk full. STOP_COUNT: a file that gets the number of calls
 * at the end. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static long calls;
static int disk_is_full;

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

__attribute__((destructor)) static void tell(void) {
  const char* file = getenv("STOP_COUNT");
  if (file == NULL) return;
  const int out = NEXT(open)(file, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  dprintf(out, "%ld\n", calls);
  close(out);
}

/* Whether it is this call's turn to be killed; sets disk_is_full and interrupts by itself. */
static int is_killed(void) {
  const char *at = getenv("STOP_AT"), *how = getenv("STOP_HOW");
  const long call = __atomic_add_fetch(&calls, 1, __ATOMIC_SEQ_CST);
  if (at == NULL || how == NULL || call != atol(at)) return 0;
  if (strcmp(how, "interrupt") == 0 || strcmp(how, "insist") == 0) raise(SIGINT);
  if (strcmp(how, "insist") == 0) raise(SIGINT);
  if (strcmp(how, "full") == 0) disk_is_full = 1;
  return strcmp(how, "kill") == 0;
}

static void die(void) {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

static int is_file(int descriptor) {
  struct stat status;
  return descriptor > 2 && fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

static int refuse(void) {
  errno = ENOSPC;
  return -1;
}

ssize_t write(int descriptor, const void* data, size_t size) {
  if (is_file(descriptor)) {
    if (is_killed()) {
      (void)!NEXT(write)(descriptor, data, size / 2);
      die();
    }
    if (disk_is_full) return refuse();
  }
  return NEXT(write)(descriptor, data, size);
}

ssize_t writev(int descriptor, const struct iovec* pieces, int count) {
  if (is_file(descriptor)) {
    if (is_killed()) {
      (void)!NEXT(write)(descriptor, pieces[0].iov_base, pieces[0].iov_len / 2);
      die();
    }
    if (disk_is_full) return refuse();
  }
  return NEXT(writev)(descriptor, pieces, count);
}

static ssize_t write_there(int descriptor, const void* data, size_t size, off_t at) {
  if (is_file(descriptor)) {
    if (is_killed()) {
      (void)!NEXT(pwrite)(descriptor, data, size / 2, at);
      die();
    }
    if (disk_is_full) return refuse();
  }
  return NEXT(pwrite)(descriptor, data, size, at);
}

ssize_t pwrite(int descriptor, const void* data, size_t size, off_t at) { return write_there(descriptor, data, size, at); }
ssize_t pwrite64(int descriptor, const void* data, size_t size, off_t at) { return write_there(descriptor, data, size, at); }

static int truncate_to(int descriptor, off_t size) {
  if (is_killed()) die();
  if (disk_is_full) return refuse();
  return NEXT(ftruncate)(descriptor, size);
}

int ftruncate(int descriptor, off_t size) { return truncate_to(descriptor, size); }
int ftruncate64(int descriptor, off_t size) { return truncate_to(descriptor, size); }

static int open_file(const char* path, int flags, mode_t mode) {
  if ((flags & O_CREAT) != 0) {
    if (is_killed()) die();
    if (disk_is_full) return refuse();
  }
  return NEXT(open)(path, flags, mode);
}

static mode_t mode_of(int flags, va_list rest) { return (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0; }

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_file(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_file(path, flags, mode);
}

/* stdio writes inside the C library, where nothing can be put between: for matio. */
FILE* fopen(const char* path, const char* mode) {
  if (strpbrk(mode, "wa+") != NULL) {
    if (is_killed()) die();
    if (disk_is_full) return refuse(), (FILE*)NULL;
  }
  return NEXT(fopen)(path, mode);
}

size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  if (is_file(fileno(file))) {
    if (is_killed()) {
      NEXT(fwrite)(data, 1, size * count / 2, file);
      fflush(file);
      die();
    }
    if (disk_is_full) return errno = ENOSPC, (size_t)0;
  }
  return NEXT(fwrite)(data, size, count, file);
}

int rename(const char* from, const char* to) {
  if (is_killed()) die();
  return NEXT(rename)(from, to);
}

int unlink(const char* path) {
  if (is_killed()) die();
  return NEXT(unlink)(path);
}

int remove(const char* path) {
  if (is_killed()) die();
  return NEXT(remove)(path);
}
