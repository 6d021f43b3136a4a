#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ganglion::plot {

/// What is wrong with XML markup: the first tag that closes nothing, stays open or is cut; "" = well-formed as far as
/// tags go.
std::string fault_in_markup(std::string_view markup);

/// The contents of all <text> elements, entities left as they are.
std::vector<std::string> texts_in(std::string_view svg);

}  // namespace ganglion::plot
