#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/base/sentence.h"
#include "ganglion/exhibit/role.h"

namespace ganglion {

/// A column of a Ledger.
struct LedgerColumn {
  std::string name;
  std::string unit;
  std::vector<Sentence> words;  ///< Of the values 0, 1, 2... where they are names; else empty.
  std::vector<Role> roles;      ///< The same to the eye, where rows have a place.
};

/// What can be said of a ledger before it has a row.
struct LedgerForm {
  std::string task;  ///< Id of the task that keeps it.
  std::vector<LedgerColumn> columns;
  /// What happened, of one row for people: "goal {#} at cell {goal_column}, {goal_row}: {outcome}". {#} counts rows from
  /// 1, {name} is the value of a column, or its word. Empty: nothing is told.
  Sentence line;
  /// What rows are to the eye. They have a place where there are columns x_m, y_m and outcome, which has roles.
  Text title{"Records", "Registros"};
  double cell_m = 0;  ///< Of the cells that they stand in; 0 = they stand anywhere.

  std::optional<std::size_t> column(std::string_view name) const noexcept;
};

/// What somebody keeps of things that follow each other, as rows of named numbers: a task of its goals.
class Ledger {
 public:
  virtual ~Ledger() = default;
  virtual std::span<const LedgerColumn> columns() const noexcept = 0;
  virtual std::size_t rows() const noexcept = 0;
  virtual double at(std::size_t row, std::size_t column) const noexcept = 0;
  /// Nothing is open any more, and nothing comes.
  virtual bool done() const noexcept = 0;
  /// Counts what happened to it, a reset included: while it is the same, nothing has changed.
  virtual std::uint64_t changes() const noexcept = 0;
};

/// A row as its form words it.
Sentence row_text(const LedgerForm& form, std::size_t row, std::span<const double> values);

/// The most that anybody takes of them.
inline constexpr std::size_t kMaxLedgerColumns = 64;
inline constexpr std::size_t kMaxLedgerRows = 100'000;

}  // namespace ganglion
