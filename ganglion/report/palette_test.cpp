#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>

#include "ganglion/plot/canvas/colour.h"
#include "ganglion/report/embedded.h"

// The pages draw risk in the colours of the pictures, by tables of their own: scripts and styles cannot ask C++.
namespace ganglion::report {
namespace {

namespace fs = std::filesystem;

using Rgb = std::array<int, 3>;

Rgb bytes_of(const plot::Colour& colour) {
  const auto byte = [](double part) { return static_cast<int>(std::lround(part * 255)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue)};
}

/// The stops of the scale, lowest first.
std::vector<Rgb> stops_of_pictures() {
  std::vector<Rgb> stops;
  for (int i = 0; i <= 10; ++i) stops.push_back(bytes_of(plot::viridis(i / 10.0)));
  return stops;
}

/// The list of [red, green, blue] that a script gives a name to; empty where it does not.
std::vector<Rgb> stops_of(const std::string& script, const std::string& name) {
  const std::size_t begin = script.find("const " + name + " = [");
  if (begin == std::string::npos) return {};
  const std::string list = script.substr(begin, script.find("];", begin) - begin);
  static const std::regex kStop("\\[(\\d+), (\\d+), (\\d+)\\]");
  std::vector<Rgb> stops;
  for (std::sregex_iterator at(list.begin(), list.end(), kStop), end; at != end; ++at) {
    stops.push_back({std::stoi((*at)[1]), std::stoi((*at)[2]), std::stoi((*at)[3])});
  }
  return stops;
}

/// The one file of the studio's page with this ending in which that text stands.
std::string page_source(const std::string& ending, const std::string& text) {
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(GANGLION_SOURCE_DIR) / "studio" / "src")) {
    if (entry.path().extension() != ending) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (content.find(text) != std::string::npos) return content;
  }
  ADD_FAILURE() << "no " << ending << " with " << text;
  return "";
}

TEST(Viridis, IsTheSameInThePlayerOfAReport) {
  EXPECT_EQ(stops_of(std::string(kPlayerScript), "VIRIDIS"), stops_of_pictures());
}

TEST(Viridis, IsTheSameInTheStudio) {
  EXPECT_EQ(stops_of(page_source(".ts", "const kViridis = ["), "kViridis"), stops_of_pictures());
}

TEST(Viridis, IsNearlyTheSameInTheLegendOfTheStudio) {
  const std::string style = page_source(".css", ".viridis-0 {");
  static const std::regex kRule("\\.viridis-(\\d) \\{\\s*fill: #([0-9a-f]{6});");
  int rules = 0;
  for (std::sregex_iterator at(style.begin(), style.end(), kRule), end; at != end; ++at, ++rules) {
    const Rgb shown = bytes_of(plot::Colour::hex(static_cast<std::uint32_t>(std::stoul((*at)[2], nullptr, 16))));
    const Rgb drawn = bytes_of(plot::viridis(std::stoi((*at)[1]) / 6.0));
    // The scale's own values at these places, where the drawings go straight from stop to stop.
    for (std::size_t part = 0; part < 3; ++part) EXPECT_NEAR(shown[part], drawn[part], 3) << (*at)[0];
  }
  EXPECT_EQ(rules, 7);
}

}  // namespace
}  // namespace ganglion::report
