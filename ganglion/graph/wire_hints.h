#pragma once

#include <string>
#include <vector>

#include "ganglion/graph/model.h"

namespace ganglion {

/// What a person may have meant by the text of a wire, for messages.
class WireHints {
 public:
  WireHints(const ControllerModel& model, const Description& robot) : model_(model), robot_(robot) {}

  /// The components whose command or bids a candidate or request port takes.
  std::vector<std::string> givers_for(const PortDescriptor& port) const;
  /// The sources whose values fit a port in unit and number.
  std::vector<std::string> sources_for(const PortDescriptor& port) const;
  /// `; did you mean "nearest.range"?` of a mistyped source of values, or else what fits the port.
  Sentence for_unknown(const PortDescriptor& port, const std::string& text) const;
  /// How to wire a channel of the robot that was written in place of a sensation.
  Sentence for_channel(const std::string& channel) const;
  /// The single values of a source of several: "position.x", "position.y".
  std::vector<std::string> parts_of(const Source& source) const;

 private:
  const ControllerModel& model_;
  const Description& robot_;
};

}  // namespace ganglion
