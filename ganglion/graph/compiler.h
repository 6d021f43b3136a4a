#pragma once

#include <vector>

#include "ganglion/graph/controller.h"

namespace ganglion {

/// Lays a resolved model out as a Controller.
class Compiler {
 public:
  Compiler(const ControllerModel& model, const Description& robot, const KindList& kinds, const Identity& identity)
      : model_(model),
        robot_(robot),
        kinds_(kinds),
        identity_(identity),
        taker_(model.components.size(), -1),
        asked_(model.components.size(), -1) {}

  Result<Controller> run();

 private:
  using Part = layout::Part;

  Result<void> check_limits() const;
  Result<void> make_part(const ComponentModel& model);
  void join_digest();
  // compiler_layout.cpp
  void lay_out_signals();
  void lay_out_outputs(const ComponentModel& model, Part& part, bool derived);
  void find_common(const ComponentModel& model, Part& part) const;
  void lay_out_commands();
  void lay_out_inputs();
  void lay_out_wire(std::size_t index, const PortDescriptor& port, const Source& source);
  void reserve();
  // compiler_links.cpp
  void connect(std::size_t index);
  void connect_acting(std::size_t index);
  void connect_candidates(std::size_t index);
  // compiler_requests.cpp
  void connect_request(std::size_t index, std::size_t port_index);
  void connect_goals(std::size_t index, const std::vector<int>& goals);
  void connect_answers();

  std::size_t add_signal(const std::string& name, const std::string& unit, Meaning meaning = Meaning::None) {
    controller_.signals_.push_back({name, unit, meaning});
    return controller_.signals_.size() - 1;
  }
  Part& part(int index) { return controller_.parts_[static_cast<std::size_t>(index)]; }

  const ControllerModel& model_;
  const Description& robot_;
  const KindList& kinds_;
  Identity identity_;
  Controller controller_;
  std::size_t values_ = 0, ages_ = 0;
  std::size_t command_age_ = 0;  // one for the whole command frame
  struct InputStretch {
    std::size_t first, count, age_first, ages;
  };
  std::vector<std::vector<InputStretch>> inputs_;  // for each component, for each input of its descriptor
  std::vector<int> loops_;                         // for each component the loop it is part of
  std::vector<int> taker_;                         // for each component the coordinator its command competes in, or -1
  std::vector<int> asked_;  // for each component the module its command becomes a request of, or -1
};

}  // namespace ganglion
