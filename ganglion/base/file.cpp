#include "ganglion/base/file.h"

#include <fcntl.h>

#include <cerrno>
#include <system_error>

#include "ganglion/base/beneath.h"
#include "ganglion/base/new_file.h"

namespace ganglion {
namespace fs = std::filesystem;

tl::unexpected<Error> too_large(const fs::path& path, std::size_t bytes, std::size_t most_bytes) {
  return fail_at({path.string()}, ErrorCode::TooLarge,
                 {"has {} bytes; the limit here is {}", "tiene {} bytes; el límite aquí es {}"}, bytes, most_bytes);
}

Result<std::string> read_file(const fs::path& path, std::size_t max_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error && status.type() == fs::file_type::none)  // a circle of links, a folder that may not be looked into
    return fail_at({path.string()}, ErrorCode::Unreadable, {"cannot be read: {}", "no se puede leer: {}"},
                   error.message());
  if (!fs::exists(status))
    return fail_at({path.string()}, ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  if (!fs::is_regular_file(status))
    return fail_at({path.string()}, ErrorCode::Unreadable, {"is not a regular file", "no es un archivo regular"});
  // It may be another by now: what is opened is looked at again, and never waited for.
  const FileHandle file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!file.open())
    return fail_at({path.string()}, ErrorCode::Unreadable, {"cannot be read: {}", "no se puede leer: {}"},
                   std::generic_category().message(errno));
  auto text = read_opened(file, max_bytes);
  if (!text) text.error().place = {path.string()};
  return text;
}

Result<void> write_file(const fs::path& path, std::string_view content) {
  auto file = NewFile::beside(path);
  if (!file) return tl::unexpected<Error>(file.error());
  if (auto written = file->write(content); !written) return written;
  return file->replace();
}

}  // namespace ganglion
