#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ganglion::config {

/// A stretch of a text, [begin, end) in bytes.
struct Region {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const noexcept { return end - begin; }
  std::string_view of(std::string_view text) const noexcept { return text.substr(begin, size()); }
};

/// `key = value` where it stands in a text.
struct MemberSource {
  std::string key;  ///< Without quotes, parts joined by dots, from the section on: "in.left"; "" = not understood.
  Region lines;     ///< Whole lines, comment and line end included.
  Region value;
  int line = 0;       ///< First line, from 1.
  int last_line = 0;  ///< Last line of the value.
  /// Stands in an inline table, in = { left = "a" }: `lines` are those of the whole, and `inline_key` is its key.
  std::string inline_key;
};

/// A header with what stands below it.
struct SectionSource {
  std::string name;          ///< "acting", "acting.in", "layout"; "" = what stands before the first header.
  bool list = false;         ///< [[name]].
  std::size_t begin = 0;     ///< At the comments that stand directly above the header.
  Region header;             ///< Its line; empty before the first header.
  std::size_t body_end = 0;  ///< Behind the last member, or the header where there is none.
  std::size_t end = 0;       ///< Where the next section begins.
  int line = 0;
  std::vector<MemberSource> members;

  const MemberSource* member(std::string_view key) const noexcept;
};

/// Where everything stands in the text of a TOML file, right or wrong: of a text that is no TOML it tells what it can.
struct SourceMap {
  std::vector<SectionSource> sections;  ///< The first is the nameless one.
};
SourceMap map_source(std::string_view text);

/// One item of a list of tables where it stands: a [[list]] section and the [list.sub] sections that belong to it.
struct ItemSource {
  std::string list;                   ///< As written: "acting".
  std::string id;                     ///< "" = there is none.
  std::vector<std::size_t> sections;  ///< Indices into SourceMap::sections, the [[list]] first.

  /// What the keys of one of its sections go on from: "in." in [acting.in], "" in [[acting]].
  std::string prefix(const SourceMap& map, std::size_t section) const;
};
/// In file order; only items of these lists.
std::vector<ItemSource> items_of(const SourceMap& map, std::string_view text, std::span<const std::string_view> lists);

/// The text a TOML string stands for; "" of anything else.
std::string unquoted(std::string_view toml);
/// As a TOML string.
std::string toml_text(std::string_view text);
/// The strings in a value: the value itself, or the items of a list.
std::vector<Region> strings_in(std::string_view text, Region value);

}  // namespace ganglion::config
