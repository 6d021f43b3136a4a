// What changes a store: commits of what was learned, and what people do to it by hand.
#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/experience/store.h"
#include "ganglion/experience/stored_hash.h"

namespace ganglion {

Result<bool> ExperienceStore::is_stale() const {
  if (mark_of(database_.file()) != mark_) return true;
  const auto now = state();
  if (!now) return tl::unexpected(now.error());
  return now->generation != generation_ || (lease_ != nullptr && now->lease != *lease_);
}

Result<CommitOutcome> ExperienceStore::commit(std::span<const ComponentUpdate> updates) {
  CommitOutcome outcome;
  const auto written = database_.transaction([&]() -> Result<void> {
    const auto stale = is_stale();
    if (!stale) return tl::unexpected(stale.error());
    outcome.stale = *stale;
    if (outcome.stale) return {};
    for (const ComponentUpdate& update : updates) {
      const auto changes = apply(update);
      if (!changes) return tl::unexpected(changes.error());
      outcome.changes += *changes;
    }
    if (outcome.changes == 0) return {};
    auto count = database_.prepare("UPDATE state SET generation = generation + 1");
    if (!count) return tl::unexpected(count.error());
    return count->run();
  });
  if (!written) return tl::unexpected(written.error());
  if (outcome.changes > 0) ++generation_;
  return outcome;
}

Result<std::size_t> ExperienceStore::apply(const ComponentUpdate& update) const {
  std::size_t sum = 0;
  for (const auto step :
       {&ExperienceStore::drop_gone, &ExperienceStore::write_changed, &ExperienceStore::write_rests_on}) {
    const auto changes = (this->*step)(update);
    if (!changes) return changes;
    sum += *changes;
  }
  return sum;
}

Result<std::size_t> ExperienceStore::drop_gone(const ComponentUpdate& update) const {
  auto select = database_.prepare("SELECT name, kind FROM part WHERE component = ?");
  auto drop = database_.prepare("DELETE FROM part WHERE component = ? AND name = ?");
  if (!select) return tl::unexpected(select.error());
  if (!drop) return tl::unexpected(drop.error());
  std::vector<std::string> gone;
  select->bind(1, std::string_view(update.component));
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) break;
    std::string name = select->text(0);
    const bool here = std::find(update.present.begin(), update.present.end(), name) != update.present.end();
    if (!here || select->text(1) != update.kind) gone.push_back(std::move(name));
  }
  for (const std::string& name : gone) {
    drop->bind(1, std::string_view(update.component));
    drop->bind(2, std::string_view(name));
    if (auto done = drop->run(); !done) return tl::unexpected(done.error());
  }
  return gone.size();
}

Result<bool> ExperienceStore::is_stored(Statement& find, const ComponentUpdate& owner,
                                        const ExperiencePart& part) const {
  find.bind(1, std::string_view(owner.component));
  find.bind(2, std::string_view(part.name));
  const auto row = find.step();
  if (!row) return tl::unexpected(row.error());
  const bool same = *row && find.text(0) == owner.kind && find.integer(1) == owner.version &&
                    find.integer(2) == stored_hash(part.bytes) &&
                    find.integer(3) == static_cast<std::int64_t>(part.bytes.size());
  find.reset();
  return same;
}

Result<std::size_t> ExperienceStore::write_changed(const ComponentUpdate& update) const {
  auto find = database_.prepare("SELECT kind, version, hash, length(bytes) FROM part WHERE component = ? AND name = ?");
  auto insert = database_.prepare("INSERT OR REPLACE INTO part VALUES (?, ?, ?, ?, ?, ?, ?)");
  if (!find) return tl::unexpected(find.error());
  if (!insert) return tl::unexpected(insert.error());
  const std::int64_t now_s = now_s_();
  std::size_t changes = 0;
  for (const ExperiencePart& part : update.changed) {
    const auto same = is_stored(*find, update, part);
    if (!same) return tl::unexpected(same.error());
    if (*same) continue;
    insert->bind(1, std::string_view(update.component));
    insert->bind(2, std::string_view(part.name));
    insert->bind(3, std::string_view(update.kind));
    insert->bind(4, std::int64_t{update.version});
    insert->bind(5, stored_hash(part.bytes));
    insert->bind(6, std::span<const std::byte>(part.bytes));
    insert->bind(7, now_s);
    if (auto done = insert->run(); !done) return tl::unexpected(done.error());
    ++changes;
  }
  return changes;
}

