#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/result.h"

namespace ganglion {

/// A file that was read. Its text is read once: whoever hashes, attaches or replays it takes it from here.
struct OpenedFile {
  std::string role;                         ///< What it is read as: "controller", "world", "map", "acting.wall.rules".
  std::string named;                        ///< As written where it is named.
  std::filesystem::path resolved;           ///< Where it was found; empty: a text that is part of the program.
  std::shared_ptr<const std::string> text;  ///< Never null; shared by all copies.
  int by = -1;                              ///< Index of the file that names it; -1 = whoever called, or --set.
  std::uint64_t hash() const noexcept;
};

/// Whoever reads experiments, controllers, robots, worlds and maps opens files through this and through nothing else:
/// its list is what the run depends on.
class FileReader {
 public:
  FileReader() = default;
  FileReader(const FileReader&) = delete;
  FileReader& operator=(const FileReader&) = delete;
  virtual ~FileReader() = default;

  /// The index of the file in opened(); one that was opened before is not read again. A relative name is relative to
  /// the folder of the file that names it, else to the working directory. Fails with NotFound, Unreadable (also folders,
  /// devices, circles of links), TooLarge, or BadParameter where it lies outside of what may be read.
  Result<int> open(std::string_view role, std::string_view named, int by, std::size_t most_bytes);
  /// Takes a text in as if it had been read from `place`: what is being edited, or stands in a program. From then on
  /// whoever opens that place gets it.
  int hold(std::string_view role, const std::filesystem::path& place, std::string text);
  /// The same of a text that is part of the program and known by name; a recorded run gives the one it was made with.
  int builtin(std::string_view role, std::string_view named, std::string_view text, int by);

  std::span<const OpenedFile> opened() const noexcept { return opened_; }
  const OpenedFile& at(int index) const noexcept { return opened_[static_cast<std::size_t>(index)]; }
  /// The first that was found at that place, as a Place::file says it; -1 if none was.
  int index_of(std::string_view place) const;

 protected:
  /// Where the name leads.
  virtual std::filesystem::path resolve(std::string_view role, std::string_view named, int by) const;
  virtual Result<std::string> read(const std::filesystem::path& resolved, std::size_t most_bytes) = 0;
  /// Null: the program's own.
  virtual const std::string* recorded_builtin(std::string_view role, std::string_view named) const;

 private:
  int find(std::string_view role, std::string_view named, int by) const noexcept;
  std::vector<OpenedFile> opened_;
};

/// Reads whatever the system lets it.
class DiskFiles final : public FileReader {
 private:
  Result<std::string> read(const std::filesystem::path& resolved, std::size_t most_bytes) override;
};

}  // namespace ganglion
