#include "ganglion/sim/robot/truth_channels.h"

#include <gtest/gtest.h>

#include <map>

namespace ganglion::sim {
namespace {

TEST(TruthChannels, TellEachValueUnderItsName) {
  Truth truth;
  truth.pose = {{1, 2}, Angle::from_rad(0.5)};
  truth.touched = true;
  truth.energy_J = 3;
  truth.travelled_m = 4;
  truth.contacts = 5;
  truth.fastest_contact_mps = 0.6;
  truth.stalled = true;
  std::vector<double> row(truth_channels().size());
  write_truth(truth, row);
  std::map<std::string, double> told;
  for (std::size_t i = 0; i < row.size(); ++i) told[truth_channels()[i].name] = row[i];
  const std::map<std::string, double> expected = {
      {"x_m", 1},      {"y_m", 2},         {"yaw_rad", 0.5}, {"touching", 1},
      {"energy_J", 3}, {"travelled_m", 4}, {"contacts", 5},  {"fastest_contact_mps", 0.6},
      {"stalled", 1},  {"tipped", 0}};
  EXPECT_EQ(told, expected);
}

TEST(TruthChannels, DigestPoseAndEnergyAsEver) {
  std::string digested;
  for (const TruthChannel& channel : truth_channels()) digested += channel.digested ? channel.name + " " : "";
  EXPECT_EQ(digested, "x_m y_m yaw_rad energy_J ");
}

}  // namespace
}  // namespace ganglion::sim
