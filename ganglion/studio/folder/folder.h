#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "ganglion/base/result.h"

namespace ganglion::studio {

/// A text of the folder, as it was read.
struct StoredText {
  std::string text;
  std::string hash;
  struct Draft {
    std::string text;
    std::string based_on;
  };
  std::optional<Draft> draft;
};

/// What a save ran into: the file is not what it was.
struct Conflict {
  std::string hash;  ///< "" = it is gone.
  std::string text;
};

/// Files below one folder, and nothing else: names are relative, with '/', without "..", none begins with a dot, and
/// no link leads out.
class Folder {
 public:
  /// Fails with NotFound where it is no folder.
  static Result<Folder> open(const std::filesystem::path& root);

  const std::filesystem::path& root() const noexcept { return root_; }
  /// Where a name leads; the file itself need not be there. Fails with NotFound for what would lead out.
  Result<std::filesystem::path> resolve(std::string_view name) const;
  /// Whether a path lies below, links followed.
  bool holds(const std::filesystem::path& path) const;
  /// From the folder on, with '/'; "" for what lies outside.
  std::string name_of(const std::filesystem::path& path) const;

  /// Texts of at most 4 MiB.
  Result<StoredText> read(std::string_view name) const;
  /// Writes by renaming, where the file still is what `based_on` says ("" = not there), and removes its draft. Gives
  /// the new hash, or the conflict. Only .toml and .fll files.
  Result<tl::expected<std::string, Conflict>> save(std::string_view name, std::string_view text,
                                                   const std::string& based_on) const;
  /// Keeps a draft beside the file, by renaming: it survives the end of this program at any moment.
  Result<void> autosave(std::string_view name, std::string_view text, const std::string& based_on) const;
  Result<void> discard(std::string_view name) const;
  bool has_draft(const std::filesystem::path& file) const;

  /// The text of a path below that is no link itself, whatever links are put in its way meanwhile. Fails with NotFound,
  /// Unreadable or TooLarge.
  Result<std::string> text_of(const std::filesystem::path& path, std::size_t max_bytes) const;
  /// The bytes a path below leads to, where it is a link or none. The link is followed as it is now, and no other that
  /// is put in the way meanwhile. Fails as text_of() does.
  Result<std::string> bytes_of(const std::filesystem::path& path, std::size_t max_bytes) const;
  /// Writes a path below, by renaming; no link leads the text out. Fails with NotFound or Unwritable.
  Result<void> put(const std::filesystem::path& path, std::string_view text) const;

 private:
  explicit Folder(std::filesystem::path root) : root_(std::move(root)) {}
  /// From the root on, links followed; none for what lies outside, or behind a link to what is not there.
  std::optional<std::filesystem::path> inner(const std::filesystem::path& path) const;
  /// The same of a path's folder; its last name is taken as it is, be it a link.
  std::optional<std::filesystem::path> seat(const std::filesystem::path& path) const;
  void remove_draft(const std::filesystem::path& file) const;
  std::filesystem::path root_;  ///< Canonical.
};

/// By which a page says what text it had; 16 hex digits.
std::string text_hash(std::string_view text);

}  // namespace ganglion::studio
