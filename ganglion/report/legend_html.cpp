#include "ganglion/report/legend_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

std::string said_row(std::string_view shapes, const Sentence& words, Language language) {
  return "<li>" + sample(shapes) + recorded("span", words, language) + "</li>\n";
}

std::string scale_sample() {
  std::string scale;
  for (int i = 0; i < 32; ++i) {
    const plot::Colour c = plot::viridis(i / 31.0);
    scale +=
        fmt::format("<rect x=\"{}\" y=\"4\" width=\"1.2\" height=\"12\" fill=\"#{:02x}{:02x}{:02x}\"/>", i + 1,
                    static_cast<int>(c.red * 255), static_cast<int>(c.green * 255), static_cast<int>(c.blue * 255));
  }
  return scale;
}

std::string sign_sample(const RoleLook& look) {
  const std::string cell = fmt::format(
      "<rect x=\"8\" y=\"1\" width=\"18\" height=\"18\" fill=\"var(--role-{})\" stroke=\"var(--line)\"/>", look.name);
  switch (look.sign) {
    case Sign::None:
      return cell;
    case Sign::Hatch:
      return cell + "<path d=\"M11 16L23 4\" stroke=\"#fff\" stroke-width=\"1.6\"/>";
    case Sign::Dot:
      return cell + "<circle cx=\"17\" cy=\"10\" r=\"3\" fill=\"#fff\"/>";
    case Sign::Cross:
      break;
  }
  return cell + "<path d=\"M11 4L23 16M11 16L23 4\" stroke=\"#fff\" stroke-width=\"2.5\"/>";
}

/// Scales and classes of every layer, each name once.
std::string field_rows(const plot::RunView& run, Language language) {
  std::string html;
  std::set<std::string> seen;
  for (const ExhibitTrack& track : run.exhibits) {
    const auto field = field_at(track, std::numeric_limits<double>::infinity());
    if (!field || field->frame.empty()) continue;
    for (const shown::Layer& layer : field->layers) {
      if (!seen.insert(track.name + "/" + layer.name).second || seen.size() > 60) continue;
      if (layer.classes.empty()) {
        const Sentence unit = Sentence::quoted(layer.unit.empty() ? "" : " " + layer.unit);
        html += said_row(scale_sample(),
                         say({"{}, {:g} to {:g}{}", "{}, de {:g} a {:g}{}"}, layer.title, layer.low, layer.high, unit),
                         language);
      }
      for (const shown::Class& one : layer.classes)
        html += said_row(sign_sample(look_of(one.role)), one.title, language);
    }
  }
  return html;
}

std::string shape_sample(Form form, const RoleLook& look) {
  const std::string dash =
      look.dash[0] > 0 ? fmt::format(" stroke-dasharray=\"{} {}\"", look.dash[0], look.dash[1]) : "";
  const std::string line = fmt::format("stroke=\"var(--role-{})\" stroke-width=\"2.2\"{}", look.name, dash);
  const std::string fill = look.filled ? fmt::format("fill=\"var(--role-{})\"", look.name) : "fill=\"none\"";
  switch (form) {
    case Form::Polygon:
      return fmt::format("<rect x=\"6\" y=\"4\" width=\"22\" height=\"12\" {} {}/>", fill, line);
    case Form::Disc:
      return fmt::format(
          "<circle cx=\"17\" cy=\"10\" r=\"7\" {} {}/>{}", fill, look.filled ? "stroke=\"#22272e\"" : line,
          look.sign == Sign::Cross ? "<path d=\"M13 6L21 14M13 14L21 6\" stroke=\"#22272e\" stroke-width=\"1.8\"/>"
                                   : "");
    case Form::Sector:
      return fmt::format("<path d=\"M4 10L28 2a14 14 0 0 1 0 16z\" fill=\"none\" {}/>", line);
    case Form::Point:
      return fmt::format("<circle cx=\"17\" cy=\"10\" r=\"4\" fill=\"var(--role-{})\"/>", look.name);
    case Form::Polyline:
    case Form::Label:
      break;
  }
  return fmt::format("<path d=\"M1 10H33\" {}/>", line);
}

/// One row for each role and form that ever was shown.
std::string shape_rows(const plot::RunView& run, Language language) {
  std::set<std::pair<Role, Form>> seen;
  for (const ExhibitTrack& track : run.exhibits) {
    for (const shown::Exhibit& state : track.states) {
      const auto* marks = std::get_if<shown::Marks>(&state.form);
      if (marks == nullptr) continue;
      for (const shown::Shape& shape : marks->shapes) {
        if (shape.form != Form::Label) seen.insert({shape.role, shape.form});
      }
    }
  }
  std::string html;
  for (const auto& [role, form] : seen) {
    const RoleLook& look = look_of(role);
    const Sentence words{std::string(look.word.in(Language::English)), std::string(look.word.in(Language::Spanish))};
    html += said_row(shape_sample(form, look), words, language);
  }
  return html;
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
    content.behaviours = content.behaviours || !robot.coordinations.empty();
  }
  content.way = plot::has_way(run);
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
  if (content.way) {
    html += row("<circle cx=\"17\" cy=\"10\" r=\"6\" fill=\"var(--start)\" stroke=\"#22272e\"/>", "start", language);
    html += row(body_shape("wall", 2), "body", language) + row(body_shape("contact", 3), "touching", language);
  }
  if (content.behaviours) {
    html += behaviours(run);
  } else if (content.way) {
    html += row("<path d=\"M1 10H33\" stroke=\"var(--trail)\" stroke-width=\"3\"/>", "trail", language);
  }
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
  html += shape_rows(run, language) + field_rows(run, language);
  return html + ground_rows(content, language) + "</ul></details>\n";
}

}  // namespace ganglion::report
