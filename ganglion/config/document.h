#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ganglion::config {

struct Entry;

/// A value as its author wrote it.
struct Node {
  enum class Kind { Scalar, List, Inline };
  Kind kind = Kind::Scalar;
  std::string text;            ///< Of a scalar: number, word or string, spelt as written; line ends are LF.
  std::string opening;         ///< Of a list: the comment behind its opening bracket.
  std::vector<Entry> entries;  ///< Of a list or an inline table.
};

/// An item of a list, a member of an inline table, or a comment between items.
struct Entry {
  bool blank_before = false;
  bool is_comment = false;  ///< Stands on a line of its own; there is no value.
  std::string key;          ///< Of a member.
  Node value;
  std::string comment;  ///< With its #; "" = none.
};

/// A key with its value, a header, or a comment on a line of its own.
struct Line {
  enum class Kind { Comment, Member, Header };
  Kind kind = Kind::Comment;
  bool blank_before = false;
  std::string key;   ///< Of a member, or of a header with its brackets; blanks round the dots left out.
  std::string root;  ///< The key's first part, as written.
  Node value;
  std::string comment;  ///< With its #; "" = none.
};

/// Everything of a TOML file but its white space, which toml++ does not keep. The text must be one that parse()
/// accepts; of any other it makes something harmless.
std::vector<Line> read_document(std::string_view text);

}  // namespace ganglion::config
