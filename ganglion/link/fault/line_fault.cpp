#include "ganglion/link/fault/line_fault.h"

#include <algorithm>
#include <cmath>

#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"
#include "ganglion/random/draws.h"

namespace ganglion::link {
namespace {

constexpr std::size_t kMostFaults = 100;
constexpr double kLongestTime_s = 86'400;
constexpr double kLongestDelay_s = 60;

struct TimeKey {
  std::string_view name;
  double LineFault::*value;
  double most_s;
};
constexpr std::array kTimes = {
    TimeKey{"delay", &LineFault::delay_s, kLongestDelay_s}, TimeKey{"jitter", &LineFault::jitter_s, kLongestDelay_s},
    TimeKey{"from", &LineFault::from_s, kLongestTime_s}, TimeKey{"until", &LineFault::until_s, kLongestTime_s}};

struct ShareKey {
  std::string_view name;
  double LineFault::*value;
};
constexpr std::array kShares = {ShareKey{"loss", &LineFault::loss},       ShareKey{"duplicate", &LineFault::duplicate},
                                ShareKey{"merge", &LineFault::merge},     ShareKey{"split", &LineFault::split},
                                ShareKey{"corrupt", &LineFault::corrupt}, ShareKey{"fin", &LineFault::fin},
                                ShareKey{"rst", &LineFault::rst}};

struct Word {
  std::string_view name;
  bool LineFault::*value;
};
constexpr std::array kWords = {Word{"mute", &LineFault::mute}, Word{"freeze", &LineFault::freeze}};

std::vector<std::string> known_keys() {
  std::vector<std::string> names;
  for (const ShareKey& key : kShares) names.emplace_back(key.name);
  for (const Word& word : kWords) names.emplace_back(word.name);
  for (const TimeKey& key : kTimes) names.emplace_back(key.name);
  names.emplace_back("to");
  return names;
}

/// Reads one text of faults; every view lies in it, so that each has a column.
class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<LineFaults> read() const {
    LineFaults faults;
    if (trimmed(text_).empty() || trimmed(text_) == "none") return faults;
    for (const std::string_view part : parts(text_, ';')) {
      if (faults.size() == kMostFaults) {
        return fail_at(place(part), ErrorCode::TooLarge, {"more than 100 faults", "más de 100 fallos"});
      }
      auto fault = read_fault(part);
      if (!fault) return tl::unexpected<Error>(fault.error());
      faults.push_back(*fault);
    }
    return faults;
  }

 private:
  Place place(std::string_view part) const { return {name_, 1, static_cast<int>(part.data() - text_.data()) + 1}; }

  static std::vector<std::string_view> parts(std::string_view text, char separator) {
    std::vector<std::string_view> found;
    for (std::size_t begin = 0;;) {
      const std::size_t end = std::min(text.find(separator, begin), text.size());
      found.push_back(trimmed(text.substr(begin, end - begin)));
      if (end == text.size()) return found;
      begin = end + 1;
    }
  }

  Result<LineFault> read_fault(std::string_view part) const {
    LineFault fault;
    for (const std::string_view item : parts(part, ',')) {
      if (auto read = read_item(item, fault); !read) return tl::unexpected<Error>(read.error());
    }
    if (!(fault.from_s < fault.until_s)) {
      return fail_at(place(part), ErrorCode::BadParameter,
                     {"from={}s must lie before until={}s", "from={}s debe quedar antes de until={}s"},
                     shortest(fault.from_s), shortest(fault.until_s));
    }
    if (fault.freeze && std::isinf(fault.until_s)) {
      return fail_at(place(part), ErrorCode::BadParameter,
                     {"freeze needs an end, as in freeze,from=4s,until=6s",
                      "freeze necesita un final, como en freeze,from=4s,until=6s"});
    }
    return fault;
  }

  Result<void> read_item(std::string_view item, LineFault& fault) const {
    const std::size_t equals = item.find('=');
    const std::string_view key = trimmed(item.substr(0, equals));
    const std::string_view value = equals == std::string_view::npos ? "" : trimmed(item.substr(equals + 1));
    for (const Word& word : kWords) {
      if (key != word.name) continue;
      if (equals != std::string_view::npos) {
        return fail_at(place(item), ErrorCode::Syntax, {"{} stands alone, without a value", "{} va solo, sin valor"},
                       key);
      }
      fault.*word.value = true;
      return {};
    }
    for (const TimeKey& time : kTimes) {
      if (key == time.name) return read_time(item, time, value, fault);
    }
    for (const ShareKey& share : kShares) {
      if (key == share.name) return read_share(item, share, value, fault);
    }
    if (key == "to") return read_way(item, value, fault);
    const std::string found = printable(key, 50);
    const std::vector<std::string> keys = known_keys();
    return tl::unexpected<Error>(Error{
        ErrorCode::UnknownKey,
        say({"\"{}\" is no fault of a line{}", "\"{}\" no es un fallo de una línea{}"}, found, suggestion(key, keys)),
        place(item),
        {.found = found, .choices = keys}});
  }

