#include "ganglion/base/result.h"

#include <algorithm>
#include <tuple>

#include "ganglion/base/text.h"

namespace ganglion {

std::string_view name_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::Syntax:
      return "Syntax";
    case ErrorCode::UnknownKey:
      return "UnknownKey";
    case ErrorCode::MissingKey:
      return "MissingKey";
    case ErrorCode::BadType:
      return "BadType";
    case ErrorCode::BadParameter:
      return "BadParameter";
    case ErrorCode::BadWire:
      return "BadWire";
    case ErrorCode::TooLarge:
      return "TooLarge";
    case ErrorCode::NotFound:
      return "NotFound";
    case ErrorCode::Unreadable:
      return "Unreadable";
    case ErrorCode::Unwritable:
      return "Unwritable";
    case ErrorCode::Corrupt:
      return "Corrupt";
    case ErrorCode::Unsupported:
      return "Unsupported";
    case ErrorCode::LinkLost:
      return "LinkLost";
  }
  return "?";
}

std::string Error::text(Language language) const {
  std::string where = place.file;
  if (place.line > 0) where += fmt::format(":{}:{}", place.line, place.column);
  return printable(where.empty() ? what.in(language) : where + ": " + what.in(language));
}

Sentence Problems::Note::text() const {
  const std::string where = place.line > 0 ? fmt::format("{}:{}:{}", place.file, place.line, place.column) : place.file;
  return say({"{}: note: {}", "{}: nota: {}"}, printable(where), what);
}

std::vector<Error> Problems::sorted() const {
  auto key = [](const Error& error) {
    return std::tie(error.place.file, error.place.line, error.place.column, error.what.en);
  };
  std::vector<Error> result = errors_;
  std::stable_sort(result.begin(), result.end(), [&](const Error& a, const Error& b) { return key(a) < key(b); });
  result.erase(
      std::unique(result.begin(), result.end(), [&](const Error& a, const Error& b) { return key(a) == key(b); }),
      result.end());
  return result;
}

std::string Problems::text(Language language) const {
  std::string lines;
  for (const Error& error : sorted()) lines += error.text(language) + "\n";
  if (untold_ > 0) lines += say({"and {} more problems\n", "y {} problemas más\n"}, untold_).in(language);
  return lines;
}

}  // namespace ganglion
