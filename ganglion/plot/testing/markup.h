#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ganglion/plot/canvas/picture.h"

namespace ganglion::plot {

/// What is wrong with XML markup: the first tag that closes nothing, stays open or is cut; "" = well-formed as far as
/// tags go.
std::string fault_in_markup(std::string_view markup);

/// The contents of all <text> elements, entities left as they are.
std::vector<std::string> texts_in(std::string_view svg);

/// Every text that a picture says, as its SVG has it.
std::set<std::string> words_in(const Picture& picture);

}  // namespace ganglion::plot
