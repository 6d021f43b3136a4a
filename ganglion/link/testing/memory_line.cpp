#include "ganglion/link/testing/memory_line.h"

#include <algorithm>

namespace ganglion::link {

Result<void> MemoryLine::connect(double) {
  if (!plugged_) return fail(ErrorCode::LinkLost, {"nothing answers", "nada responde"});
  close();
  if (!peer_) peer_ = end_.open(carrier_, address_, now_s_);
  open_ = true;
  finished_ = reset_ = silent_ = false;
  ++connections_;
  return {};
}

void MemoryLine::close() noexcept {
  open_ = false;
  inbox_.clear();
  if (carrier_ == Carrier::Packets || !peer_) return;
  if (!silent_) end_.lost(*peer_, now_s_);  // else the robot never hears of it
  peer_.reset();
}

std::string MemoryLine::passed(Way way, std::string_view bytes) {
  std::size_t& so_far = carried_[static_cast<std::size_t>(way)];
  std::string arrived(silent_ ? "" : bytes);
  if (cut_ && cut_->way == way && so_far + bytes.size() > cut_->at) {
    arrived.resize(cut_->at - so_far);
    (cut_->by == CutBy::Fin ? finished_ : cut_->by == CutBy::Rst ? reset_ : silent_) = true;
    cut_.reset();
  }
  for (std::size_t n = 0; n < arrived.size() && spoil_every_ > 0; ++n) {
    if ((so_far + n) % spoil_every_ == spoil_every_ - 1) arrived[n] = static_cast<char>(arrived[n] ^ 0x15);
  }
  so_far += bytes.size();
  return arrived;
}

Result<void> MemoryLine::send(std::string_view bytes, double) {
  if (broken()) return fail(ErrorCode::LinkLost, {"broken", "cortada"});
  const std::string arrived = passed(Way::ToRobot, bytes);
  if (!arrived.empty() && !reset_) {
    end_.receive(*peer_, arrived, now_s_);
    delivered_s_ = now_s_;
  }
  if (finished_) fetch();  // what the robot had said
  if (finished_ || reset_) end_.lost(*peer_, now_s_);
  return {};
}

void MemoryLine::fetch() {
  if (!peer_) return;
  const std::string bytes(end_.outgoing(*peer_));
  if (bytes.empty() || reset_) return;
  end_.sent(*peer_, bytes.size(), now_s_);
  inbox_ += passed(Way::ToController, bytes);
  if (reset_) inbox_.clear();
  if (finished_ || reset_) end_.lost(*peer_, now_s_);
}

Result<std::size_t> MemoryLine::receive(std::span<char> room, double until_s) {
  for (;;) {
    if (open_ && !finished_) fetch();
    if (!inbox_.empty()) {
      const std::size_t count = std::min(room.size(), inbox_.size());
      std::copy_n(inbox_.begin(), count, room.begin());
      inbox_.erase(0, count);
      return count;
    }
    const bool ended = carrier_ == Carrier::Stream && !silent_ && open_ && (end_.closing(*peer_) || end_.gone(*peer_));
    if (broken() || ended) return fail(ErrorCode::LinkLost, {"broken", "cortada"});
    if (now_s_ >= until_s) return std::size_t{0};
    wait_until(std::min(until_s, std::max(now_s_, end_.due_s())));
  }
}

void MemoryLine::wait_until(double until_s) {
  do {
    now_s_ = std::max(now_s_, std::min(until_s, std::max(now_s_ + 1e-6, end_.due_s())));
    end_.poll(now_s_);
  } while (now_s_ < until_s);
}

}  // namespace ganglion::link
