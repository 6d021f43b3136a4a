#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/files.h"
#include "ganglion/config/outline.h"
#include "ganglion/config/range.h"
#include "ganglion/config/value.h"
#include "ganglion/descriptor/parameters.h"

namespace ganglion::config {

/// Reads one table of a file, key by key. Whatever is wrong goes into the Problems with its place, and a default stands
/// in, so that one pass finds everything. Keys that nobody asked for are reported by finish(), or by the destructor.
class Table {
 public:
  /// `context` opens each message: a component's id, "" for none. The value must outlive the table, and so must
  /// `outline`: where there is one it notes whatever is asked of the table and of those inside it. A list of tables
  /// that is absent then reads as one empty table of which no problem is told, so that its keys are asked for as well.
  Table(const Value& value, std::string context, Problems& problems, Outline* outline = nullptr);
  Table(Table&&) noexcept;
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  /// Who opens the files that are named in it and in the tables inside; must outlive it.
  Table& opens_by(FileReader* files) noexcept {
    files_ = files;
    return *this;
  }
  ~Table() { finish(); }

  bool has(std::string_view key) const;
  /// The value as it stands, or null; the key counts as read.
  const Value* value(std::string_view key);
  /// Where it stands; of an absent table where the one around it stands.
  const Place& place() const noexcept { return place_; }
  Place place(std::string_view key) const;
  const std::string& context() const noexcept { return context_; }
  Problems& problems() const noexcept { return *problems_; }
  void set_context(std::string context) { context_ = std::move(context); }

  /// With a default: absent is fine. Without: absent is a MissingKey problem. Numbers must be finite.
  double number(std::string_view key, double preset, const Range& range = {});
  double number(std::string_view key, const Range& range = {});
  int integer(std::string_view key, int preset, const Range& range = {});
  bool boolean(std::string_view key, bool preset);
  std::string text(std::string_view key, std::string_view preset);
  std::string text(std::string_view key);
  /// One of `choices`; gives its index.
  int choice(std::string_view key, std::span<const std::string_view> choices, int preset);
  /// `count` numbers (0 = any number of them: one may stand without brackets).
  std::vector<double> numbers(std::string_view key, std::vector<double> preset, std::size_t count = 0,
                              const Range& range = {});
  std::vector<std::string> texts(std::string_view key);
  /// A path, relative to the folder of the file it stands in; behind --set to the working directory. Empty if absent.
  std::filesystem::path path(std::string_view key);
  /// The index of the file it names, opened as path() says; -1 where the key is absent, or the file cannot be read,
  /// which is reported at the key. Without somebody to open files nothing is opened.
  int open(std::string_view key, std::string_view role, std::size_t most_bytes);
  /// A table inside; an empty one if absent.
  Table table(std::string_view key);
  /// A list of tables, [[key]]; empty if absent.
  std::vector<Table> tables(std::string_view key);
  /// Every parameter of a kind. Files are opened as "list.id.parameter".
  Parameters parameters(std::span<const ParameterDescriptor> descriptors);

  /// Marks a key as known without reading it.
  void known(std::string_view key);
  /// Tells the outline, if there is one, of a key that is read by its value().
  void asks(std::string_view key, Asked asked) const;
  /// Tells it of which kind the table is.
  void is_of(const Descriptor& kind) const;
  /// The keys of the table, in file order.
  std::vector<std::string> keys() const;
  /// All that stands in it, known or not.
  const Members& members() const noexcept { return *value_->table(); }
  /// Reports unknown keys, each with the nearest known one.
  void finish();

  /// A problem at one of its keys, or at the table where the key is absent.
  template <class... Args>
  void problem(std::string_view key, ErrorCode code, Wording<std::type_identity_t<Args>...> words,
               const Args&... args) const {
    report(place(key), code, say<Args...>(words, args...), Subject{.part = std::string(key)});
  }
  /// Nothing is wrong with a key, but there is a better way to say it.
  template <class... Args>
  void note(std::string_view key, Wording<std::type_identity_t<Args>...> words, const Args&... args) const {
    problems_->note(place(key), say<Args...>(words, args...));
  }
  /// An error that was worded elsewhere, or that is about another part than the key. One that knows a file keeps its place.
  void problem(std::string_view key, Error error) const;

 private:
  void report(const Place& where, ErrorCode code, Sentence what, Subject subject = {}) const;
  void missing(std::string_view key) const;
  void wrong_type(std::string_view key, const Value& found, const Sentence& wanted) const;
  Outline* inside(std::string_view key, Asked::Form form) const;
  double checked(std::string_view key, const Value& found, double preset, const Range& range) const;
  Table within(const Value& value, std::string context, std::string_view key, Asked::Form form) const;
  std::optional<FileText> file_text(std::string_view key, const FileText& preset);
  void read(const ParameterDescriptor& descriptor, Parameters& into);

  const Value* value_;
  Place place_;
  std::string context_;
  Problems* problems_;
  Outline* outline_;             ///< Null: nobody wants one.
  FileReader* files_ = nullptr;  ///< Null: nothing is opened.
  std::string list_;             ///< The key it stands under.
  std::set<std::string, std::less<>> known_;
  bool finished_ = false;
  bool mute_ = false;  ///< Is no table at all, which was reported: nothing in it can be judged.
};

/// Checks `format = 1`, which every file of ours starts with.
void check_format(Table& root);

}  // namespace ganglion::config
