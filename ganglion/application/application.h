#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ganglion/application/description.h"
#include "ganglion/application/intervention.h"
#include "ganglion/application/terrain.h"
#include "ganglion/application/witness.h"
#include "ganglion/base/result.h"
#include "ganglion/exhibit/exhibit.h"

namespace ganglion {

/// Feedback: what one robot reports at one tick.
struct SenseFrame {
  std::uint32_t tick = 0;
  double time_s = 0;
  std::optional<double> cost;  ///< Energy the last command took [J]; absent in the first frame and where unknown.
  std::vector<double> values;  ///< All sensations, as described; missing readings after REP-117.
  std::vector<double> ages_s;  ///< For each channel the time since it was measured.
};

/// How the value of a command came about.
enum class CommandOrigin : std::uint8_t {
  Commanded,  ///< As a module or coordinator commanded it, clamped to its limits.
  Safe,       ///< Nobody commanded: the safe value.
  Withdrawn,  ///< The module gave up: the safe value, and the application may help (see reason).
  Refused,    ///< What was commanded is not a number: the safe value.
};

/// Commands for one robot at one tick.
struct ActFrame {
  std::uint32_t tick = 0;
  std::vector<double> values;          ///< All commands, as described. Always finite and within limits.
  std::vector<CommandOrigin> origins;  ///< For each command channel.
  std::vector<double> ttl_s;           ///< For each command channel: safe values are taken after this time.
  std::vector<std::uint16_t> reasons;  ///< For each command channel: the ReasonCode of a withdrawal, else 0.
};

/// Whatever answers commands with feedback: a simulated robot, a plant, a real robot. Frames are made once by
/// make_sense_frame() and make_act_frame(); nothing is allocated while stepping.
class Application : public Exhibitor {
 public:
  virtual const Description& description() const noexcept = 0;
  virtual int robots() const noexcept = 0;
  /// Begins an episode: the same seed and episode give the same bits as in a fresh process.
  virtual Result<void> reset(std::uint64_t seed, std::uint32_t episode) = 0;
  /// Fills every robot's frame of the present tick.
  virtual void sense(std::span<SenseFrame> frames) noexcept = 0;
  /// Carries the commands out for step_s, for one robot or many; then the next tick begins.
  virtual void step(std::span<const ActFrame> frames, double step_s) noexcept = 0;
  /// Why nothing can be sensed and done any more; null while all is well. Looked at between ticks.
  virtual const Error* failure() const noexcept { return nullptr; }

  /// What is known besides the frames; null where nothing is.
  virtual const Witness* witness() const noexcept { return nullptr; }
  /// The ground it stands on, with what moves there; null where there is none, or nobody knows it.
  virtual const Terrain* terrain() const noexcept { return nullptr; }
  /// What can be done to it from outside.
  virtual std::span<const InterventionDescriptor> interventions() const noexcept { return {}; }
  /// Does one of them: after reset(), between ticks. Draws nothing. Fails, and does nothing, with NotFound for an unknown
  /// robot or subject, Unsupported where it takes no such, BadParameter where it cannot be, TooLarge for too many.
  /// Takes memory.
  virtual Result<Intervened> intervene(const Intervention& what);
};

/// A frame of the described size: no reading yet (NaN), ages infinite.
SenseFrame make_sense_frame(const Description& description);
/// A frame of the described size: safe values.
ActFrame make_act_frame(const Description& description);

/// At the boundary between application and controller a number has one spelling, whatever carried it: -0 is 0, and
/// there is one NaN. So a run over a link has the bits of a run within one program.
void make_canonical(SenseFrame& frame) noexcept;
void make_canonical(ActFrame& frame) noexcept;

}  // namespace ganglion
