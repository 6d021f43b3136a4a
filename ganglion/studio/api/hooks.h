#pragma once

#include <functional>

#include "ganglion/studio/live/hub.h"

namespace ganglion::studio {

/// Has something done by the thread that owns the hub, soon.
using OnHub = std::function<void(std::function<void(Hub&)>)>;

/// Has something done by the thread that carries out commands, soon; may be called by any.
using Later = std::function<void(std::function<void()>)>;

}  // namespace ganglion::studio
