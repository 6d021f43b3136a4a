#include <algorithm>

#include "ganglion/config/value.h"

namespace ganglion::config {
namespace {

std::vector<const std::pair<std::string, Value>*> by_key(const Members& members) {
  std::vector<const std::pair<std::string, Value>*> sorted;
  for (const auto& member : members) sorted.push_back(&member);
  std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return a->first < b->first; });
  return sorted;
}

bool equal_tables(const Members& a, const Members& b) {
  const auto mine = by_key(a), theirs = by_key(b);
  return std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(),
                    [](const auto* x, const auto* y) { return x->first == y->first && equal(x->second, y->second); });
}

}  // namespace

bool equal(const Value& a, const Value& b) {
  if (a.type() != b.type()) return false;
  switch (a.type()) {
    case Value::Type::None:
      return true;
    case Value::Type::Boolean:
      return *a.boolean() == *b.boolean();
    case Value::Type::Integer:
      return *a.integer() == *b.integer();
    case Value::Type::Real:
      return *a.real() == *b.real() || (*a.real() != *a.real() && *b.real() != *b.real());
    case Value::Type::String:
      return *a.string() == *b.string();
    case Value::Type::List:
      return std::equal(a.array()->begin(), a.array()->end(), b.array()->begin(), b.array()->end(), equal);
    case Value::Type::Table:
      return equal_tables(*a.table(), *b.table());
  }
  return false;
}

}  // namespace ganglion::config
