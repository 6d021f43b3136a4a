#pragma once

#include "ganglion/base/sentence.h"
#include "ganglion/link/wire/link.pb.h"

namespace ganglion::link {

/// Puts a reason into a Bye. What somebody sent may be quoted in it: what is no UTF-8 becomes "?".
void write_words(const Sentence& reason, wire::Bye& out);

/// What the other side says to people, as it may be shown. Where it came in one language only, it is quoted in both.
Sentence read_words(const wire::Bye& message);
Sentence read_words(const wire::Event& message);

}  // namespace ganglion::link
