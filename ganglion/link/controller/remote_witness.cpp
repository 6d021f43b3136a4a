#include "ganglion/link/controller/remote_witness.h"

#include <algorithm>
#include <limits>

#include "ganglion/link/wire/description.h"

namespace ganglion::link {
namespace {

constexpr int kMaxTruthChannels = 256;
constexpr int kMaxLedgers = 64;
constexpr std::size_t kMaxRows = 1'000'000;  // of all robots together

int index_in(const auto& list, std::string_view name) {
  for (int n = 0; n < static_cast<int>(list.size()); ++n) {
    if (list.Get(n) == name) return n;
  }
  return -1;
}

}  // namespace

bool RemoteWitness::Copy::set(std::size_t row, std::span<const double> values) {
  if (row > rows() || row >= kMaxLedgerRows) return false;
  if (row == rows()) values_.resize(values_.size() + columns_.size());
  ++changes_;
  std::ranges::copy(values, values_.begin() + static_cast<std::ptrdiff_t>(row * columns_.size()));
  return true;
}

bool RemoteWitness::told(const wire::Describe& describe) { return describe.truth_channels_size() > 0; }

Result<RemoteWitness> RemoteWitness::make(const wire::Describe& describe, HopedTruth hoped) {
  if (describe.truth_channels_size() > kMaxTruthChannels || describe.ledgers_size() > kMaxLedgers ||
      describe.movers_size() > kMaxRobots) {
    return fail(ErrorCode::TooLarge,
                {"{} truth channels, {} ledgers and {} movers; the limits are {}, {} and {}",
                 "{} canales de verdad, {} registros y {} obstáculos móviles; los límites son {}, {} y {}"},
                describe.truth_channels_size(), describe.ledgers_size(), describe.movers_size(), kMaxTruthChannels,
                kMaxLedgers, kMaxRobots);
  }
  RemoteWitness made;
  made.hoped_ = std::move(hoped);
  made.robots_ = std::max<std::size_t>(1, describe.robots());
  made.told_channels_ = static_cast<std::size_t>(describe.truth_channels_size());
  for (const TruthChannel& channel : made.hoped_.channels) {
    int found = -1;
    for (int n = 0; n < describe.truth_channels_size(); ++n) {
      if (describe.truth_channels(n).name() == channel.name) found = n;
    }
    made.channel_.push_back(found);
  }
  made.values_.assign(made.robots_ * made.channel_.size(), std::numeric_limits<double>::quiet_NaN());
  for (const wire::Ledger& ledger : describe.ledgers()) {
    Told told{static_cast<std::size_t>(ledger.columns_size()), -1, {}};
    if (told.columns > kMaxLedgerColumns) {
      return fail(ErrorCode::TooLarge,
                  {"a ledger of {} columns; the limit is {}", "un registro de {} columnas; el límite es {}"},
                  told.columns, kMaxLedgerColumns);
    }
    for (std::size_t n = 0; n < made.hoped_.ledgers.size(); ++n) {
      if (made.hoped_.ledgers[n].task == ledger.task()) told.hoped = static_cast<int>(n);
    }
    for (std::size_t n = 0;
         told.hoped >= 0 && n < made.hoped_.ledgers[static_cast<std::size_t>(told.hoped)].columns.size(); ++n) {
      const int at =
          index_in(ledger.columns(), made.hoped_.ledgers[static_cast<std::size_t>(told.hoped)].columns[n].name);
      if (at < 0) told.hoped = -1;
      told.order.push_back(static_cast<std::size_t>(std::max(at, 0)));
    }
    made.told_.push_back(std::move(told));
  }
  for (std::size_t robot = 0; robot < made.robots_; ++robot) {
    for (const LedgerForm& form : made.hoped_.ledgers) made.copies_.emplace_back(form.columns);
  }
  made.mover_ids_.assign(describe.movers().begin(), describe.movers().end());
  for (const std::string& id : made.mover_ids_) made.movers_.push_back({.id = id});
  return made;
}

Result<void> RemoteWitness::take(const wire::Sense& sense, double time_s, bool first) {
  const auto values = static_cast<std::size_t>(sense.truth_values_size());
  if (values != robots_ * told_channels_ || sense.movers_size() != static_cast<int>(3 * movers_.size())) {
    return fail(ErrorCode::BadParameter,
                {"the truth of {} robots has {} numbers and that of movers {}; described were {} and {}",
                 "la verdad de {} robots tiene {} números y la de los obstáculos móviles {}; se describieron {} y {}"},
                robots_, values, sense.movers_size(), robots_ * told_channels_, 3 * movers_.size());
  }
  time_s_ = time_s;
  for (std::size_t robot = 0; robot < robots_; ++robot) {
    for (std::size_t n = 0; n < channel_.size(); ++n) {
      if (channel_[n] < 0) continue;
      values_[robot * channel_.size() + n] = sense.truth_values(static_cast<int>(robot * told_channels_) + channel_[n]);
    }
  }
  for (std::size_t n = 0; n < movers_.size(); ++n) {
    const int at = static_cast<int>(3 * n);
    movers_[n].pose = {{sense.movers(at), sense.movers(at + 1)}, Angle::from_rad(sense.movers(at + 2))};
  }
  if (first) {
    for (Copy& copy : copies_) copy.clear();
    rows_taken_ = 0;
  }
  return take_rows(sense);
}

Result<void> RemoteWitness::take_rows(const wire::Sense& sense) {
  const auto wrong = [](const Sentence& why) {
    return fail(ErrorCode::BadParameter, {"a row of a ledger: {}", "una fila de un registro: {}"}, why);
  };
  if (sense.done_size() != 0 && static_cast<std::size_t>(sense.done_size()) != robots_ * told_.size()) {
    return wrong(say({"done has {} values, must have {}", "done tiene {} valores, debe tener {}"}, sense.done_size(),
                     robots_ * told_.size()));
  }
  for (const wire::Row& row : sense.rows()) {
    if (row.robot() >= robots_ || row.ledger() >= told_.size()) {
      return wrong(say({"there is no ledger {} of robot {}", "no existe el registro {} del robot {}"}, row.ledger(),
                       row.robot()));
    }
    const Told& told = told_[row.ledger()];
    if (static_cast<std::size_t>(row.values_size()) != told.columns) {
      return wrong(
          say({"{} values, described were {}", "{} valores; se describieron {}"}, row.values_size(), told.columns));
    }
    if (told.hoped < 0) continue;
    row_.clear();
    for (const std::size_t column : told.order) row_.push_back(row.values(static_cast<int>(column)));
    Copy& copy = copies_[row.robot() * copies() + static_cast<std::size_t>(told.hoped)];
    rows_taken_ += row.row() == copy.rows() ? 1 : 0;
    if (rows_taken_ > kMaxRows || !copy.set(row.row(), row_)) {
      return wrong(say({"row {} after {} rows", "la fila {} tras {} filas"}, row.row(), copy.rows()));
    }
  }
  for (int n = 0; n < sense.done_size(); ++n) {
    const auto robot = static_cast<std::size_t>(n) / told_.size();
    const int hoped = told_[static_cast<std::size_t>(n) % told_.size()].hoped;
    if (hoped >= 0) copies_[robot * copies() + static_cast<std::size_t>(hoped)].set_done(sense.done(n));
  }
  return {};
}

std::span<const double> RemoteWitness::truth_of(int robot) const noexcept {
  return std::span(values_).subspan(static_cast<std::size_t>(robot) * channel_.size(), channel_.size());
}

const Ledger* RemoteWitness::ledger(int robot, std::string_view task) const noexcept {
  for (std::size_t n = 0; n < hoped_.ledgers.size(); ++n) {
    if (hoped_.ledgers[n].task == task) return &copies_[static_cast<std::size_t>(robot) * copies() + n];
  }
  return nullptr;
}

}  // namespace ganglion::link
