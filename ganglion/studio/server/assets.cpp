#include "ganglion/studio/server/assets.h"

#include <array>

#include <zlib.h>

#include "ganglion/base/file.h"
#include "ganglion/studio/folder/folder.h"

namespace ganglion::studio {
namespace {

/// What is shown where the page was not built into this program.
constexpr std::string_view kPlainPage = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<title>Ganglion studio</title>
<h1>Ganglion studio</h1>
<p>This program was built without the studio's page (CMake option GANGLION_STUDIO). The server works:
its interface is described in <code>docs/studio_api.md</code>.</p>
<p lang="es">Este programa se compiló sin la página del estudio (opción GANGLION_STUDIO de CMake). El servidor funciona:
su interfaz se describe en <code>docs/studio_api.md</code>.</p>
</html>
)";

std::string unpacked(std::string_view gzip) {
  std::string result;
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) return result;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(gzip.data()));
  stream.avail_in = static_cast<uInt>(gzip.size());
  std::array<char, 65536> piece{};
  int code = Z_OK;
  while (code == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    code = inflate(&stream, Z_NO_FLUSH);
    result.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return result;
}

}  // namespace

std::string_view media_type(std::string_view path) noexcept {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kTypes = {
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".json", "application/json"},
       {".map", "application/json"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".ico", "image/x-icon"},
       {".woff2", "font/woff2"},
       {".txt", "text/plain; charset=utf-8"},
       {".webmanifest", "application/manifest+json"},
       {".wasm", "application/wasm"}}};
  for (const auto& [suffix, type] : kTypes) {
    if (path.ends_with(suffix)) return type;
  }
  return "application/octet-stream";
}

std::optional<Asset> Assets::from_folder(const std::string& path) const {
  const auto folder = Folder::open(web_root_);
  if (!folder) return std::nullopt;
  const auto file = folder->resolve(path.substr(1));
  if (!file) return std::nullopt;
  auto text = folder->text_of(*file, kMaxFileBytes);
  if (!text) return std::nullopt;
  return Asset{std::string(media_type(path)), std::move(*text), false};
}

std::optional<Asset> Assets::find(const std::string& path, bool may_be_packed) const {
  const bool whole_page = path.find('.', path.rfind('/')) == std::string::npos;
  const std::string name = whole_page ? "/index.html" : path;
  if (!web_root_.empty()) return from_folder(name);
  for (const EmbeddedAsset& asset : embedded_assets()) {
    if (asset.path != name) continue;
    return Asset{std::string(media_type(name)), may_be_packed ? std::string(asset.gzip) : unpacked(asset.gzip),
                 may_be_packed};
  }
  if (!whole_page || !embedded_assets().empty()) return std::nullopt;
  return Asset{"text/html; charset=utf-8", std::string(kPlainPage), false};
}

}  // namespace ganglion::studio
