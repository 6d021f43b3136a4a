#pragma once

#include "ganglion/link/net/address.h"
#include "say.h"

namespace ganglion {

/// Says so where other machines can drive the robots behind an address that is listened at.
inline void note_who_reaches(const link::Address& address) {
  if (!address.open) return;
  note(say(
      {"{} can be reached from the whole network: whoever does can drive the robots. 127.0.0.1 keeps to this machine",
       "{} está al alcance de toda la red: cualquiera en ella puede mandar los robots. 127.0.0.1 se limita a este "
       "equipo"},
      address.text));
}

}  // namespace ganglion
