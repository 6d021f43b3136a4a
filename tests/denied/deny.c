/* Preloaded into the program: from the first line of main on, denies the one allocation of memory, or every thread from
   the one on, that DENY_MEMORY or DENY_THREADS numbers (from 0), and more descriptors than DENY_FILES. What libraries in C
   ask for by themselves is granted: those that draw text (fontconfig, cairo) do not look at what malloc gives them. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

typedef int main_t(int, char**, char**);
typedef int start_t(main_t*, int, char**, void (*)(void), void (*)(void), void (*)(void), void*);
typedef int create_t(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

static long memory_at = -1, threads_at = -1;
static atomic_long memories, threads;
static atomic_int begun;
static main_t* real_main;
static void* (*real_malloc)(size_t);
static create_t* real_create;

static long number(const char* name) {
  const char* text = getenv(name);
  return text == NULL ? -1 : atol(text);
}

static int counted_main(int count, char** words, char** environment) {
  const long files = number("DENY_FILES");
  const struct rlimit most = {(rlim_t)files, (rlim_t)files};
  if (files >= 0) setrlimit(RLIMIT_NOFILE, &most);
  begun = 1;
  const int code = real_main(count, words, environment);
  begun = 0;
  return code;
}

int __libc_start_main(main_t* main, int count, char** words, void (*init)(void), void (*fini)(void),
                      void (*rtld_fini)(void), void* stack_end) {
  start_t* start = (start_t*)dlsym(RTLD_NEXT, "__libc_start_main");
  real_create = (create_t*)dlsym(RTLD_NEXT, "pthread_create");
  memory_at = number("DENY_MEMORY");
  threads_at = number("DENY_THREADS");
  real_main = main;
  return start(counted_main, count, words, init, fini, rtld_fini, stack_end);
}

static int asked_by_program(void* caller) {
  Dl_info from;
  if (dladdr(caller, &from) == 0) return 0;
  return strstr(from.dli_fname, "libstdc++") != NULL || strstr(from.dli_fname, "/bin/ganglion") != NULL;
}

void* malloc(size_t size) {
  static _Thread_local int asking;
  if (real_malloc == NULL) {
    if (asking) return NULL;
    asking = 1;
    real_malloc = (void* (*)(size_t))dlsym(RTLD_NEXT, "malloc");
    asking = 0;
  }
  if (begun && memory_at >= 0 && asked_by_program(__builtin_return_address(0)) &&
      atomic_fetch_add(&memories, 1) == memory_at) {
    errno = ENOMEM;
    return NULL;
  }
  return real_malloc(size);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*body)(void*), void* with) {
  if (begun && threads_at >= 0 && atomic_fetch_add(&threads, 1) >= threads_at) return EAGAIN;
  return real_create(thread, attributes, body, with);
}