  Result<void> read_time(std::string_view item, const TimeKey& key, std::string_view value, LineFault& fault) const {
    constexpr std::array<std::pair<std::string_view, double>, 3> kUnits = {{{"ms", 0.001}, {"min", 60}, {"s", 1}}};
    for (const auto& [unit, scale] : kUnits) {
      if (!value.ends_with(unit)) continue;
      const auto number = parse_number(trimmed(value.substr(0, value.size() - unit.size())));
      // A division, so that 20ms is the double nearest to 0.02.
      const double time_s = !number ? -1 : unit == "ms" ? *number / 1000 : *number * scale;
      if (!(time_s >= 0 && time_s <= key.most_s)) break;
      fault.*key.value = time_s;
      return {};
    }
    return fail_at(place(item), ErrorCode::BadParameter,
                   {"{}={}: must be a time from 0s to {}s, as in 20ms, 1.5s, 2min",
                    "{}={}: debe ser un tiempo de 0s a {}s, como 20ms, 1.5s, 2min"},
                   key.name, printable(value, 50), shortest(key.most_s));
  }

  Result<void> read_share(std::string_view item, const ShareKey& key, std::string_view value, LineFault& fault) const {
    const bool percent = value.ends_with('%');
    auto number = parse_number(percent ? trimmed(value.substr(0, value.size() - 1)) : value);
    if (number && percent) *number /= 100;
    if (!number || !(*number >= 0 && *number <= 1)) {
      return fail_at(place(item), ErrorCode::BadParameter,
                     {"{}={}: must be a share from 0 to 1, or 0% to 100%",
                      "{}={}: debe ser una proporción de 0 a 1, o de 0% a 100%"},
                     key.name, printable(value, 50));
    }
    fault.*key.value = *number;
    return {};
  }

  Result<void> read_way(std::string_view item, std::string_view value, LineFault& fault) const {
    if (value != "robot" && value != "controller" && value != "both") {
      return fail_at(place(item), ErrorCode::BadParameter,
                     {"to={}: must be robot, controller or both", "to={}: debe ser robot, controller o both"},
                     printable(value, 50));
    }
    fault.to_robot = value != "controller";
    fault.to_controller = value != "robot";
    return {};
  }

  std::string_view text_;
  const std::string& name_;
};

std::string text_of(const LineFault& fault) {
  const LineFault nothing;
  std::string text;
  const auto add = [&text](std::string_view item) { text.append(text.empty() ? "" : ",").append(item); };
  for (const Word& word : kWords) {
    if (fault.*word.value) add(word.name);
  }
  for (const ShareKey& key : kShares) {
    if (fault.*key.value > 0) add(fmt::format("{}={}", key.name, shortest(fault.*key.value)));
  }
  for (const TimeKey& key : kTimes) {
    if (fault.*key.value != nothing.*key.value) add(fmt::format("{}={}s", key.name, shortest(fault.*key.value)));
  }
  if (!fault.to_robot || !fault.to_controller) add(fault.to_robot ? "to=robot" : "to=controller");
  return text.empty() ? "delay=0s" : text;
}

double milliseconds(double time_s) noexcept { return std::floor(time_s * 1000) / 1000; }

double share(Draws& draws, double most) noexcept { return std::ceil(draws.uniform(0, most) * 1000) / 1000; }

void draw_kind(Draws& draws, Hardness hardness, LineFault& fault) {
  switch (draws.below(hardness == Hardness::Any ? 10 : 8)) {
    case 0:
    case 1:
      fault.delay_s = milliseconds(draws.uniform(0, 0.15));
      fault.jitter_s = milliseconds(draws.uniform(0, 0.1));
      break;
    case 2:
      fault.merge = share(draws, 1);
      fault.split = share(draws, 1);
      break;
    case 3:
      fault.loss = share(draws, 0.5);
      break;
    case 4:
      fault.mute = true;
      break;
    case 5:
      fault.freeze = true;
      break;
    case 6:
      fault.fin = share(draws, 0.2);
      break;
    case 7:
      fault.rst = share(draws, 0.2);
      break;
    case 8:
      fault.duplicate = share(draws, 0.5);
      break;
    default:
      fault.corrupt = share(draws, 0.02);
  }
}

}  // namespace

Result<LineFaults> parse_line_faults(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

std::string text_of(const LineFaults& faults) {
  std::string text;
  for (const LineFault& fault : faults) text.append(text.empty() ? "" : "; ").append(text_of(fault));
  return text.empty() ? "none" : text;
}

LineFaults drawn_line_faults(std::uint64_t seed, Hardness hardness) {
  Draws draws({.seed = seed, .component = hash_name("@line faults")}, 0);
  LineFaults faults(1 + draws.below(4));
  for (LineFault& fault : faults) {
    const std::uint32_t way = draws.below(4);
    fault.to_robot = way != 0;
    fault.to_controller = way != 1;
    fault.from_s = milliseconds(draws.uniform(0, 4));
    fault.until_s = milliseconds(fault.from_s + draws.uniform(0.05, 4));
    draw_kind(draws, hardness, fault);
    const bool bearable = fault.delay_s + fault.jitter_s + fault.merge + fault.split > 0;
    if (bearable && draws.below(2) == 0) fault.until_s = LineFault().until_s;
  }
  return faults;
}

}  // namespace ganglion::link