/// Only of what has parts: nothing learned rests on nothing.
Result<std::size_t> ExperienceStore::write_rests_on(const ComponentUpdate& update) const {
  auto select = database_.prepare("SELECT parameter, value FROM rests_on WHERE component = ?");
  auto drop = database_.prepare("DELETE FROM rests_on WHERE component = ?");
  auto insert = database_.prepare("INSERT INTO rests_on VALUES (?, ?, ?)");
  for (const auto* statement : {&select, &drop, &insert}) {
    if (!*statement) return tl::unexpected(statement->error());
  }
  std::vector<RestsOn> wanted = update.present.empty() ? std::vector<RestsOn>() : update.rests_on;
  std::sort(wanted.begin(), wanted.end(), [](const auto& a, const auto& b) { return a.parameter < b.parameter; });
  std::vector<RestsOn> stored;
  select->bind(1, std::string_view(update.component));
  while (true) {
    const auto row = select->step();
    if (!row) return tl::unexpected(row.error());
    if (!*row) break;
    stored.push_back({select->text(0), select->text(1)});
  }
  if (stored == wanted) return std::size_t{0};
  drop->bind(1, std::string_view(update.component));
  if (auto done = drop->run(); !done) return tl::unexpected(done.error());
  for (const RestsOn& one : wanted) {
    insert->bind(1, std::string_view(update.component));
    insert->bind(2, std::string_view(one.parameter));
    insert->bind(3, std::string_view(one.value));
    if (auto done = insert->run(); !done) return tl::unexpected(done.error());
  }
  return std::size_t{1};
}

Result<std::size_t> ExperienceStore::change_component(std::string_view component,
                                                      const std::function<Result<std::size_t>()>& change) {
  std::size_t parts = 0;
  const auto done = database_.transaction([&]() -> Result<void> {
    auto now = state();
    if (!now) return tl::unexpected(now.error());
    if (auto free = refuse_leased(*now); !free) return free;
    const auto changed = change();
    if (!changed) return tl::unexpected(changed.error());
    parts = *changed;
    if (parts > 0) return set_state({now->generation + 1, now->lease});
    const auto stored = list();
    if (!stored) return tl::unexpected(stored.error());
    std::vector<std::string> names;
    for (const StoredComponent& one : *stored) names.push_back(one.component);
    auto missing =
        fail_at({database_.file()}, ErrorCode::NotFound, {"holds nothing of \"{}\"{}", "no contiene nada de \"{}\"{}"},
                component, suggestion(component, names));
    missing.value().subject = {std::string(component), "", std::string(component), names};
    return missing;
  });
  if (!done) return tl::unexpected(done.error());
  ++generation_;
  return parts;
}

Result<std::size_t> ExperienceStore::forget(std::string_view component) {
  return change_component(component, [&]() -> Result<std::size_t> {
    std::size_t parts = 0;
    for (const char* sql : {"DELETE FROM rests_on WHERE component = ?", "DELETE FROM part WHERE component = ?"}) {
      auto drop = database_.prepare(sql);
      if (!drop) return tl::unexpected(drop.error());
      drop->bind(1, component);
      if (auto done = drop->run(); !done) return tl::unexpected(done.error());
      parts = static_cast<std::size_t>(database_.changes());
    }
    return parts;
  });
}

Result<std::size_t> ExperienceStore::rename(std::string_view from, std::string_view to) {
  return change_component(from, [&]() -> Result<std::size_t> {
    auto taken = database_.prepare("SELECT count(*) FROM part WHERE component = ?");
    if (!taken) return tl::unexpected(taken.error());
    taken->bind(1, to);
    if (const auto row = taken->step(); !row) return tl::unexpected(row.error());
    if (taken->integer(0) > 0) {
      return fail_at({database_.file()}, ErrorCode::BadParameter,
                     {"holds something of \"{}\" already; forget it first, or choose another name",
                      "ya contiene algo de \"{}\"; olvídelo antes, o elija otro nombre"},
                     to);
    }
    std::size_t parts = 0;
    for (const char* sql : {"UPDATE OR REPLACE rests_on SET component = ? WHERE component = ?",
                            "UPDATE part SET component = ? WHERE component = ?"}) {
      auto update = database_.prepare(sql);
      if (!update) return tl::unexpected(update.error());
      update->bind(1, to);
      update->bind(2, from);
      if (auto done = update->run(); !done) return tl::unexpected(done.error());
      parts = static_cast<std::size_t>(database_.changes());
    }
    return parts;
  });
}

}  // namespace ganglion
