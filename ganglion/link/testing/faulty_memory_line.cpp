#include "ganglion/link/testing/faulty_memory_line.h"

#include <algorithm>

#include "ganglion/base/expects.h"
#include "ganglion/base/hash.h"

namespace ganglion::link {
namespace {

constexpr std::uint64_t kMostRounds = 10'000'000;  // a test that never ends fails here
constexpr double kInstant_s = 1e-6;                // every look at a clock takes time

}  // namespace

FaultyMemoryLine::Connection* FaultyMemoryLine::current() noexcept {
  return connections_.empty() || !connections_.back().current ? nullptr : &connections_.back();
}

Result<void> FaultyMemoryLine::connect(double) {
  if (carrier_ == Carrier::Packets && current() != nullptr) return {};
  close();
  const std::uint32_t number = next_number_++;
  connections_.emplace_back(FaultyConnection(faults_, seed_, number, carrier_), end_.open(carrier_, address_, now_s_),
                            number);
  inbox_.clear();
  return {};
}

void FaultyMemoryLine::close() noexcept {
  Connection* connection = current();
  if (connection == nullptr || carrier_ == Carrier::Packets) return;
  connection->way.finish(Way::ToRobot, now_s_);
  connection->current = false;
  inbox_.clear();
  carry();
}

Result<void> FaultyMemoryLine::send(std::string_view bytes, double) {
  Connection* connection = current();
  if (connection == nullptr || connection->controller_gone) return fail(ErrorCode::LinkLost, {"broken", "cortada"});
  connection->way.push(Way::ToRobot, bytes, now_s_);
  carry();
  return {};
}

void FaultyMemoryLine::log(Way way, const Connection& connection, std::string_view bytes, bool end) {
  log_hash_ = combine(log_hash_, canonical_bits(now_s_));
  log_hash_ = combine(log_hash_, connection.number * 4 + (end ? 2u : 0u) + (way == Way::ToRobot ? 0u : 1u));
  log_hash_ = combine(log_hash_, hash_name(bytes));
}

bool FaultyMemoryLine::deliver(Connection& connection, Way way) {
  bool any = false;
  while (const auto arrival = connection.way.take(way, now_s_)) {
    any = true;
    log(way, connection, arrival->bytes, arrival->end);
    if (arriving && !arrival->bytes.empty()) arriving(way, connection.number, arrival->bytes, now_s_);
    if (way == Way::ToController) {
      if (connection.current) inbox_ += arrival->bytes;
      if (arrival->end) connection.controller_gone = true;
    } else if (!connection.robot_gone) {
      end_.receive(connection.peer, arrival->bytes, now_s_);
      if (arrival->end) {
        end_.lost(connection.peer, now_s_);
        connection.robot_gone = true;
      }
    }
  }
  return any;
}

bool FaultyMemoryLine::carry(Connection& connection) {
  bool any = deliver(connection, Way::ToRobot);
  if (!connection.robot_gone) {
    const std::string bytes(end_.outgoing(connection.peer));
    end_.sent(connection.peer, bytes.size(), now_s_);
    if (!bytes.empty()) connection.way.push(Way::ToController, bytes, now_s_);
    any = any || !bytes.empty();
    if (end_.closing(connection.peer) || end_.gone(connection.peer)) {
      connection.way.finish(Way::ToController, now_s_);
      end_.lost(connection.peer, now_s_);
      connection.robot_gone = true;
    }
  }
  any = deliver(connection, Way::ToController) || any;
  if (connection.way.reset()) {
    if (!connection.robot_gone) end_.lost(connection.peer, now_s_);
    connection.robot_gone = connection.controller_gone = true;
    if (connection.current) inbox_.clear();
  }
  struck_s_ = std::max(struck_s_, connection.way.struck_s());
  return any;
}

void FaultyMemoryLine::carry() {
  for (bool any = true; any;) {
    expects(++rounds_ < kMostRounds);
    any = false;
    for (Connection& connection : connections_) any = carry(connection) || any;
  }
  while (!connections_.empty() && !connections_.front().current && connections_.front().robot_gone) {
    connections_.pop_front();
  }
}

double FaultyMemoryLine::due_s() const {
  double due_s = end_.due_s();
  for (const Connection& connection : connections_) due_s = std::min(due_s, connection.way.due_s());
  return due_s;
}

Result<std::size_t> FaultyMemoryLine::receive(std::span<char> room, double until_s) {
  for (;;) {
    carry();
    if (!inbox_.empty()) {
      const std::size_t count = std::min(room.size(), inbox_.size());
      std::copy_n(inbox_.begin(), count, room.begin());
      inbox_.erase(0, count);
      return count;
    }
    const Connection* connection = current();
    if (connection == nullptr || connection->controller_gone) return fail(ErrorCode::LinkLost, {"broken", "cortada"});
    if (now_s_ >= until_s) {
      wait_until(now_s_ + kInstant_s);
      return std::size_t{0};
    }
    wait_until(std::min(until_s, std::max(now_s_ + kInstant_s, due_s())));
  }
}

void FaultyMemoryLine::wait_until(double until_s) {
  while (now_s_ < until_s) {
    now_s_ = std::min(until_s, std::max(now_s_ + kInstant_s, due_s()));
    end_.poll(now_s_);
    carry();
  }
}

}  // namespace ganglion::link
