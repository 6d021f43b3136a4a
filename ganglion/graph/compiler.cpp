#include "ganglion/graph/compiler.h"

#include <cmath>

namespace ganglion {
namespace {

/// Makes the component; its part plays that role.
template <class Role, class Product>
Result<void> make(std::span<const Kind<Product>* const> kinds, const ComponentModel& model, layout::Part& part) {
  const auto* kind = find_kind(kinds, model.descriptor->name);
  expects(kind != nullptr);
  auto made = kind->make(model.parameters);
  if (!made) {
    Error error = made.error();
    error.what = say({"{}: {}", "{}: {}"}, model.id, error.what);
    if (error.place.file.empty()) error.place = model.place;
    return tl::unexpected<Error>(std::move(error));
  }
  for (const std::string_view name : model.descriptor->rests_on) {
    part.rests_on.push_back({std::string(name), model.parameters.text(name)});
  }
  part.encode = kind->encode;
  part.role = Role{made->get()};
  part.component = std::move(*made);
  return {};
}

}  // namespace

Result<Controller> Compiler::run() {
  if (auto fit = check_limits(); !fit) return tl::unexpected<Error>(fit.error());
  Problems problems;
  controller_.schedule_ = order(model_, problems);
  if (!problems.empty()) return tl::unexpected<Error>(problems.sorted().front());
  for (const ComponentModel& model : model_.components) {
    if (auto made = make_part(model); !made) return tl::unexpected<Error>(made.error());
  }
  lay_out_signals();
  lay_out_commands();
  lay_out_inputs();
  if (values_ > kMaxValues) {
    return fail(ErrorCode::TooLarge,
                {"its signals and inputs have {} values; the limit is {}",
                 "sus señales y entradas tienen {} valores; el límite es {}"},
                values_, kMaxValues);
  }
  reserve();
  for (std::size_t i = 0; i < model_.components.size(); ++i) connect(i);
  connect_answers();
  join_digest();
  controller_.block_->before = controller_.block_->now;
  controller_.grow();
  return std::move(controller_);
}

/// Whatever a robot says of itself, no command may leave the controller that is not a number.
Result<void> Compiler::check_limits() const {
  for (const CommandChannel& channel : robot_.commands) {
    for (const CommandElement& element : channel.elements) {
      const bool sound = element.min <= element.safe && element.safe <= element.max && std::isfinite(element.safe);
      if (sound) continue;
      return fail(ErrorCode::BadParameter,
                  {"robot \"{}\": {}.{}: its safe value {} must lie within [{}, {}]",
                   "robot \"{}\": {}.{}: su valor seguro {} debe estar en [{}, {}]"},
                  robot_.name, channel.name, element.name, element.safe, element.min, element.max);
    }
  }
  return {};
}

Result<void> Compiler::make_part(const ComponentModel& model) {
  Part part;
  part.id = model.id;
  if (model.descriptor != nullptr) part.kind = model.descriptor->name;
  Result<void> made;
  switch (model.component_class) {
    case ComponentClass::Sensing:
      made = make<layout::SensingRole>(kinds_.sensing, model, part);
      break;
    case ComponentClass::Goal:
      made = make<layout::GoalRole>(kinds_.goal, model, part);
      break;
    case ComponentClass::Acting:
      made = make<layout::ActingRole>(kinds_.acting, model, part);
      break;
    case ComponentClass::Coordinator:
      made = make<layout::CoordinatorRole>(kinds_.coordinator, model, part);
      break;
    default: {
      const auto channel = static_cast<std::size_t>(model.channel_index);
      part.role = layout::SensationRole{static_cast<std::size_t>(robot_.sensation_offset(channel)), channel};
    }
  }
  if (part.as<layout::SensationRole>() != nullptr)
    controller_.sensations_.push_back(static_cast<int>(controller_.parts_.size()));
  controller_.parts_.push_back(std::move(part));
  return made;
}

void Compiler::join_digest() {
  for (const Part& part : controller_.parts_) {
    const std::size_t component = controller_.digest_.join(identity_.robot, part.id);
    controller_.digested_.push_back({component, {part.signals.first, part.digested}});
  }
  controller_.digested_.push_back({controller_.digest_.join(identity_.robot, "@commands"), controller_.command_frame_});
}

Result<Controller> Controller::compile(const ControllerModel& model, const Description& robot, const KindList& kinds,
                                       const Identity& identity) {
  return Compiler(model, robot, kinds, identity).run();
}

}  // namespace ganglion
