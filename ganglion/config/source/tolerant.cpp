#include "ganglion/config/source/tolerant.h"

#include <algorithm>

namespace ganglion::config {
namespace {

constexpr int kMostRetries = 20;
/// Of a larger text only the first problem is told, and of one with more broken lines than this only so many.
constexpr std::size_t kMostBytes = std::size_t{1} << 20;
constexpr std::size_t kMostBroken = 1000;

/// Makes a region white, line ends aside, so that places behind it stay as they are.
void blank(std::string& text, Region region) {
  for (std::size_t i = region.begin; i < region.end; ++i) {
    if (text[i] != '\n') text[i] = ' ';
  }
}

/// Blanks every header and member that cannot be read even by itself. False where these are too many.
bool blank_broken(std::string& text, const SourceMap& map, const std::string& file_name, Problems& problems) {
  std::size_t broken = 0;
  const auto look = [&](Region lines, int line) {
    if (broken >= kMostBroken) return;
    auto alone = parse(lines.of(text), file_name);
    if (alone) return;
    Error error = alone.error();
    if (error.place.line > 0) error.place.line += line - 1;
    problems.add(std::move(error));
    blank(text, lines);
    ++broken;
  };
  for (const SectionSource& section : map.sections) {
    if (section.line > 0) look(section.header, section.line);
    for (const MemberSource& member : section.members) {
      if (member.inline_key.empty()) look(member.lines, member.line);
    }
  }
  return broken < kMostBroken;
}

/// The header or member on a line, or the last one before it.
Region region_at(const SourceMap& map, int line) {
  Region found;
  for (const SectionSource& section : map.sections) {
    if (section.line > 0 && section.line <= line) found = section.header;
    for (const MemberSource& member : section.members) {
      if (member.line <= line) found = member.lines;
    }
  }
  return found;
}

}  // namespace

Value parse_tolerantly(std::string_view text, const SourceMap& map, const std::string& file_name, Problems& problems) {
  auto value = parse(text, file_name);
  if (value) return std::move(*value);
  const Value nothing(Members{}, {file_name, 1, 1});
  if (value.error().code == ErrorCode::TooLarge || text.size() > kMostBytes) {
    problems.add(value.error());
    return nothing;
  }
  std::string left(text);
  if (!blank_broken(left, map, file_name, problems)) return nothing;
  for (int i = 0; i < kMostRetries; ++i) {  // what is wrong only together: a key that comes twice
    value = parse(left, file_name);
    if (value) return std::move(*value);
    problems.add(value.error());
    const Region region = region_at(map, value.error().place.line);
    const std::string before = left;
    blank(left, region);
    if (left == before) break;
  }
  return nothing;
}

}  // namespace ganglion::config
