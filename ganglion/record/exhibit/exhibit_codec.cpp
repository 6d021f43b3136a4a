#include "ganglion/record/exhibit/exhibit_codec.h"

#include <google/protobuf/descriptor.pb.h>

#include <cmath>

#include "ganglion/base/expects.h"
#include "ganglion/record/exhibit/exhibit.pb.h"

namespace ganglion {
namespace {

using Message = Exhibit;  // the generated one
using Words = Exhibit_Words;

void put(const Sentence& from, Words& to) {
  to.set_en(from.en);
  if (from.es != from.en) to.set_es(from.es);
}

void put(const shown::Axis& from, Exhibit_Axis& to) {
  put(from.title, *to.mutable_title());
  to.set_unit(from.unit);
  for (const Sentence& tick : from.ticks) put(tick, *to.add_ticks());
}

void put(const shown::Frame& from, Exhibit_Frame& to) {
  to.set_in(from.in);
  to.set_x(from.fixed.position.x);
  to.set_y(from.fixed.position.y);
  to.set_yaw(from.fixed.yaw.rad());
  to.set_x_column(from.x_m);
  to.set_y_column(from.y_m);
  to.set_yaw_column(from.yaw_rad);
}

std::string role_name(Role role) { return std::string(look_of(role).name); }

void put(const shown::Layer& from, Exhibit_Layer& to) {
  to.set_name(from.name);
  put(from.title, *to.mutable_title());
  to.set_unit(from.unit);
  to.set_low(from.low);
  to.set_high(from.high);
  for (const shown::Class& one : from.classes) {
    Exhibit_Class& added = *to.add_classes();
    added.set_value(one.value);
    added.set_role(role_name(one.role));
    put(one.title, *added.mutable_title());
  }
}

template <class To>
void put_cells(const std::vector<std::vector<std::uint8_t>>& layers, To& to) {
  for (const auto& cells : layers) to.add_cells(cells.data(), cells.size());
}

void put(const shown::Field& from, Exhibit_Field& to) {
  to.set_frame(from.frame);
  to.set_x(from.origin.x);
  to.set_y(from.origin.y);
  to.set_cell_x(from.cell.x);
  to.set_cell_y(from.cell.y);
  to.set_columns(static_cast<std::uint32_t>(from.columns));
  to.set_rows(static_cast<std::uint32_t>(from.rows));
  if (from.across) put(*from.across, *to.mutable_across());
  if (from.up) put(*from.up, *to.mutable_up());
  for (const shown::Layer& layer : from.layers) put(layer, *to.add_layers());
  put_cells(from.cells, to);
}

void put(const shown::Patch& from, Exhibit_Patch& to) {
  to.set_column(static_cast<std::uint32_t>(from.column));
  to.set_row(static_cast<std::uint32_t>(from.row));
  to.set_columns(static_cast<std::uint32_t>(from.columns));
  to.set_rows(static_cast<std::uint32_t>(from.rows));
  put_cells(from.cells, to);
}

void put(const shown::Curve& from, Exhibit_Curve& to) {
  put(from.across, *to.mutable_across());
  put(from.up, *to.mutable_up());
  to.set_cursor(from.cursor);
  for (const shown::Line& line : from.lines) {
    Exhibit_Line& added = *to.add_lines();
    put(line.title, *added.mutable_title());
    added.set_role(role_name(line.role));
    for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i) {
      added.add_x(line.x[i]);
      added.add_y(line.y[i]);
    }
  }
}

void put(const shown::Bars& from, Exhibit_Bars& to) {
  put(from.up, *to.mutable_up());
  for (const shown::Bar& bar : from.bars) {
    Exhibit_Bar& added = *to.add_bars();
    put(bar.title, *added.mutable_title());
    added.set_value(bar.value);
    added.set_role(role_name(bar.role));
  }
}

void put(const shown::Marks& from, Exhibit_Marks& to) {
  for (const shown::Shape& shape : from.shapes) {
    Exhibit_Shape& added = *to.add_shapes();
    added.set_form(static_cast<std::uint32_t>(shape.form));
    added.set_role(role_name(shape.role));
    added.set_id(shape.id);
    added.set_frame(shape.frame);
    for (const Vector2 point : shape.points) {
      added.add_xy(point.x);
      added.add_xy(point.y);
    }
    added.set_radius(shape.radius_m);
    added.set_angle(shape.angle_rad);
    added.set_radius_column(shape.radius);
    if (!shape.label.empty()) put(shape.label, *added.mutable_label());
  }
}

void put(const shown::Network& from, Exhibit_Network& to) {
  for (const shown::Node& node : from.nodes) {
    Exhibit_Node& added = *to.add_nodes();
    put(node.title, *added.mutable_title());
    added.set_x(node.place.x);
    added.set_y(node.place.y);
    added.set_value(node.value);
    added.set_role(role_name(node.role));
  }
  for (const shown::Edge& edge : from.edges) {
    Exhibit_Edge& added = *to.add_edges();
    added.set_from(static_cast<std::uint32_t>(edge.from));
    added.set_to(static_cast<std::uint32_t>(edge.to));
    added.set_weight(edge.weight);
    added.set_role(role_name(edge.role));
  }
}

}  // namespace

std::string exhibit_descriptor() {
  google::protobuf::FileDescriptorSet set;
  Message::descriptor()->file()->CopyTo(set.add_file());
  std::string bytes;
  expects(set.SerializeToString(&bytes));
  return bytes;
}

std::string encode(const shown::Exhibit& exhibit) {
  Message message;
  put(exhibit.title, *message.mutable_title());
  const auto form = [&message]<class T>(const T& one) {
    if constexpr (std::is_same_v<T, shown::Frame>) put(one, *message.mutable_frame());
    if constexpr (std::is_same_v<T, shown::Field>) put(one, *message.mutable_field());
    if constexpr (std::is_same_v<T, shown::Patch>) put(one, *message.mutable_patch());
    if constexpr (std::is_same_v<T, shown::Curve>) put(one, *message.mutable_curve());
    if constexpr (std::is_same_v<T, shown::Bars>) put(one, *message.mutable_bars());
    if constexpr (std::is_same_v<T, shown::Marks>) put(one, *message.mutable_marks());
    if constexpr (std::is_same_v<T, shown::Network>) put(one, *message.mutable_network());
  };
  std::visit(form, exhibit.form);
  std::string bytes;
  expects(message.SerializeToString(&bytes));
  return bytes;
}

}  // namespace ganglion
