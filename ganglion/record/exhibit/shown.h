#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ganglion/exhibit/exhibit.h"

/// What was shown, as it is recorded: the forms of ganglion/exhibit/exhibit.h with contents of their own.
namespace ganglion::shown {

struct Axis {
  Sentence title;
  std::string unit;
  std::vector<Sentence> ticks;
  friend bool operator==(const Axis&, const Axis&) = default;
};

struct Frame {
  std::string in;
  Pose2 fixed{};
  std::string x_m, y_m, yaw_rad;
};

struct Class {
  double value = 0;
  Role role = Role::Plain;
  Sentence title;
  friend bool operator==(const Class&, const Class&) = default;
};

/// A byte of a cell that nothing is known of; 0 = the scale's low end, 254 = the high one.
inline constexpr std::uint8_t kUnknownCell = 255;

struct Layer {
  std::string name;
  Sentence title;
  std::string unit;
  double low = 0, high = 1;
  std::vector<Class> classes;

  std::uint8_t byte_of(double value) const noexcept;
  /// NaN for kUnknownCell.
  double value_of(std::uint8_t byte) const noexcept;
  /// The class whose value is nearest; null where the layer has none, or for kUnknownCell.
  const Class* class_of(std::uint8_t byte) const noexcept;
  friend bool operator==(const Layer&, const Layer&) = default;
};

/// A field as a whole. Every layer has columns * rows cells.
struct Field {
  std::string frame;
  Vector2 origin{}, cell{1, 1};
  int columns = 0, rows = 0;
  std::optional<Axis> across, up;
  std::vector<Layer> layers;
  std::vector<std::vector<std::uint8_t>> cells;

  bool same_make(const Field& other) const noexcept;
};

/// New contents of a rectangle of a field.
struct Patch {
  int column = 0, row = 0, columns = 0, rows = 0;
  std::vector<std::vector<std::uint8_t>> cells;
};
/// Whether it lies inside, with as many layers, each of its size.
bool fits(const Patch& patch, const Field& field);
/// False, and nothing changed, where it does not fit.
bool apply(const Patch& patch, Field& field);
/// The least rectangle in which two fields of the same make differ; none where they are equal.
std::optional<Patch> difference(const Field& before, const Field& now);

struct Line {
  Sentence title;
  Role role = Role::Plain;
  std::vector<double> x, y;
};
struct Curve {
  Axis across, up;
  std::vector<Line> lines;
  std::string cursor;
};
struct Bar {
  Sentence title;
  double value = 0;
  Role role = Role::Plain;
};
struct Bars {
  Axis up;
  std::vector<Bar> bars;
};
struct Shape {
  Form form = Form::Polyline;
  Role role = Role::Plain;
  std::string id, frame;
  std::vector<Vector2> points;
  double radius_m = 0, angle_rad = 0;
  std::string radius;
  Sentence label;
  friend bool operator==(const Shape&, const Shape&) = default;
};
struct Marks {
  std::vector<Shape> shapes;
};
struct Node {
  Sentence title;
  Vector2 place{};
  double value = 0;
  Role role = Role::Plain;
};
struct Edge {
  int from = 0, to = 0;
  double weight = 1;
  Role role = Role::Plain;
};
struct Network {
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

struct Exhibit {
  Sentence title;
  std::variant<Frame, Field, Patch, Curve, Bars, Marks, Network> form;
};

}  // namespace ganglion::shown
