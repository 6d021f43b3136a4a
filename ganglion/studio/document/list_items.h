#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ganglion/config/source/sheet.h"

namespace ganglion::studio {

/// Notes changes of a list of texts, as the sheet's replace() does. An item takes with it the comment behind it on its
/// line, and that on the lines directly above it, unless only the first item has such a one: it is about the whole list.

/// The list's items in this order: order[n] is which of those that stand there now comes at n.
void put_in_order(config::Sheet& sheet, config::Region list, const std::vector<std::size_t>& order);

/// One more item before that of this index, or at the end; on a line of its own where its neighbour has one.
void put_in(config::Sheet& sheet, config::Region list, std::size_t index, const std::string& toml);

/// Takes an item out, with the comma behind or before it, and its line if nothing else stands there; comments stay.
void take_out(config::Sheet& sheet, config::Region list, config::Region item);

}  // namespace ganglion::studio
