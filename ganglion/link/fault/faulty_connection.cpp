#include "ganglion/link/fault/faulty_connection.h"

#include <algorithm>
#include <utility>

#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

}  // namespace

Sentence FaultCounts::text() const {
  Sentence text = say({"{} frame{}", "{} trama{}"}, frames, frames == 1 ? "" : "s");
  const auto add = [&text](std::uint32_t count, const Text& what) {
    if (count > 0) text += say({", {} {}", ", {1}: {0}"}, count, what);
  };
  add(lost, {"lost", "perdidas"});
  add(duplicated, {"duplicated", "duplicadas"});
  add(merged, {"merged with the next", "unidas a la siguiente"});
  add(split, {"split", "partidas"});
  add(corrupted_bytes, {"bytes changed", "bytes cambiados"});
  return text;
}

FaultyConnection::FaultyConnection(const LineFaults& faults, std::uint64_t seed, std::uint32_t number, Carrier carrier)
    : faults_(faults),
      seed_(seed),
      number_(number),
      carrier_(carrier),
      directions_{Direction(carrier), Direction(carrier)} {}

bool FaultyConnection::acts(const LineFault& fault, Way way, double at_s) const noexcept {
  return (way == Way::ToRobot ? fault.to_robot : fault.to_controller) && at_s >= fault.from_s && at_s < fault.until_s;
}

Draws FaultyConnection::draws(std::size_t fault, std::string_view name, Way way) const {
  const std::uint64_t component = combine(hash_name("@line fault"), combine(fault, hash_name(name)));
  return Draws({seed_, number_, static_cast<std::uint32_t>(way), component}, of(way).frame);
}

bool FaultyConnection::happens(double LineFault::*share, std::string_view name, Way way, double now_s) const {
  for (std::size_t n = 0; n < faults_.size(); ++n) {
    const double chance = faults_[n].*share;
    if (chance > 0 && acts(faults_[n], way, now_s) && draws(n, name, way).uniform() < chance) return true;
  }
  return false;
}

bool FaultyConnection::muted(Way way, double now_s) const noexcept {
  return std::any_of(faults_.begin(), faults_.end(),
                     [&](const LineFault& fault) { return fault.mute && acts(fault, way, now_s); });
}

double FaultyConnection::arrival_s(Way way, double now_s) {
  double at_s = now_s;
  for (std::size_t n = 0; n < faults_.size(); ++n) {
    const LineFault& fault = faults_[n];
    if (!acts(fault, way, now_s)) continue;
    at_s += fault.delay_s;
    if (fault.jitter_s > 0) at_s += fault.jitter_s * draws(n, "jitter", way).uniform();
  }
  // The end of one freeze may lie in another one: as many rounds as there are faults reach the last of them.
  for (std::size_t round = 0; round < faults_.size(); ++round) {
    for (const LineFault& fault : faults_) {
      if (!fault.freeze || !acts(fault, way, at_s)) continue;
      at_s = fault.until_s;
      strike(at_s);
    }
  }
  return at_s;
}

void FaultyConnection::push(Way way, std::string_view bytes, double now_s) {
  Direction& direction = of(way);
  if (reset_ || direction.ended) return;
  direction.cutter.feed(bytes);
  while (auto frame = direction.cutter.next()) {
    carry(way, std::move(*frame), now_s);
    if (reset_ || direction.ended) return;
  }
}

void FaultyConnection::finish(Way way, double now_s) {
  Direction& direction = of(way);
  if (reset_ || direction.ended || carrier_ == Carrier::Packets) return;
  const std::string rest = direction.cutter.take_rest();
  if (!rest.empty()) carry(way, rest, now_s);
  if (reset_ || direction.ended) return;
  direction.ended = true;
  if (muted(way, now_s)) return strike(now_s);
  put(way, {.at_s = arrival_s(way, now_s), .end = true});
}

void FaultyConnection::carry(Way way, std::string frame, double now_s) {
  Direction& direction = of(way);
  ++direction.counts.frames;
  if (muted(way, now_s) || happens(&LineFault::loss, "loss", way, now_s)) {
    ++direction.counts.lost;
    strike(now_s);
  } else if (!cut(way, frame, now_s)) {
    corrupt(way, frame, now_s);
    dispatch(way, frame, now_s);
    if (happens(&LineFault::duplicate, "duplicate", way, now_s)) {
      ++direction.counts.duplicated;
      strike(now_s);
      dispatch(way, frame, now_s);
    }
  }
  ++direction.frame;
}

