// Reads the files of a ROS map.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ganglion/base/file.h"
#include "ganglion/base/text.h"
#include "ganglion/sim/world/map/flat_yaml.h"
#include "ganglion/sim/world/map/grey_image.h"
#include "ganglion/sim/world/map/occupancy_map.h"
#include "ganglion/sim/world/shape/limits.h"

namespace ganglion::sim {
namespace {

constexpr std::array<std::string_view, 6> kRequired = {"image",  "resolution",      "origin",
                                                       "negate", "occupied_thresh", "free_thresh"};

/// The entries of a map file, asked for one by one; where something is wrong a default stands in.
class MapFile {
 public:
  MapFile(std::vector<YamlEntry> entries, std::string file, Problems& problems)
      : entries_(std::move(entries)), file_(std::move(file)), problems_(problems) {
    for (const std::string_view key : kRequired) {
      if (find(key) == nullptr) note({ErrorCode::MissingKey, say({"{} is missing", "falta {}"}, key), {file_}});
    }
  }

  const YamlEntry* find(std::string_view key) const noexcept {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e.key == key; });
    return found == entries_.end() ? nullptr : &*found;
  }

  std::string word(std::string_view key, std::string preset) {
    const YamlEntry* entry = find(key);
    if (entry == nullptr) return preset;
    if (!entry->is_list) return entry->items.front();
    note({ErrorCode::BadType, say({"{} is a list, must be one value", "{} es una lista, debe ser un solo valor"}, key),
          entry->place});
    return preset;
  }

  /// `count` numbers in [min, max], brackets required where there are several.
  std::vector<double> numbers(std::string_view key, std::size_t count, double min, double max) {
    std::vector<double> values;
    const YamlEntry* entry = find(key);
    if (entry == nullptr) return std::vector<double>(count, min);
    if (entry->items.size() != count || entry->is_list != (count > 1)) {
      const Sentence right = count == 1 ? say({"one number", "un número"})
                                        : say({"a list of {} numbers", "una lista de {} números"}, count);
      note({ErrorCode::BadType, say({"{} must be {}", "{} debe ser {}"}, key, right), entry->place});
      return std::vector<double>(count, min);
    }
    for (const std::string& item : entry->items) {
      const auto value = parse_number(item);
      if (!value || !(*value >= min && *value <= max)) {
        note({value ? ErrorCode::BadParameter : ErrorCode::BadType,
              say({"{} is {}, must be a number from {} to {}", "{} es {}, debe ser un número de {} a {}"}, key, item,
                  shortest(min), shortest(max)),
              entry->place});
      }
      values.push_back(value.value_or(min));
    }
    return values;
  }
  double number(std::string_view key, double min, double max) { return numbers(key, 1, min, max).front(); }

  bool flag(std::string_view key) {
    const std::string value = word(key, "0");
    if (value != "0" && value != "1" && value != "true" && value != "false") {
      note({ErrorCode::BadType, say({"{} is {}, must be 0 or 1", "{} es {}, debe ser 0 o 1"}, key, value), place(key)});
    }
    return value == "1" || value == "true";
  }

  Place place(std::string_view key) const {
    const YamlEntry* entry = find(key);
    return entry != nullptr ? entry->place : Place{file_};
  }
  void note(Error error) { problems_.add(std::move(error)); }

 private:
  std::vector<YamlEntry> entries_;
  std::string file_;
  Problems& problems_;
};

struct Thresholds {
  bool negate;
  double occupied;
  double free;
};

