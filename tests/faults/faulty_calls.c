/* Loaded before a program (LD_PRELOAD), makes one of its system calls that write fail, as a full disk, a broken one, a
 * signal or a folder that was locked meanwhile would.
 *
 *   FAULTY_FOLDER  only calls that concern files below this folder are counted
 *   FAULTY_CALLS   names of the calls that are counted, with a comma behind each
 *   FAULTY_AT      number of the call that fails, from 1; 0: none
 *   FAULTY_WITH    number of the error; 0: a write is cut short
 *   FAULTY_ON      1: all calls from that one on fail, as on a disk that stays full
 *   FAULTY_LOG     file to which a line is added for each call: number, name, path
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long calls;

static const char* setting(const char* name) {
  const char* text = getenv(name);
  return text == NULL ? "" : text;
}

static int is_counted(const char* call) {
  const char* list = setting("FAULTY_CALLS");
  const size_t length = strlen(call);
  for (const char* at = strstr(list, call); at != NULL; at = strstr(at + 1, call))
    if ((at == list || at[-1] == ',') && at[length] == ',') return 1;
  return 0;
}

static int is_below(const char* path) {
  const char* folder = setting("FAULTY_FOLDER");
  if (folder[0] == '\0') return 0;
  if (path[0] != '/') return 1; /* The program is started in the folder. */
  const size_t length = strlen(folder);
  return strncmp(path, folder, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

static void note(long number, const char* call, const char* path) {
  const char* log = setting("FAULTY_LOG");
  if (log[0] == '\0') return;
  char line[PATH_MAX + 64];
  const int length = snprintf(line, sizeof line, "%ld %s %s\n", number, call, path);
  const int file = (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  syscall(SYS_write, file, line, (size_t)length);
  syscall(SYS_close, file);
}

/* -1: the call goes on as it is; otherwise the error it fails with, 0 for a short write. */
static int fault_of_path(const char* call, const char* path) {
  const int kept = errno;
  int fault = -1;
  if (is_counted(call) && is_below(path)) {
    const long number = atomic_fetch_add(&calls, 1) + 1;
    const long at = atol(setting("FAULTY_AT"));
    note(number, call, path);
    if (at > 0 && (number == at || (number > at && atol(setting("FAULTY_ON")) == 1))) fault = atoi(setting("FAULTY_WITH"));
  }
  errno = kept;
  return fault;
}

static int fault_of_file(const char* call, int file) {
  char name[64];
  char path[PATH_MAX];
  const int kept = errno;
  snprintf(name, sizeof name, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(name, path, sizeof path - 1);
  errno = kept;
  if (length <= 0 || path[0] != '/') return -1;
  path[length] = '\0';
  return fault_of_path(call, path);
}

#define REAL(type, name) \
  static type real = NULL; \
  if (real == NULL) real = (type)dlsym(RTLD_NEXT, name)

#define FAIL_OR_GO_ON(fault) \
  do { \
    const int failure = (fault); \
    if (failure > 0) { \
      errno = failure; \
      return -1; \
    } \
  } while (0)

typedef ssize_t (*write_call)(int, const void*, size_t);
typedef ssize_t (*writev_call)(int, const struct iovec*, int);
typedef ssize_t (*pwrite_call)(int, const void*, size_t, off_t);
typedef int (*file_call)(int);
typedef int (*file_size_call)(int, off_t);
typedef int (*file_mode_call)(int, mode_t);
typedef int (*path_mode_call)(const char*, mode_t);
typedef int (*allocate_call)(int, int, off_t, off_t);
typedef int (*posix_allocate_call)(int, off_t, off_t);
typedef int (*two_paths_call)(const char*, const char*);
typedef int (*rename_flags_call)(int, const char*, int, const char*, unsigned);
typedef int (*open_call)(const char*, int, ...);

ssize_t write(int file, const void* bytes, size_t count) {
  REAL(write_call, "write");
  const int error = fault_of_file("write", file);
  FAIL_OR_GO_ON(error);
  return real(file, bytes, error == 0 && count > 1 ? count / 2 : count);
}

ssize_t writev(int file, const struct iovec* parts, int count) {
  REAL(writev_call, "writev");
  const int error = fault_of_file("writev", file);
  FAIL_OR_GO_ON(error);
  if (error == 0 && count > 0 && parts[0].iov_len > 1) {
    const struct iovec first = {parts[0].iov_base, parts[0].iov_len / 2};
    return real(file, &first, 1);
  }
  return real(file, parts, count);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  REAL(pwrite_call, "pwrite");
  const int error = fault_of_file("pwrite", file);
  FAIL_OR_GO_ON(error);
  return real(file, bytes, error == 0 && count > 1 ? count / 2 : count, offset);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off_t offset) { return pwrite(file, bytes, count, offset); }

int fsync(int file) {
  REAL(file_call, "fsync");
  FAIL_OR_GO_ON(fault_of_file("fsync", file));
  return real(file);
}

int fdatasync(int file) {
  REAL(file_call, "fdatasync");
  FAIL_OR_GO_ON(fault_of_file("fdatasync", file));
  return real(file);
}

/* The file is closed all the same, as Linux does it. Files that were only read do not count. */
int close(int file) {
  REAL(file_call, "close");
  const int flags = fcntl(file, F_GETFL);
  const int error = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY ? fault_of_file("close", file) : -1;
  const int result = real(file);
  FAIL_OR_GO_ON(error);
  return result;
}

int ftruncate(int file, off_t size) {
  REAL(file_size_call, "ftruncate");
  FAIL_OR_GO_ON(fault_of_file("ftruncate", file));
  return real(file, size);
}

int ftruncate64(int file, off_t size) { return ftruncate(file, size); }

int fallocate(int file, int mode, off_t offset, off_t size) {
  REAL(allocate_call, "fallocate");
  FAIL_OR_GO_ON(fault_of_file("fallocate", file));
  return real(file, mode, offset, size);
}

int fallocate64(int file, int mode, off_t offset, off_t size) { return fallocate(file, mode, offset, size); }

int posix_fallocate(int file, off_t offset, off_t size) {
  REAL(posix_allocate_call, "posix_fallocate");
  const int error = fault_of_file("posix_fallocate", file);
  return error > 0 ? error : real(file, offset, size);
}

int posix_fallocate64(int file, off_t offset, off_t size) { return posix_fallocate(file, offset, size); }

int fchmod(int file, mode_t mode) {
  REAL(file_mode_call, "fchmod");
  FAIL_OR_GO_ON(fault_of_file("fchmod", file));
  return real(file, mode);
}

int mkdir(const char* path, mode_t mode) {
  REAL(path_mode_call, "mkdir");
  FAIL_OR_GO_ON(fault_of_path("mkdir", path));
  return real(path, mode);
}

int rename(const char* from, const char* to) {
  REAL(two_paths_call, "rename");
  FAIL_OR_GO_ON(fault_of_path("rename", to));
  return real(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  REAL(rename_flags_call, "renameat2");
  FAIL_OR_GO_ON(fault_of_path("renameat2", to));
  return real(from_folder, from, to_folder, to, flags);
}

int link(const char* from, const char* to) {
  REAL(two_paths_call, "link");
  FAIL_OR_GO_ON(fault_of_path("link", to));
  return real(from, to);
}

static int writes(int flags) { return (flags & (O_CREAT | O_TRUNC)) != 0 || (flags & O_ACCMODE) != O_RDONLY; }

int open(const char* path, int flags, ...) {
  REAL(open_call, "open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (writes(flags)) FAIL_OR_GO_ON(fault_of_path("open", path));
  return real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  REAL(open_call, "open64");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (writes(flags)) FAIL_OR_GO_ON(fault_of_path("open", path));
  return real(path, flags, mode);
}

/* libstdc++ opens streams so. */
FILE* fopen(const char* path, const char* mode) {
  typedef FILE* (*fopen_call)(const char*, const char*);
  REAL(fopen_call, "fopen");
  if (strpbrk(mode, "wa+") != NULL) {
    const int error = fault_of_path("open", path);
    if (error > 0) {
      errno = error;
      return NULL;
    }
  }
  return real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }
