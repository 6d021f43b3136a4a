#include "ganglion/config/format.h"

#include <algorithm>
#include <iterator>

#include "ganglion/config/document.h"

namespace ganglion::config {
namespace {

/// Columns a text takes: its code points.
std::size_t width(std::string_view text) noexcept {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// A comment ends its line and some strings hold line ends: lists with either cannot stand on one line.
bool needs_lines(const Node& node) {
  if (!node.opening.empty()) return true;
  if (node.kind == Node::Kind::Scalar) return node.text.find('\n') != std::string::npos;
  return std::any_of(node.entries.begin(), node.entries.end(),
                     [](const Entry& entry) { return !entry.comment.empty() || needs_lines(entry.value); });
}

std::string on_one_line(const Node& node) {
  if (node.kind == Node::Kind::Scalar) return node.text;
  std::string items;
  for (const Entry& entry : node.entries) {
    if (!items.empty()) items += ", ";
    if (node.kind == Node::Kind::Inline) items += entry.key + " = ";
    items += on_one_line(entry.value);
  }
  if (node.kind == Node::Kind::List) return "[" + items + "]";
  return items.empty() ? "{}" : "{ " + items + " }";
}

class Printer {
 public:
  void print(const Line& line) {
    if (line.blank_before && !out_.empty()) out_ += '\n';
    out_ += line.key;
    if (line.kind == Line::Kind::Member) {
      out_ += " = ";
      print(line.value, 0);
    }
    if (line.kind == Line::Kind::Comment) {
      out_ += line.comment;
    } else {
      print_comment(line.comment);
    }
    out_ += '\n';
  }
  std::string take() noexcept { return std::move(out_); }

 private:
  /// Columns of the line so far; looks no farther back than a full line can reach.
  std::size_t column() const noexcept {
    constexpr std::size_t kReach = 4 * (kFormatColumns + 1);  // a code point has at most 4 bytes
    const std::string_view tail = std::string_view(out_).substr(out_.size() - std::min(out_.size(), kReach));
    const std::size_t newline = tail.rfind('\n');
    return width(tail.substr(newline == std::string_view::npos ? 0 : newline + 1));
  }

  void print_comment(const std::string& comment) {
    if (!comment.empty()) out_ += "  " + comment;
  }

  void print(const Node& node, std::size_t indent) {
    if (node.kind == Node::Kind::Inline && needs_lines(node)) {
      print_inline(node, indent);
      return;
    }
    if (node.kind != Node::Kind::List) {
      out_ += on_one_line(node);
      return;
    }
    if (!needs_lines(node)) {
      const std::string line = on_one_line(node);
      if (node.entries.empty() || column() + width(line) <= kFormatColumns) {
        out_ += line;
        return;
      }
    }
    print_list(node, indent);
  }

  void print_list(const Node& node, std::size_t indent) {
    out_ += '[';
    print_comment(node.opening);
    out_ += '\n';
    for (const Entry& entry : node.entries) {
      if (entry.blank_before && &entry != &node.entries.front()) out_ += '\n';
      out_.append(indent + 2, ' ');
      if (entry.is_comment) {
        out_ += entry.comment;
      } else {
        print(entry.value, indent + 2);
        out_ += ',';
        print_comment(entry.comment);
      }
      out_ += '\n';
    }
    out_.append(indent, ' ');
    out_ += ']';
  }

  /// TOML allows no line ends between members, only inside their values.
  void print_inline(const Node& node, std::size_t indent) {
    out_ += "{ ";
    for (const Entry& entry : node.entries) {
      if (&entry != &node.entries.front()) out_ += ", ";
      out_ += entry.key + " = ";
      print(entry.value, indent);
    }
    out_ += " }";
  }

  std::string out_;
};

/// A header with what stands under it and the comments directly above it; the first may have no header.
using Section = std::vector<Line>;

bool is_layout(const Section& section) {
  const auto header =
      std::find_if(section.begin(), section.end(), [](const Line& line) { return line.kind == Line::Kind::Header; });
  if (header == section.end()) return false;
  const auto name = parse(header->root + " = 0", "");  // a quoted name may be spelt in many ways
  return name && name->table()->size() == 1 && name->table()->front().first == "layout";
}

/// Where the section of a header begins: at the comments that stand directly above it.
std::size_t start_of(const std::vector<Line>& lines, std::size_t header) {
  std::size_t start = header;
  while (start > 0 && !lines[start].blank_before && lines[start - 1].kind == Line::Kind::Comment) --start;
  return start;
}

std::vector<Section> sections_of(std::vector<Line> lines) {
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i - 1].kind == Line::Kind::Header) lines[i].blank_before = false;
  }
  std::vector<Section> sections;
  std::size_t from = 0;
  const auto cut = [&](std::size_t to) {
    const auto begin = std::make_move_iterator(lines.begin());
    sections.emplace_back(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to));
    from = to;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].kind != Line::Kind::Header) continue;
    const std::size_t start = start_of(lines, i);
    lines[start].blank_before = true;
    cut(start);
  }
  cut(lines.size());
  return sections;
}

}  // namespace

Result<std::string> format(std::string_view toml_text, const std::string& file_name) {
  const auto before = parse(toml_text, file_name);
  if (!before) return tl::unexpected<Error>(before.error());
  std::vector<Section> sections = sections_of(read_document(toml_text));
  std::stable_partition(sections.begin(), sections.end(), [](const Section& section) { return !is_layout(section); });
  Printer printer;
  for (const Section& section : sections) {
    for (const Line& line : section) printer.print(line);
  }
  std::string text = printer.take();
  const auto after = parse(text, file_name);
  if (!after)
    return fail_at({file_name}, after.error().code, {"laid out anew, it {}", "con el formato nuevo, {}"},
                   after.error().what);
  if (!equal(*before, *after)) {
    return fail_at({file_name}, ErrorCode::Unsupported,
                   {"cannot be laid out without changing its meaning; it was left as it is",
                    "no se puede dar formato sin cambiar su significado; se dejó como está"});
  }
  return text;
}

}  // namespace ganglion::config
