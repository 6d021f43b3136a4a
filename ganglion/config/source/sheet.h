#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ganglion/base/result.h"
#include "ganglion/config/source/source_map.h"

namespace ganglion::config {

/// A TOML text of lists of tables while it is being changed: finds what stands where, and writes in the places found.
class Sheet {
 public:
  /// Items are those of the lists, whose names must outlive the sheet.
  /// Lines that are written end as the first one of the text does.
  Sheet(std::string text, std::span<const std::string_view> lists);

  const std::string& text() const noexcept { return text_; }
  const SourceMap& map() const noexcept { return map_; }
  const std::vector<ItemSource>& items() const noexcept { return items_; }
  std::string take() noexcept { return std::move(text_); }

  /// Null where there is none.
  const ItemSource* find(std::string_view id) const;
  std::vector<std::string> ids() const;
  /// Whether no item has the id.
  bool is_free(std::string_view id) const { return find(id) == nullptr; }
  /// `wanted`, or with the first number behind it that makes it free.
  std::string free_id(const std::string& wanted) const;

  /// A member of an item by its whole key; of the file itself where `id` is "".
  struct Found {
    std::size_t section;
    const MemberSource* member;
  };
  std::optional<Found> member(std::string_view id, std::string_view key) const;
  struct Entry {
    const ItemSource* item;
    std::string key;  ///< In the table: "left" of "in.left".
    const MemberSource* member;
    std::size_t section;
  };
  /// What stands in a table of that name, of every item: of "in" the members whose whole key is "in.*".
  std::vector<Entry> entries(std::string_view table) const;

  /// The key of a member as it is written, dots and quotes included.
  Region key_of(const MemberSource& member) const noexcept;

  /// Notes a change; nothing moves until commit(). Regions must not overlap. Line ends are given as line feeds.
  void replace(Region region, std::string by) { changes_.push_back({region, std::move(by)}); }
  void insert(std::size_t at, std::string what) { replace({at, at}, std::move(what)); }
  void commit();

  /// Notes: the member has this value, made where it is missing. One that says the same in other words stays as it is.
  void set(std::string_view id, const std::string& key, const std::string& toml);
  /// Notes: the member is gone, with its line and the comment on it.
  void erase(std::string_view id, const Found& found);
  /// Commits at once: in = { left = "a" } becomes in.left = "a".
  void expand_inline(std::string_view id, std::string_view key);

 private:
  struct Change {
    Region region;
    std::string by;
  };
  void look();
  std::string indent_of(const SectionSource& section) const;

  std::string text_;
  bool crlf_ = false;
  std::span<const std::string_view> lists_;
  SourceMap map_;
  std::vector<ItemSource> items_;
  std::unordered_map<std::string, std::size_t> by_id_;  ///< The first of each id.
  std::vector<Change> changes_;
};

}  // namespace ganglion::config
