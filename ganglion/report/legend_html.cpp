#include "ganglion/report/legend_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ganglion/plot/canvas/colour.h"
#include "ganglion/report/html.h"

namespace ganglion::report {
namespace {

using plot::Language;

/// `shapes` in a box of 34 x 20.
std::string sample(std::string_view shapes) {
  return fmt::format("<svg viewBox=\"0 0 34 20\" aria-hidden=\"true\">{}</svg>", shapes);
}

std::string row(std::string_view shapes, Key key, Language language) {
  return "<li>" + sample(shapes) + worded("span", key, language) + "</li>\n";
}

std::string cell(std::string_view mark) {
  return fmt::format("<rect x=\"8\" y=\"1\" width=\"18\" height=\"18\" fill=\"#35608d\"/>{}", mark);
}

/// Every behaviour that a coordinator chooses from, in the look of its trail.
std::string behaviours(const plot::RunView& run) {
  std::string html;
  std::set<std::string> seen;
  for (const plot::RobotView& robot : run.robots)
    for (const plot::Coordination& coordination : robot.coordinations)
      for (std::size_t i = 0; i < std::min<std::size_t>(coordination.candidates.size(), 24); ++i) {
        if (!seen.insert(fmt::format("{}:{}", i, coordination.candidates[i])).second || seen.size() > 40) continue;
        const auto dash = plot::look(static_cast<int>(i)).dash_px;
        const std::string dashes = dash[0] > 0 ? fmt::format(" stroke-dasharray=\"{}\"", fmt::join(dash, " ")) : "";
        html += "<li>" +
                sample(fmt::format("<path d=\"M1 10H33\" stroke=\"var(--look-{})\" stroke-width=\"3\"{}/>", i % 8,
                                   dashes)) +
                fmt::format("<span>{}</span></li>\n", safe(coordination.candidates[i]));
      }
  return html;
}

std::string map_rows(Language language) {
  std::string scale;
  for (int i = 0; i < 32; ++i) {
    const plot::Colour c = plot::viridis(i / 31.0);
    scale +=
        fmt::format("<rect x=\"{}\" y=\"4\" width=\"1.2\" height=\"12\" fill=\"#{:02x}{:02x}{:02x}\"/>", i + 1,
                    static_cast<int>(c.red * 255), static_cast<int>(c.green * 255), static_cast<int>(c.blue * 255));
  }
  return row(scale, "risk_scale", language) +
         row(cell("<path d=\"M11 16L23 4\" stroke=\"#fff\" stroke-width=\"1.6\"/>"), "occupied", language) +
         row(cell("<circle cx=\"17\" cy=\"10\" r=\"3\" fill=\"#fff\"/>"), "dynamic_cell", language) +
         row(cell("<path d=\"M11 4L23 16M11 16L23 4\" stroke=\"#fff\" stroke-width=\"4.5\"/>"
                  "<path d=\"M11 4L23 16M11 16L23 4\" stroke=\"var(--contact)\" stroke-width=\"2\"/>"),
             "inhibited", language);
}

std::string body_shape(std::string_view edge, int width) {
  return fmt::format(
      "<rect x=\"6\" y=\"3\" width=\"22\" height=\"14\" fill=\"var(--body)\" stroke=\"var(--{0})\" "
      "stroke-width=\"{1}\"/>"
      "<path d=\"M28 10l-7-4v8z\" fill=\"var(--{0})\"/>",
      edge, width);
}

std::string ground_rows(const Content& content, Language language) {
  constexpr std::string_view kBox =
      "<rect x=\"9\" y=\"3\" width=\"16\" height=\"14\" fill=\"var(--{})\" stroke=\"var(--line)\"/>";
  std::string html;
  if (content.walls) html += row("<path d=\"M1 10H33\" stroke=\"var(--wall)\" stroke-width=\"3\"/>", "wall", language);
  if (content.furniture) html += row(fmt::format(fmt::runtime(kBox), "free"), "static_obstacle", language);
  if (content.movers) html += row(fmt::format(fmt::runtime(kBox), "mover"), "dynamic_obstacle", language);
  if (content.zones)
    html +=
        row("<rect x=\"9\" y=\"3\" width=\"16\" height=\"14\" fill=\"var(--zone)\" stroke=\"var(--line)\" "
            "stroke-dasharray=\"1 3\"/>",
            "floor_zone", language);
  if (content.bumps)
    html += row("<path d=\"M1 10H33\" stroke=\"var(--bump)\" stroke-width=\"2\" stroke-dasharray=\"8 3 2 3\"/>", "bump",
                language);
  if (content.beacons)
    html += row("<path d=\"M17 3l7 7-7 7-7-7z\" fill=\"var(--goal)\" stroke=\"#22272e\"/>", "beacon", language);
  return html;
}

}  // namespace

Content content_of(const plot::RunView& run) {
  Content content;
  for (const plot::RobotView& robot : run.robots) {
    content.sensors = content.sensors || !robot.sensors.empty();
    content.maps = content.maps || std::ranges::any_of(robot.maps, [](const auto& map) { return !map.frames.empty(); });
    content.routes = content.routes || !robot.routes.empty();
    content.goals = content.goals || !robot.goals.empty();
    content.attempts = content.attempts || !plot::failed_attempts(robot).empty();
    content.behaviours = content.behaviours || !robot.coordinations.empty();
  }
  content.movers = !run.scene.movers.empty();
  content.walls = !run.scene.walls.empty() || !run.scene.solids.empty() || run.scene.map;
  content.furniture = !run.scene.furniture.empty();
  content.zones = !run.scene.zones.empty();
  content.bumps = !run.scene.bumps.empty();
  content.beacons = !run.scene.beacons.empty();
  return content;
}

std::string legend_html(const plot::RunView& run, Language language) {
  const Content content = content_of(run);
  std::string html = "<details open>" + worded("summary", "legend", language) + "\n<ul class=\"legend\">\n";
  html += row("<circle cx=\"17\" cy=\"10\" r=\"6\" fill=\"var(--start)\" stroke=\"#22272e\"/>", "start", language);
  html += row(body_shape("wall", 2), "body", language) + row(body_shape("contact", 3), "touching", language);
  html += content.behaviours
              ? behaviours(run)
              : row("<path d=\"M1 10H33\" stroke=\"var(--trail)\" stroke-width=\"3\"/>", "trail", language);
  if (content.behaviours)
    html +=
        row("<g stroke=\"var(--look-1)\"><rect x=\"2\" y=\"4\" width=\"30\" height=\"12\" fill=\"none\" "
            "stroke=\"var(--muted)\"/>"
            "<path d=\"M4 16L14 4M12 16L22 4M20 16L30 4\"/></g>",
            "suppressed", language);
  if (content.sensors) {
    html +=
        row("<g fill=\"none\" stroke=\"var(--sonar)\"><path d=\"M14 8a4 4 0 0 1 0 5M20 5a9 9 0 0 1 0 10\"/>"
            "<path d=\"M27 2a14 14 0 0 1 0 16\" stroke-width=\"2.4\"/></g>",
            "cone", language);
    html +=
        row("<path d=\"M4 10L28 2a14 14 0 0 1 0 16z\" fill=\"none\" stroke=\"var(--sonar)\" stroke-dasharray=\"3 4\"/>",
            "cone_empty", language);
  }
  if (content.goals)
    html += row("<circle cx=\"17\" cy=\"10\" r=\"7\" fill=\"var(--goal)\" stroke=\"#22272e\"/>", "goal", language);
  if (content.routes)
    html += row("<path d=\"M1 10H33\" stroke=\"var(--route)\" stroke-width=\"2\" stroke-dasharray=\"6 4\"/>", "route",
                language);
  if (content.attempts)
    html += row("<path d=\"M1 10H33\" stroke=\"var(--attempt)\" stroke-width=\"2.4\" stroke-dasharray=\"2 3\"/>",
                "attempts", language);
  if (content.maps) html += map_rows(language);
  return html + ground_rows(content, language) + "</ul></details>\n";
}

}  // namespace ganglion::report
