#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ganglion::studio {

/// A file of the page, as it was built into the program.
struct EmbeddedAsset {
  std::string_view path;  ///< "/assets/index-1a2b.js"
  std::string_view gzip;
};
/// Written by the build; empty where the page was not built.
std::span<const EmbeddedAsset> embedded_assets() noexcept;

struct Asset {
  std::string type;
  std::string body;
  bool gzip = false;  ///< `body` is packed.
};

/// The page's files: those built in, or those of a folder while one develops them.
class Assets {
 public:
  explicit Assets(std::filesystem::path web_root) : web_root_(std::move(web_root)) {}
  /// "/" is the page itself, and so is any path without a dot that is no file: the page has paths of its own.
  std::optional<Asset> find(const std::string& path, bool may_be_packed) const;

 private:
  std::optional<Asset> from_folder(const std::string& path) const;
  std::filesystem::path web_root_;
};

std::string_view media_type(std::string_view path) noexcept;

}  // namespace ganglion::studio
