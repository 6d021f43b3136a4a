#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "ganglion/base/result.h"
#include "ganglion/descriptor/descriptor.h"
#include "ganglion/descriptor/parameters.h"
#include "ganglion/module/tick/command.h"

/// What the behaviours of a tracked robot with two front sonars share (Alonso's Nimrod).
namespace ganglion::subsumption {

/// Which column of the paper a behaviour follows: the printed listing with its defects, or what makes the robot good.
enum class Preset { Recommended, Listing };
inline constexpr std::array<std::string_view, 2> kPresets = {"recommended", "listing"};

/// Of a kind whose Config has a member `Preset preset`.
template <class Config>
consteval ParameterDescriptor preset_parameter() {
  return parameter<Config, &Config::preset>(
      {.name = "preset",
       .title = {"preset", "preajuste"},
       .help =
           {"recommended, or listing: what the paper's program does, defects included; it fixes all other parameters",
            "recommended, o listing: lo que hace el programa del artículo, con sus defectos; fija los demás "
            "parámetros"},
       .choices = kPresets});
}

/// Fails with BadParameter where the listing is asked for and a parameter that it fixes was given another value than its
/// default.
inline Result<void> check_listing(Preset preset, const Parameters& parameters) {
  if (preset != Preset::Listing) return {};
  for (const ParameterDescriptor& descriptor : parameters.descriptors()) {
    if (descriptor.type != ParameterType::Real && descriptor.type != ParameterType::Integer) continue;
    const double value = std::get<double>(parameters.value(descriptor.name));
    if (value == std::get<double>(descriptor.preset())) continue;
    return fail(ErrorCode::BadParameter,
                {"preset \"listing\" fixes {0}: leave {0} = {1} out, or take preset = \"recommended\"",
                 "preset \"listing\" fija {0}: quite {0} = {1}, o use preset = \"recommended\""},
                descriptor.name, value);
  }
  return {};
}

/// The input of the sonar at one front corner.
constexpr PortDescriptor sonar_port(bool left, bool required = true) noexcept {
  return {.name = left ? "left" : "right",
          .title = left ? Text{"left range", "distancia izquierda"} : Text{"right range", "distancia derecha"},
          .help = left ? Text{"Range of the left front sonar", "Distancia del sonar delantero izquierdo"}
                       : Text{"Range of the right front sonar", "Distancia del sonar delantero derecho"},
          .unit = "m",
          .required = required};
}

/// Of a kind whose Config has a member `double one_sonar_share`.
template <class Config>
consteval ParameterDescriptor one_sonar_share_parameter() {
  return parameter<Config, &Config::one_sonar_share>({.name = "one_sonar_share",
                                                      .title = {"one-sonar share", "parte con un sonar"},
                                                      .help = {"Share of the speed ahead while one sonar is dead",
                                                               "Parte de la velocidad de avance con un sonar muerto"},
                                                      .min = 0,
                                                      .max = 1,
                                                      .ours = true,
                                                      .live = true});
}

inline constexpr std::array<ElementDescriptor, 2> kTrackElements = {"left", "right"};

inline constexpr PortDescriptor kTracksPort{
    .name = "tracks",
    .title = {"tracks", "orugas"},
    .help = {"Duty of the tracks, -1 full backward to 1 full forward",
             "Ciclo de trabajo de las orugas, de -1 todo atrás a 1 todo adelante"},
    .role = PortRole::Command,
    .size = 2,
    .elements = kTrackElements};

/// Both tracks forward by `forward`, and a turn on top of it: clockwise > 0 turns right. Clamped to +-1 each.
inline Command tracks(double forward, double clockwise,
                      double ttl_s = std::numeric_limits<double>::infinity()) noexcept {
  Command command =
      Command::act({std::clamp(forward + clockwise, -1.0, 1.0), std::clamp(forward - clockwise, -1.0, 1.0)});
  command.ttl_s = ttl_s;
  return command;
}

/// Servo counts of full speed in the listing; 400 of them is its forward, 200 its escape.
inline constexpr double kListingFullCounts = 1200;
inline constexpr double kListingForwardDuty = 400 / kListingFullCounts;
/// How long the tracks move on the pulses of one program cycle: one pulse of a turn, five of a way ahead, 40 ms each.
inline constexpr double kListingTurn_s = 0.04;
inline constexpr double kListingForward_s = 0.2;

/// The listing's M, a 32-bit float as all its numbers: 360 above the difference of two ranges [cm] or bearings [deg].
inline float listing_m(float target, float present) noexcept { return target - present + 360.0F; }

/// The turn of its subroutine AJUSTE, as a duty: three counts for each whole unit of M - 360; int() cuts towards zero.
inline double listing_turn(float m) noexcept {
  const double counts = 3 * (std::trunc(static_cast<double>(m)) - 360);
  return std::clamp(counts / kListingFullCounts, -1.0, 1.0);
}

/// One program cycle's pulses: ahead where M is within `band` of 360, else the turn alone.
inline Command listing_pulses(float m, float band) noexcept {
  if (m < 360.0F + band && m > 360.0F - band) return tracks(kListingForwardDuty, 0, kListingForward_s);
  return tracks(0, listing_turn(m), kListingTurn_s);
}

/// A range as the listing's program has it [cm]: a dead sonar reads 0, a lost echo what a PING pulse of 18.5 ms gives.
inline float listing_range_cm(double range_m) noexcept {
  constexpr float kNoEcho_cm = 318.59F;  // (18500 / 2) / 29.034
  if (std::isnan(range_m)) return 0;
  return std::clamp(static_cast<float>(range_m * 100), 0.0F, kNoEcho_cm);
}

/// A range to compare with others [m]: too close is 0, nothing in range is `max_range_m`; NaN of a dead sonar stays.
inline double comparable(double range_m, double max_range_m) noexcept {
  return std::isnan(range_m) ? range_m : std::clamp(range_m, 0.0, max_range_m);
}

}  // namespace ganglion::subsumption