std::vector<Occupancy> cells_of(const GreyImage& image, const Thresholds& thresholds) {
  std::vector<Occupancy> of_value(static_cast<std::size_t>(image.max_value) + 1);
  for (int value = 0; value <= image.max_value; ++value) {
    const double shade = double(thresholds.negate ? value : image.max_value - value) / image.max_value;
    of_value[value] = shade > thresholds.occupied ? Occupancy::Occupied
                      : shade < thresholds.free   ? Occupancy::Free
                                                  : Occupancy::Unknown;
  }
  std::vector<Occupancy> cells;
  cells.reserve(image.values.size());
  for (int row = image.rows - 1; row >= 0; --row) {  // the picture has its top row first
    const auto* pixels = image.values.data() + static_cast<std::size_t>(row) * image.columns;
    for (int column = 0; column < image.columns; ++column) cells.push_back(of_value[pixels[column]]);
  }
  return cells;
}

Result<GreyImage> load_image(FileReader& files, int yaml, const std::string& named, const Place& named_at) {
  const auto file = files.open("image", named, yaml, kMaxFileBytes);
  if (!file && file.error().code == ErrorCode::NotFound) {
    const std::filesystem::path path = files.at(yaml).resolved.parent_path() / named;
    return fail_at(named_at, ErrorCode::NotFound, {"there is no picture {}", "no existe la imagen {}"}, path.string());
  }
  if (!file) return tl::unexpected<Error>(file.error());
  const OpenedFile& image = files.at(*file);
  return parse_pgm(*image.text, image.resolved.string(), kMaxMapCells);
}

bool within_limits(const Box2& box) noexcept {
  const Box2 limits{{-kMaxCoordinate_m, -kMaxCoordinate_m}, {kMaxCoordinate_m, kMaxCoordinate_m}};
  return limits.contains(box.lower) && limits.contains(box.upper);
}

/// None if anything is wrong, which then stands in `problems`.
std::optional<OccupancyMap> read_map(FileReader& files, int yaml, Problems& problems) {
  auto keep = [&](const Error& error) {
    problems.add(error);
    return std::nullopt;
  };
  const std::string name = files.at(yaml).resolved.string();
  auto entries = parse_flat_yaml(*files.at(yaml).text, name);
  if (!entries) return keep(entries.error());
  const std::size_t before = problems.size();
  MapFile file(std::move(*entries), name, problems);
  const std::string image_name = file.word("image", "");
  const double resolution_m = file.number("resolution", 1e-4, 1000);
  const auto origin = file.numbers("origin", 3, -kMaxCoordinate_m, kMaxCoordinate_m);
  const Thresholds thresholds{file.flag("negate"), file.number("occupied_thresh", 0, 1),
                              file.number("free_thresh", 0, 1)};
  if (const std::string mode = file.word("mode", "trinary"); mode != "trinary") {
    file.note({ErrorCode::Unsupported,
               say({"mode is {}; only trinary maps are read", "mode es {}; solo se leen mapas trinary"}, mode),
               file.place("mode")});
  }
  if (problems.size() > before) return std::nullopt;
  const auto image = load_image(files, yaml, image_name, file.place("image"));
  if (!image) return keep(image.error());
  const Pose2 pose{{origin[0], origin[1]}, Angle::from_rad(origin[2]).wrapped()};
  OccupancyMap map(image->columns, image->rows, resolution_m, pose, cells_of(*image, thresholds));
  if (within_limits(map.bounds())) return map;
  return keep(Error{
      ErrorCode::TooLarge,
      say({"the map reaches beyond {} m from the world's origin", "el mapa llega a más de {} m del origen del mundo"},
          kMaxCoordinate_m),
      file.place("origin")});
}

}  // namespace

Result<OccupancyMap> OccupancyMap::load(FileReader& files, int yaml, Problems& problems) {
  auto map = read_map(files, yaml, problems);
  if (map) return std::move(*map);
  return tl::unexpected<Error>(problems.sorted().front());
}

Result<OccupancyMap> OccupancyMap::load(const std::filesystem::path& yaml_path, Problems& problems) {
  DiskFiles files;
  const auto yaml = files.open("map", yaml_path.string(), -1, kMaxMapText);
  if (yaml) return load(files, *yaml, problems);
  problems.add(yaml.error());
  return tl::unexpected<Error>(problems.sorted().front());
}

}  // namespace ganglion::sim