bool FaultyConnection::cut(Way way, const std::string& frame, double now_s) {
  const bool at_once = happens(&LineFault::rst, "rst", way, now_s);
  const bool in_order = carrier_ == Carrier::Stream && happens(&LineFault::fin, "fin", way, now_s);
  if (!at_once && !in_order) return false;
  strike(now_s);
  if (at_once) {
    reset_ = carrier_ == Carrier::Stream;
    for (Direction& one : directions_) {
      one.under_way.clear();
      one.pending = 0;
    }
    return true;
  }
  const std::uint32_t kept = draws(0, "end", way).below(static_cast<std::uint32_t>(frame.size()));
  if (kept > 0) dispatch(way, frame.substr(0, kept), now_s);
  for (const Way each : {Way::ToRobot, Way::ToController}) {
    if (std::exchange(of(each).ended, true)) continue;
    put(each, {.at_s = arrival_s(each, now_s), .end = true});
  }
  return true;
}

void FaultyConnection::corrupt(Way way, std::string& frame, double now_s) {
  for (std::size_t n = 0; n < faults_.size(); ++n) {
    if (faults_[n].corrupt <= 0 || !acts(faults_[n], way, now_s)) continue;
    Draws own = draws(n, "corrupt", way);
    for (char& byte : frame) {
      if (own.uniform() >= faults_[n].corrupt) continue;
      byte = static_cast<char>(byte ^ (1 << own.below(8)));
      ++of(way).counts.corrupted_bytes;
      strike(now_s);
    }
  }
}

/// Sends a frame on its way, in one piece or several.
void FaultyConnection::dispatch(Way way, const std::string& frame, double now_s) {
  Direction& direction = of(way);
  double at_s = arrival_s(way, now_s);
  std::size_t begin = 0;
  if (frame.size() > 1 && happens(&LineFault::split, "split", way, now_s)) {
    ++direction.counts.split;
    Draws own = draws(0, "places", way);
    for (std::uint32_t left = 1 + own.below(3); left > 0 && frame.size() - begin > 1; --left) {
      const std::size_t size = 1 + own.below(static_cast<std::uint32_t>(frame.size() - begin - 1));
      put(way, {.at_s = at_s, .bytes = frame.substr(begin, size)});
      begin += size;
      at_s += kSplitGap_s;
    }
  }
  const bool merges = happens(&LineFault::merge, "merge", way, now_s);
  if (merges) ++direction.counts.merged;
  put(way, {.at_s = merges ? at_s + kMergePatience_s : at_s,
            .bytes = frame.substr(begin),
            .merges = merges,
            .set_out_s = at_s});
}

void FaultyConnection::put(Way way, Parcel parcel) {
  Direction& direction = of(way);
  direction.pending += parcel.bytes.size();
  Parcel* before = direction.under_way.empty() ? nullptr : &direction.under_way.back();
  if (before != nullptr && before->merges && parcel.at_s <= before->at_s) {
    before->at_s = parcel.merges ? before->at_s : std::max(before->set_out_s, parcel.at_s);
    before->merges = parcel.merges;
    before->bytes += parcel.bytes;
    before->end = parcel.end;
  } else {
    parcel.set_out_s = std::max(parcel.set_out_s, direction.last_s);
    parcel.at_s = std::max(parcel.at_s, direction.last_s);
    direction.under_way.push_back(std::move(parcel));
  }
  direction.last_s = direction.under_way.back().at_s;
}

std::optional<FaultyConnection::Arrival> FaultyConnection::take(Way way, double now_s) {
  Direction& direction = of(way);
  if (direction.under_way.empty() || direction.under_way.front().at_s > now_s) return std::nullopt;
  Parcel parcel = std::move(direction.under_way.front());
  direction.under_way.pop_front();
  direction.pending -= parcel.bytes.size();
  return Arrival{std::move(parcel.bytes), parcel.end};
}

double FaultyConnection::due_s() const noexcept {
  double due_s = kInf;
  for (const Direction& one : directions_) {
    if (!one.under_way.empty()) due_s = std::min(due_s, one.under_way.front().at_s);
  }
  return due_s;
}

}  // namespace ganglion::link
