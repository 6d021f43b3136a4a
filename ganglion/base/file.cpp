#include "ganglion/base/file.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include <unistd.h>

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
  const auto size = fs::file_size(path, error);
  if (error)
    return fail_at({path.string()}, ErrorCode::Unreadable, {"cannot be read: {}", "no se puede leer: {}"},
                   error.message());
  if (size > max_bytes) return too_large(path, size, max_bytes);
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return fail_at({path.string()}, ErrorCode::Unreadable, {"cannot be opened", "no se puede abrir"});
  std::string content(size, '\0');
  stream.read(content.data(), static_cast<std::streamsize>(size));
  if (stream.bad()) return fail_at({path.string()}, ErrorCode::Unreadable, {"cannot be read", "no se puede leer"});
  content.resize(static_cast<std::size_t>(stream.gcount()));
  return content;
}

Result<void> write_file(const fs::path& path, std::string_view content) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  fs::path part = path;
  part += "." + std::to_string(::getpid()) + ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (stream) {
    fs::rename(part, path, error);
    if (!error) return {};
  }
  const Sentence why =
      error ? Sentence::quoted(error.message()) : say({"disk full, or no permission", "disco lleno, o sin permiso"});
  fs::remove(part, error);
  return fail_at({path.string()}, ErrorCode::Unwritable, {"cannot be written: {}", "no se puede escribir: {}"}, why);
}

}  // namespace ganglion
