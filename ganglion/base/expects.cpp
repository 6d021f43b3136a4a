#include "ganglion/base/expects.h"

#include <cstdio>
#include <cstdlib>

namespace ganglion {

void broken_promise(std::source_location where) noexcept {
  std::fprintf(stderr, "%s:%u: broken promise in %s\n", where.file_name(), where.line(), where.function_name());
  std::abort();
}

}  // namespace ganglion
