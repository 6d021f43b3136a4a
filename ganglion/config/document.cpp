#include "ganglion/config/document.h"

#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/config/lexer.h"

namespace ganglion::config {
namespace {

bool is_bare(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  std::vector<Line> run() {
    std::vector<Line> lines;
    bool blank = false;
    while (skip_blanks(), !ended()) {
      if (peek() == '\n') {
        ++at_;
        blank = true;
        continue;
      }
      Line line = read_line();
      line.blank_before = blank;
      lines.push_back(std::move(line));
      blank = false;
      if (peek() == '\n') ++at_;
    }
    return lines;
  }

 private:
  bool ended() const noexcept { return at_ >= text_.size(); }
  char peek() const noexcept { return ended() ? '\0' : text_[at_]; }
  bool at_quote() const noexcept { return peek() == '"' || peek() == '\''; }
  void skip_blanks() noexcept {
    while (peek() == ' ' || peek() == '\t' || peek() == '\r') ++at_;
  }

  std::string read_comment() {
    const std::size_t from = at_;
    at_ = comment_end(text_, at_);
    return std::string(trimmed(text_.substr(from, at_ - from)));
  }

  std::string read_string() {
    const std::size_t from = at_;
    at_ = string_end(text_, at_);
    std::string string(text_.substr(from, at_ - from));
    std::erase(string, '\r');
    return string;
  }

  std::string read_key(std::string& root) {
    std::string key;
    while (true) {
      skip_blanks();
      if (at_quote()) key += read_string();
      while (is_bare(peek())) key += text_[at_++];
      if (root.empty()) root = key;
      skip_blanks();
      if (peek() != '.') return key;
      key += text_[at_++];
    }
  }

  Line read_line() {
    Line line;
    if (peek() == '#') {
      line.comment = read_comment();
      return line;
    }
    if (peek() == '[') {
      read_header(line);
    } else {
      read_member(line);
    }
    skip_blanks();
    if (peek() == '#') line.comment = read_comment();
    return line;
  }

  void read_header(Line& line) {
    line.kind = Line::Kind::Header;
    std::string brackets;
    while (peek() == '[') brackets += text_[at_++];
    line.key = brackets + read_key(line.root) + std::string(brackets.size(), ']');
    while (peek() == ']') ++at_;
  }

  void read_member(Line& line) {
    line.kind = Line::Kind::Member;
    line.key = read_key(line.root);
    if (peek() == '=') ++at_;
    skip_blanks();
    line.value = read_value();
  }

  Node read_value() {
    Node node;
    if (peek() == '[' || peek() == '{') {
      node.kind = peek() == '[' ? Node::Kind::List : Node::Kind::Inline;
      const char closing = text_[at_++] == '[' ? ']' : '}';
      read_entries(node, closing);
    } else if (at_quote()) {
      node.text = read_string();
    } else {
      constexpr std::string_view kEnds = " \t\r\n,]}#";
      while (!ended() && kEnds.find(peek()) == std::string_view::npos) node.text += text_[at_++];
      if (node.text.empty() && !ended()) ++at_;  // not TOML: go on, so that every text comes to its end
    }
    return node;
  }

  void read_entries(Node& node, char closing) {
    int newlines = 0;  // since the last value or comment
    while (skip_blanks(), !ended()) {
      const char c = peek();
      if (c == '\n' || c == ',' || c == closing) {
        ++at_;
        if (c == closing) return;
        newlines += c == '\n' ? 1 : 0;
        continue;
      }
      if (c == '#') {
        take_comment(node, newlines);
      } else {
        Entry entry;
        std::string root;
        entry.blank_before = newlines > 1;
        if (node.kind == Node::Kind::Inline) {
          entry.key = read_key(root);
          if (peek() == '=') ++at_;
          skip_blanks();
        }
        entry.value = read_value();
        node.entries.push_back(std::move(entry));
      }
      newlines = 0;
    }
  }

  /// A comment belongs to what stands before it on its line, if anything does.
  void take_comment(Node& node, int newlines) {
    std::string comment = read_comment();
    if (newlines == 0 && node.entries.empty() && node.opening.empty()) {
      node.opening = std::move(comment);
    } else if (newlines == 0 && !node.entries.empty() && node.entries.back().comment.empty()) {
      node.entries.back().comment = std::move(comment);
    } else {
      Entry entry;
      entry.is_comment = true;
      entry.blank_before = newlines > 1;
      entry.comment = std::move(comment);
      node.entries.push_back(std::move(entry));
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<Line> read_document(std::string_view text) { return Reader(text).run(); }

}  // namespace ganglion::config
