#include "ganglion/module/tick/request.h"

#include <algorithm>
#include <cmath>

#include "ganglion/units/angle.h"

namespace ganglion {

void RequestSlot::ask(std::span<const double> wanted) noexcept {
  size = static_cast<int>(std::min(wanted.size(), values.size()));
  std::copy_n(wanted.begin(), size, values.begin());
  status = RequestStatus::Pending;
  ++serial;
  reason = {};
  cost = 0;
  has_cost = false;
  ticks = 0;
  lost = false;
  const bool numbers = std::all_of(wanted.begin(), wanted.end(), [](double value) { return std::isfinite(value); });
  const bool fits = width == 0 ? wanted.size() <= values.size() : wanted.size() == static_cast<std::size_t>(width);
  if (!numbers || !fits) withdraw({ReasonCode::BadRequest, values[0], values[1]});
}

void RequestSlot::clear() noexcept {
  status = RequestStatus::None;
  size = 0;
  has_cost = false;  // or else whoever asked would be charged again in every later tick
}

void RequestSlot::withdraw(const Reason& why) noexcept {
  if (status == RequestStatus::Pending) ++concluded;
  status = RequestStatus::Withdrawn;
  reason = why;
}

void RequestSlot::keep_asking(std::span<const double> wanted, double for_s) noexcept {
  ttl_s = for_s;
  const std::span<const double> now = span();
  const bool same = std::equal(wanted.begin(), wanted.end(), now.begin(), now.end());
  if (status != RequestStatus::Pending || !same) ask(wanted);
}

bool equal_within(std::span<const double> reading, std::span<const double> sought, const Comparison& how) noexcept {
  if (reading.size() != sought.size() || reading.empty()) return false;
  for (std::size_t i = 0; i < reading.size(); ++i) {
    const double difference = how.circular[i] ? wrap_rad(reading[i] - sought[i]) : reading[i] - sought[i];
    if (!(std::fabs(difference) <= how.tolerance[i])) return false;
  }
  return true;
}

void Sought::set(std::span<const double> wanted) noexcept {
  size = static_cast<int>(std::min(wanted.size(), values.size()));
  std::copy_n(wanted.begin(), size, values.begin());
}

}  // namespace ganglion
