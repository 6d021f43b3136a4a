#pragma once

#include <list>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ganglion/config/range.h"
#include "ganglion/descriptor/descriptor.h"

namespace ganglion::config {

class Outline;

/// How a reader asked for one key: all that an editor can know of it.
struct Asked {
  enum class Form { Number, Whole, Boolean, Text, Choice, Numbers, Texts, Points, Table, Tables };
  using Preset = std::variant<std::monostate, bool, double, std::string, std::vector<double>>;

  Form form = Form::Text;
  bool required = false;  ///< Absent is a problem.
  Range range{};          ///< Of Number and Whole, and of each number in Numbers and Points.
  std::size_t least = 0;  ///< Fewest items of Numbers and Points.
  std::size_t most = 0;   ///< Most items; 0 = any number of them.
  std::vector<std::string> choices{};
  Preset preset{};
  const ParameterDescriptor* parameter = nullptr;  ///< Where there is one it says all of this, and help besides.
  std::list<Outline> inside{};                     ///< Of Table and Tables: each such table that was read.
};

/// What a reader asked of one table while it read a sample. Schemas are made from it, so that the reader is the one
/// list of keys there is.
class Outline {
 public:
  struct Key {
    std::string name;
    Asked asked;
  };

  /// Of several questions for one key the first counts; it is required where any of them required it.
  Asked& ask(std::string_view key, Asked asked);
  /// The reader knows of the key, asked or not: there must be a sample in which it asks.
  void mention(std::string_view key) { mentioned_.emplace(key); }
  /// The table is of this kind; its parameters may differ from those of other kinds beside it.
  void be(const Descriptor& kind) noexcept { kind_ = &kind; }

  const Asked* find(std::string_view key) const noexcept;
  /// In the order they were asked for.
  const std::list<Key>& keys() const noexcept { return keys_; }
  const std::set<std::string, std::less<>>& mentioned() const noexcept { return mentioned_; }
  const Descriptor* kind() const noexcept { return kind_; }

 private:
  std::list<Key> keys_;  // tables inside are pointed to while they are read: nothing may move
  std::set<std::string, std::less<>> mentioned_;
  const Descriptor* kind_ = nullptr;
};

}  // namespace ganglion::config
