#include "ganglion/experience/stored_part.h"

#include <map>
#include <tuple>

#include "ganglion/base/hash.h"
#include "ganglion/record/mcap/fields.h"

namespace ganglion {
namespace {

// magic, u32 version, u64 count; for each part component, kind, u32 version, name, u64 size, bytes; u64 hash of all
// before. Strings have a u32 length in front; numbers are little-endian.
constexpr std::string_view kMagic = "GANGLEXP";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHashBytes = sizeof(std::uint64_t);

std::map<std::pair<std::string_view, std::string_view>, const StoredPart*> by_key(std::span<const StoredPart> parts) {
  std::map<std::pair<std::string_view, std::string_view>, const StoredPart*> sorted;
  for (const StoredPart& part : parts) sorted[{part.component, part.name}] = &part;
  return sorted;
}

std::uint64_t hash_text(std::string_view text) noexcept { return hash_bytes(std::as_bytes(std::span(text))); }

std::string_view as_text(std::span<const std::byte> bytes) noexcept {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

StoredPart read_part(mcap::FieldReader& reader) {
  StoredPart part;
  part.component = reader.string();
  part.kind = reader.string();
  part.version = reader.u32();
  part.name = reader.string();
  const auto bytes = std::as_bytes(std::span(reader.bytes(reader.u64())));
  part.bytes.assign(bytes.begin(), bytes.end());
  return part;
}

}  // namespace

std::uint64_t snapshot_hash(std::span<const StoredPart> parts) {
  std::uint64_t hash = 0;
  for (const auto& [key, part] : by_key(parts)) {
    hash = combine(hash, hash_name(part->component));
    hash = combine(hash, hash_name(part->kind));
    hash = combine(hash, part->version);
    hash = combine(hash, hash_name(part->name));
    hash = combine(hash, hash_bytes(part->bytes));
  }
  return hash;
}

std::string export_parts(std::span<const StoredPart> parts) {
  const auto sorted = by_key(parts);
  std::string out(kMagic);
  mcap::FieldWriter writer(out);
  writer.u32(kVersion);
  writer.u64(sorted.size());
  for (const auto& [key, part] : sorted) {
    writer.string(part->component);
    writer.string(part->kind);
    writer.u32(part->version);
    writer.string(part->name);
    writer.u64(part->bytes.size());
    writer.bytes(as_text(part->bytes));
  }
  writer.u64(hash_text(out));
  return out;
}

Result<std::vector<StoredPart>> import_parts(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(kMagic) || bytes.size() < kMagic.size() + kHashBytes) {
    return fail_at({name}, ErrorCode::Corrupt,
                   {"is no exported experience: it must begin with \"{}\"",
                    "no es una experiencia exportada: debe empezar con \"{}\""},
                   kMagic);
  }
  if (bytes.size() > kMaxExperienceBytes) {
    return fail_at({name}, ErrorCode::TooLarge, {"has {} bytes; the limit is {}", "tiene {} bytes; el límite es {}"},
                   bytes.size(), kMaxExperienceBytes);
  }
  mcap::FieldReader reader(bytes.substr(kMagic.size(), bytes.size() - kMagic.size() - kHashBytes));
  if (const std::uint32_t version = reader.u32(); version > kVersion) {
    return fail_at({name}, ErrorCode::Unsupported,
                   {"was exported by a newer program (version {}, known up to {})",
                    "lo exportó un programa más nuevo (versión {}, se conoce hasta la {})"},
                   version, kVersion);
  }
  if (mcap::FieldReader(bytes.substr(bytes.size() - kHashBytes)).u64() !=
      hash_text(bytes.substr(0, bytes.size() - kHashBytes))) {
    return fail_at({name}, ErrorCode::Corrupt, {"does not match its checksum", "no coincide con su suma de control"});
  }
  std::vector<StoredPart> parts;
  const std::uint64_t count = reader.u64();
  for (std::uint64_t i = 0; i < count && reader.ok(); ++i) {
    parts.push_back(read_part(reader));
    const bool ordered = parts.size() < 2 || std::tie(parts[i - 1].component, parts[i - 1].name) <
                                                 std::tie(parts[i].component, parts[i].name);
    if (!ordered)
      return fail_at({name}, ErrorCode::Corrupt,
                     {"has its parts out of order, or one twice", "tiene las partes en desorden, o una repetida"});
  }
  if (!reader.ok() || !reader.rest().empty())
    return fail_at({name}, ErrorCode::Corrupt, {"has lengths that do not add up", "tiene longitudes que no cuadran"});
  return parts;
}

}  // namespace ganglion
