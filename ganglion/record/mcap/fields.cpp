#include "ganglion/record/mcap/fields.h"

#include <zlib.h>

namespace ganglion::mcap {

void FieldWriter::string(std::string_view value) {
  u32(static_cast<std::uint32_t>(value.size()));
  bytes(value);
}

void FieldWriter::map(const Fields& fields) {
  const std::size_t start = out_.size();
  u32(0);
  for (const auto& [key, value] : fields) {
    string(key);
    string(value);
  }
  const auto length = static_cast<std::uint32_t>(out_.size() - start - sizeof(std::uint32_t));
  __builtin_memcpy(out_.data() + start, &length, sizeof length);
}

std::size_t FieldWriter::begin_record(Opcode opcode) {
  const std::size_t start = out_.size();
  u8(static_cast<std::uint8_t>(opcode));
  u64(0);
  return start;
}

void FieldWriter::end_record(std::size_t start) {
  const std::uint64_t length = out_.size() - start - kRecordHeadBytes;
  __builtin_memcpy(out_.data() + start + 1, &length, sizeof length);
}

std::string_view FieldReader::bytes(std::uint64_t count) noexcept {
  if (!ok_ || count > bytes_.size()) {
    ok_ = false;
    bytes_ = {};
    return {};
  }
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return taken;
}

Fields FieldReader::map() {
  Fields fields;
  FieldReader entries(string());
  while (entries.ok() && !entries.rest().empty()) {
    const std::string_view key = entries.string();
    const std::string_view value = entries.string();
    if (entries.ok()) fields.emplace_back(key, value);
  }
  ok_ = ok_ && entries.ok();
  return fields;
}

std::optional<RecordView> record_at(std::string_view records, std::size_t offset) noexcept {
  if (offset > records.size()) return std::nullopt;
  FieldReader reader(records.substr(offset));
  const auto opcode = static_cast<Opcode>(reader.u8());
  const std::uint64_t length = reader.u64();
  const std::string_view content = reader.bytes(length);
  if (!reader.ok()) return std::nullopt;
  return RecordView{opcode, content, offset};
}

std::uint32_t crc32(std::string_view bytes, std::uint32_t crc) noexcept {
  return static_cast<std::uint32_t>(::crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace ganglion::mcap
