#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "ganglion/base/sentence.h"
#include "ganglion/exhibit/role.h"
#include "ganglion/geometry/pose2.h"

namespace ganglion {

/// A frame that shapes are drawn in: fixed in another, or led by three recorded columns, so that what moves is recorded
/// once. A column that is "" leads nothing; a frame is found by its name among those of whoever shows it, then among
/// those of the same robot, then of the whole application.
struct FrameExhibit {
  std::string_view name;  ///< "cart", "link2"
  std::string_view in = "world";
  Pose2 fixed{};                                      ///< Where it stands in the other; what is led is added.
  std::string_view x_m = "", y_m = "", yaw_rad = "";  ///< Columns of the robot's signals: "truth.x_m".
};

struct Axis {
  Text title{"", ""};
  std::string_view unit = "";
  std::span<const Text> ticks{};  ///< Where the axis counts things: terms of a rule table.
};

/// A value that is a name.
struct Class {
  float value = 0;
  Role role = Role::Plain;
  Text title{"", ""};
};

struct Scale {
  double low = 0, high = 1;          ///< Values outside are drawn as the ends.
  std::span<const Class> classes{};  ///< Where values are names; else the scale is continuous.
};

/// One layer of a field, row by row from the lowest; NaN where nothing is known.
struct Layer {
  std::string_view name;
  Text title{"", ""};
  std::string_view unit = "";
  Scale scale{};
  std::span<const float> values{};
};

/// Columns x rows cells with any number of layers over the same ground.
struct FieldExhibit {
  std::string_view name;
  Text title{"", ""};
  std::string_view frame = "world";  ///< "" = none: axes of its own.
  Vector2 origin{};                  ///< Corner of the first cell, in metres of the frame or units of the axes.
  Vector2 cell{1, 1};
  int columns = 0, rows = 0;
  std::optional<Axis> across{}, up{};
  std::span<const Layer> layers{};
  std::uint64_t generation = 0;  ///< See Exhibition::lacks().
};

struct Line {
  Text title{"", ""};
  Role role = Role::Plain;
  std::span<const double> x{}, y{};
};

struct CurveExhibit {
  std::string_view name;
  Text title{"", ""};
  Axis across, up;
  std::span<const Line> lines{};
  std::string_view cursor = "";  ///< A signal that marks a place on the axis across.
};

struct Bar {
  Text title{"", ""};
  double value = 0;
  Role role = Role::Plain;
};

struct BarExhibit {
  std::string_view name;
  Text title{"", ""};
  Axis up;
  std::span<const Bar> bars{};
};

enum class Form : std::uint8_t { Polyline, Polygon, Disc, Sector, Point, Label };

/// One thing that is drawn. Disc, Sector, Point and Label stand at the first point.
struct Shape {
  Form form = Form::Polyline;
  Role role = Role::Plain;
  std::string_view id = "";  ///< What an intervention takes hold of it by.
  std::string_view frame = "world";
  std::span<const Vector2> points{};  ///< [m]
  double radius_m = 0;                ///< 0 of a disc: as small as can be seen.
  double angle_rad = 0;               ///< Full opening of a sector, about the frame's x axis.
  std::string_view radius = "";       ///< A signal that says the radius [m]: the echo of a sonar.
  Sentence label{};
};

struct MarkExhibit {
  std::string_view name;
  Text title{"", ""};
  std::span<const Shape> shapes{};
};

struct Node {
  Text title{"", ""};
  Vector2 place{};  ///< Any unit: drawn to fit.
  double value = 0;
  Role role = Role::Plain;
};

struct Edge {
  int from = 0, to = 0;  ///< Indices of nodes.
  double weight = 1;
  Role role = Role::Plain;
};

struct NetworkExhibit {
  std::string_view name;
  Text title{"", ""};
  std::span<const Node> nodes{};
  std::span<const Edge> edges{};
};

/// Where a component, task or application shows what it thinks, by form: between ticks, only when somebody records or
/// watches. It never alters the run. Whoever shows again what did not change is told apart by content; nothing is
/// written twice.
class Exhibition {
 public:
  virtual ~Exhibition() = default;
  /// Whether a field of that generation is not there yet: asked before its layers are gathered.
  virtual bool lacks(std::string_view field, std::uint64_t generation) = 0;
  virtual void frame(const FrameExhibit& frame) = 0;
  virtual void field(const FieldExhibit& field) = 0;
  virtual void curve(const CurveExhibit& curve) = 0;
  virtual void bars(const BarExhibit& bars) = 0;
  virtual void marks(const MarkExhibit& marks) = 0;
  virtual void network(const NetworkExhibit& network) = 0;
};

/// What has something to show to an onlooker.
class Exhibitor {
 public:
  virtual ~Exhibitor() = default;
  virtual void show(Exhibition&) const {}
};

}  // namespace ganglion
