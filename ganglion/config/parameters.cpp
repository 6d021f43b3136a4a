#include <algorithm>

#include "ganglion/base/text.h"
#include "ganglion/config/table.h"

namespace ganglion::config {
namespace {

std::string numbers_text(std::span<const double> numbers) {
  std::vector<std::string> words;
  for (const double number : numbers) words.push_back(shortest(number));
  return join(words);
}

/// Takes a number within the parameter's range; one that is not among those allowed is reported.
void set_number(Table& table, const ParameterDescriptor& descriptor, double number, Parameters& into) {
  const auto& allowed = descriptor.allowed;
  if (allowed.empty() || std::find(allowed.begin(), allowed.end(), number) != allowed.end()) {
    into.set(descriptor.name, number);
    return;
  }
  table.problem(descriptor.name, ErrorCode::BadParameter,
                {"{} is {}, must be one of {}", "{} es {}, debe ser uno de {}"}, descriptor.name, shortest(number),
                numbers_text(allowed));
}

}  // namespace

/// The file that the key names, else the preset; none where that is no file at all, or it was reported.
std::optional<FileText> Table::file_text(std::string_view key, const FileText& preset) {
  const std::string named = text(key, preset.name);
  const std::string role = fmt::format("{}.{}.{}", list_, context_, key);
  if (named.empty() && !preset.name.empty()) {
    problem(key, ErrorCode::BadParameter,
            {"{} is empty; name a file, or \"{}\"", "{} está vacío; nombre un archivo, o \"{}\""}, key, preset.name);
  }
  if (named.empty() || (files_ == nullptr && named == preset.name)) return std::nullopt;
  if (files_ == nullptr) {
    problem(key, ErrorCode::Unsupported, {"{}: no file can be read here", "{}: aquí no se puede leer ningún archivo"},
            key);
    return std::nullopt;
  }
  if (named == preset.name) {
    const OpenedFile& file = files_->at(files_->builtin(role, named, preset.text, files_->index_of(place(key).file)));
    return FileText{named, *file.text, ""};
  }
  if (named.starts_with(kBuiltin)) {
    const std::vector<std::string> known(preset.name.empty() ? 0 : 1, preset.name);
    problem(key, Error{ErrorCode::UnknownKey,
                       say({"{} = \"{}\" is no text of the program{}", "{} = \"{}\" no es un texto del programa{}"},
                           key, named, suggestion(named, known)),
                       {},
                       {.found = named, .choices = known}});
    return std::nullopt;
  }
  const int index = open(key, role, kMaxFileText);
  if (index < 0) return std::nullopt;
  const OpenedFile& file = files_->at(index);
  const std::optional<std::size_t> broken = first_not_utf8(*file.text);
  if (!broken) return FileText{named, *file.text, file.resolved.string()};
  const auto line = std::count(file.text->begin(), file.text->begin() + static_cast<std::ptrdiff_t>(*broken), '\n') + 1;
  problem(key, ErrorCode::Unsupported,
          {"{}: \"{}\" is not UTF-8 text: its line {} holds the byte 0x{:02x}",
           "{}: \"{}\" no es texto UTF-8: su línea {} contiene el byte 0x{:02x}"},
          key, file.resolved.string(), line, static_cast<unsigned>(static_cast<unsigned char>((*file.text)[*broken])));
  return std::nullopt;
}

void Table::read(const ParameterDescriptor& descriptor, Parameters& into) {
  const Range range{descriptor.min, descriptor.max};
  const std::string_view name = descriptor.name;
  const ParameterValue preset = descriptor.preset();
  const auto preset_number = [&preset] { return std::get<double>(preset); };
  switch (descriptor.type) {
    case ParameterType::Real:
      set_number(*this, descriptor, number(name, preset_number(), range), into);
      break;
    case ParameterType::Integer:
      set_number(*this, descriptor, integer(name, static_cast<int>(preset_number()), range), into);
      break;
    case ParameterType::Boolean:
      into.set(name, boolean(name, preset_number() != 0) ? 1 : 0);
      break;
    case ParameterType::Choice:
      into.set(name, choice(name, descriptor.choices, static_cast<int>(preset_number())));
      break;
    case ParameterType::Word:
      into.set_word(name, text(name, std::get<std::string>(preset)));
      break;
    case ParameterType::Reals:
      into.set_reals(name, numbers(name, std::get<std::vector<double>>(preset),
                                   static_cast<std::size_t>(descriptor.count), range));
      break;
    case ParameterType::File:
      if (auto file = file_text(name, std::get<FileText>(preset))) into.set_file(name, std::move(*file));
      break;
  }
}

Parameters Table::parameters(std::span<const ParameterDescriptor> descriptors) {
  Parameters result(descriptors);
  for (const ParameterDescriptor& descriptor : descriptors) {
    asks(descriptor.name, {.parameter = &descriptor});
    const bool absent = !has(descriptor.name);
    known(descriptor.name);
    const bool of_program = descriptor.type == ParameterType::File && outline_ == nullptr;  // the preset counts as read
    if (!absent || of_program) read(descriptor, result);
  }
  return result;
}

}  // namespace ganglion::config
