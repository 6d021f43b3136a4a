#include "ganglion/record/mcap/reader.h"

#include <optional>

#include "ganglion/base/file.h"
#include "ganglion/record/mcap/compression.h"
#include "ganglion/record/mcap/fields.h"
#include "ganglion/record/mcap/records.h"

namespace ganglion {
namespace {

using mcap::FieldReader;
using mcap::Opcode;
using mcap::RecordView;

/// Definitions found in a chunk count only if all of the chunk is good.
struct Definitions {
  std::map<std::uint16_t, mcap::Schema> schemas;
  std::map<std::uint16_t, mcap::Channel> channels;
};

class Parser {
 public:
  Parser(std::string_view bytes, const std::string& name, Recover recover, const MessageSink& sink,
         std::size_t max_unpacked_bytes)
      : bytes_(bytes), name_(name), recover_(recover), sink_(sink), max_unpacked_bytes_(max_unpacked_bytes) {}

  Result<McapContent> parse();

 private:
  template <class... Args>
  Result<void> corrupt(std::size_t offset, Wording<std::type_identity_t<Args>...> words, const Args&... args) const {
    return fail_at({name_}, ErrorCode::Corrupt, {"byte {}: {}", "byte {}: {}"}, offset, say<Args...>(words, args...));
  }

  Result<void> header();
  Result<void> data_section();
  Result<void> data_record(const RecordView& record);
  Result<void> schema(std::string_view content, Definitions& into);
  Result<void> channel(std::string_view content, Definitions& into);
  Result<void> chunk(std::string_view content);
  Result<std::string_view> unpack(const mcap::ChunkView& chunk);
  Result<void> chunk_records(std::string_view records, Definitions& found);
  Result<void> attachment(std::string_view content);
  Result<void> metadata(std::string_view content);
  Result<void> data_end(const RecordView& record);
  Result<void> summary_section();
  Result<void> summary_record(const RecordView& record);
  Result<void> footer(const RecordView& record);
  const mcap::Channel* find_channel(std::uint16_t id, const Definitions* found) const;
  void deliver(const mcap::Message& message);
  void note_damage(const Error& error);
  bool overflowed() const noexcept { return unpacked_total_ > max_unpacked_bytes_; }
  Result<void> count_definition(std::string_view content);

  std::string_view bytes_;
  const std::string& name_;
  Recover recover_;
  const MessageSink& sink_;
  const std::size_t max_unpacked_bytes_;
  McapContent content_;
  Definitions defined_;
  mcap::Decompressor decompressor_;
  std::string unpacked_;
  std::vector<mcap::Message> batch_;
  std::size_t unpacked_total_ = 0;
  std::size_t definition_bytes_ = 0;
  std::size_t offset_ = mcap::kMagic.size();
  std::size_t record_offset_ = 0;  ///< Of the record being looked at, for messages.
  std::size_t summary_start_ = 0;
  bool cut_ = false;  ///< Before the end of the data.
  std::optional<std::uint64_t> stated_messages_;
};

Result<McapContent> Parser::parse() {
  if (!bytes_.starts_with(mcap::kMagic)) {
    return fail_at({name_}, ErrorCode::Syntax,
                   {"is no MCAP file: it must begin with 89 4d 43 41 50 30 0d 0a",
                    "no es un archivo MCAP: debe empezar con 89 4d 43 41 50 30 0d 0a"});
  }
  auto outcome = header();
  if (outcome) outcome = data_section();
  content_.without_gaps = content_.damages.empty() && (outcome || cut_);
  if (outcome) outcome = summary_section();
  if (!outcome) {
    if (recover_ == Recover::No || overflowed()) return tl::unexpected(outcome.error());
    note_damage(outcome.error());
  }
  content_.schemas = std::move(defined_.schemas);
  content_.channels = std::move(defined_.channels);
  return std::move(content_);
}

Result<void> Parser::header() {
  const auto record = mcap::record_at(bytes_, offset_);
  if (!record || record->opcode != Opcode::Header)
    return corrupt(offset_, {"the header record is missing or cut", "falta el registro de cabecera, o está cortado"});
  FieldReader fields(record->content);
  fields.string();  // profile
  content_.library = fields.string();
  if (!fields.ok()) return corrupt(offset_, {"the header record is damaged", "el registro de cabecera está dañado"});
  offset_ += record->size();
  return {};
}

Result<void> Parser::data_section() {
  while (true) {
    const auto record = mcap::record_at(bytes_, offset_);
    if (!record) {
      cut_ = true;
      return corrupt(offset_, {"the file was cut here; it has no end", "el archivo se cortó aquí; no tiene final"});
    }
    record_offset_ = offset_;
    if (auto outcome = data_record(*record); !outcome) {
      if (recover_ == Recover::No || record->opcode == Opcode::DataEnd || overflowed()) return outcome;
      note_damage(outcome.error());
    }
    offset_ += record->size();
    if (record->opcode == Opcode::DataEnd) return {};
  }
}

Result<void> Parser::data_record(const RecordView& record) {
  switch (record.opcode) {
    case Opcode::Schema:
      return schema(record.content, defined_);
    case Opcode::Channel:
      return channel(record.content, defined_);
    case Opcode::Chunk:
      return chunk(record.content);
    case Opcode::Attachment:
      return attachment(record.content);
    case Opcode::Metadata:
      return metadata(record.content);
    case Opcode::DataEnd:
      return data_end(record);
    case Opcode::Message: {
      const auto one = mcap::decode_message(record.content);
      if (!one || find_channel(one->channel, nullptr) == nullptr) {
        return corrupt(record_offset_, {"a message is damaged, or its channel is not known",
                                        "un mensaje está dañado, o no se conoce su canal"});
      }
      deliver(*one);
      return {};
    }
    case Opcode::Header:
    case Opcode::Footer:
      return corrupt(record_offset_, {"a header or footer inside the data", "una cabecera o un pie entre los datos"});
    default:
      return {};  // message indices, which reading everything does not need, and what later versions may add
  }
}

Result<void> Parser::schema(std::string_view content, Definitions& into) {
  if (auto outcome = count_definition(content); !outcome) return outcome;
  auto schema = mcap::decode_schema(content);
  if (!schema) return corrupt(record_offset_, {"a schema record is damaged", "un registro de esquema está dañado"});
  if (schema->first != 0) into.schemas.insert(std::move(*schema));
  return {};
}

Result<void> Parser::channel(std::string_view content, Definitions& into) {
  if (auto outcome = count_definition(content); !outcome) return outcome;
  auto channel = mcap::decode_channel(content);
  if (!channel) return corrupt(record_offset_, {"a channel record is damaged", "un registro de canal está dañado"});
  if (channel->schema != 0 && !into.schemas.contains(channel->schema) && !defined_.schemas.contains(channel->schema)) {
    return corrupt(record_offset_,
                   {"channel {} \"{}\" has schema {}, which is not known",
                    "el canal {} \"{}\" tiene el esquema {}, que no se conoce"},
                   channel->id, channel->topic, channel->schema);
  }
  const std::uint16_t id = channel->id;
  into.channels.try_emplace(id, std::move(*channel));
  return {};
}

const mcap::Channel* Parser::find_channel(std::uint16_t id, const Definitions* found) const {
  if (const auto known = defined_.channels.find(id); known != defined_.channels.end()) return &known->second;
  if (found == nullptr) return nullptr;
  const auto fresh = found->channels.find(id);
  return fresh != found->channels.end() ? &fresh->second : nullptr;
}

void Parser::deliver(const mcap::Message& message) {
  ++content_.messages;
  if (sink_) sink_(*find_channel(message.channel, nullptr), message);
}

void Parser::note_damage(const Error& error) {
  constexpr std::size_t kMost = 100;  // a file of nothing but damage must not fill the memory with words about it
  if (content_.damages.size() < kMost) content_.damages.push_back(error.what);
}

Result<void> Parser::count_definition(std::string_view content) {
  definition_bytes_ += content.size();
  if (definition_bytes_ <= mcap::kMaxDefinitionBytes) return {};
  return fail_at({name_}, ErrorCode::TooLarge,
                 {"byte {}: over {} bytes of schemas, channels and metadata",
                  "byte {}: más de {} bytes de esquemas, canales y metadatos"},
                 record_offset_, mcap::kMaxDefinitionBytes);
}

Result<void> Parser::chunk(std::string_view content) {
  if (!sink_) return {};
  const auto chunk = mcap::decode_chunk(content);
  if (!chunk) return corrupt(record_offset_, {"a chunk is damaged", "un bloque está dañado"});
  const auto records = unpack(*chunk);
  if (!records) return tl::unexpected(records.error());
  Definitions found;
  if (auto outcome = chunk_records(*records, found); !outcome) return outcome;
  defined_.schemas.merge(found.schemas);
  defined_.channels.merge(found.channels);
  ++content_.chunks;
  for (const mcap::Message& one : batch_) deliver(one);
  return {};
}

Result<std::string_view> Parser::unpack(const mcap::ChunkView& chunk) {
  const std::uint64_t size = chunk.unpacked_bytes;
  if (size <= mcap::kMaxChunkBytes) unpacked_total_ += size;
  if (size > mcap::kMaxChunkBytes || overflowed()) {
    return fail_at({name_}, ErrorCode::TooLarge,
                   {"byte {}: a chunk unpacks to {} bytes; the limits are {}, and {} for all",
                    "byte {}: un bloque ocupa {} bytes descomprimido; los límites son {}, y {} para todos"},
                   record_offset_, size, mcap::kMaxChunkBytes, max_unpacked_bytes_);
  }
  std::string_view records = chunk.packed;
  if (chunk.compression == "zstd") {
    if (!decompressor_.decompress(chunk.packed, size, unpacked_)) {
      return tl::unexpected(
          corrupt(record_offset_, {"a chunk cannot be unpacked", "un bloque no se puede descomprimir"}).error());
    }
    records = unpacked_;
  } else if (!chunk.compression.empty()) {
    return fail_at({name_}, ErrorCode::Unsupported,
                   {"byte {}: a chunk packed by \"{}\"; known: zstd, none",
                    "byte {}: un bloque comprimido con \"{}\"; se conocen: zstd, ninguno"},
                   record_offset_, chunk.compression);
  }
  if (records.size() != size || (chunk.crc != 0 && mcap::crc32(records) != chunk.crc)) {
    return tl::unexpected(
        corrupt(record_offset_, {"a chunk's content does not match its checksum or size",
                                 "el contenido de un bloque no coincide con su suma de control o su tamaño"})
            .error());
  }
  return records;
}

Result<void> Parser::chunk_records(std::string_view records, Definitions& found) {
  batch_.clear();
  for (std::size_t offset = 0; offset < records.size();) {
    const auto record = mcap::record_at(records, offset);
    if (!record)
      return corrupt(record_offset_, {"a record inside the chunk is longer than the chunk",
                                      "un registro dentro del bloque es más largo que el bloque"});
    Result<void> outcome;
    if (record->opcode == Opcode::Schema) outcome = schema(record->content, found);
    if (record->opcode == Opcode::Channel) outcome = channel(record->content, found);
    if (record->opcode == Opcode::Message) {
      const auto one = mcap::decode_message(record->content);
      if (!one || find_channel(one->channel, &found) == nullptr) {
        return corrupt(record_offset_, {"a message inside the chunk is damaged, or its channel is not known",
                                        "un mensaje dentro del bloque está dañado, o no se conoce su canal"});
      }
      batch_.push_back(*one);
    }
    if (!outcome) return outcome;
    offset += record->size();
  }
  return {};
}

Result<void> Parser::attachment(std::string_view content) {
  if (content_.attachments.size() >= mcap::kMaxAttachments) {
    return fail_at({name_}, ErrorCode::TooLarge, {"byte {}: over {} attachments", "byte {}: más de {} adjuntos"},
                   record_offset_, mcap::kMaxAttachments);
  }
  auto checked = mcap::decode_attachment(content);
  if (!checked) return corrupt(record_offset_, {"an attachment is damaged", "un adjunto está dañado"});
  if (!checked->crc_matches) {
    return corrupt(
        record_offset_,
        {"attachment \"{}\" does not match its checksum", "el adjunto \"{}\" no coincide con su suma de control"},
        checked->attachment.name);
  }
  content_.attachments.push_back(std::move(checked->attachment));
  return {};
}

Result<void> Parser::metadata(std::string_view content) {
  if (auto outcome = count_definition(content); !outcome) return outcome;
  auto metadata = mcap::decode_metadata(content);
  if (!metadata)
    return corrupt(record_offset_, {"a metadata record is damaged", "un registro de metadatos está dañado"});
  content_.metadata.push_back(std::move(*metadata));
  return {};
}

Result<void> Parser::data_end(const RecordView& record) {
  FieldReader fields(record.content);
  const std::uint32_t crc = fields.u32();
  if (!fields.ok()) return corrupt(offset_, {"the end of the data is damaged", "el final de los datos está dañado"});
  if (crc != 0 && mcap::crc32(bytes_.substr(0, record.offset)) != crc) {
    return corrupt(offset_, {"the data does not match its checksum", "los datos no coinciden con su suma de control"});
  }
  return {};
}

Result<void> Parser::summary_section() {
  summary_start_ = offset_;
  while (true) {
    const auto record = mcap::record_at(bytes_, offset_);
    if (!record) return corrupt(offset_, {"the file was cut in its summary", "el archivo se cortó en su resumen"});
    record_offset_ = offset_;
    if (record->opcode == Opcode::Footer) return footer(*record);
    if (auto outcome = summary_record(*record); !outcome) return outcome;
    offset_ += record->size();
  }
}

Result<void> Parser::summary_record(const RecordView& record) {
  switch (record.opcode) {
    case Opcode::Schema:
      return schema(record.content, defined_);
    case Opcode::Channel:
      return channel(record.content, defined_);
    case Opcode::Statistics: {
      FieldReader fields(record.content);
      stated_messages_ = fields.u64();
      return fields.ok() ? Result<void>()
                         : corrupt(record_offset_, {"the statistics are damaged", "las estadísticas están dañadas"});
    }
    case Opcode::Header:
    case Opcode::Message:
    case Opcode::Chunk:
    case Opcode::DataEnd:
      return corrupt(record_offset_,
                     {"a record that has no place in the summary", "un registro que no corresponde al resumen"});
    default:
      return {};
  }
}

Result<void> Parser::footer(const RecordView& record) {
  FieldReader fields(record.content);
  const std::uint64_t summary_start = fields.u64();
  fields.u64();  // start of the summary's offsets
  const std::size_t covered_end = record.offset + mcap::kRecordHeadBytes + 2 * sizeof(std::uint64_t);
  const std::uint32_t crc = fields.u32();
  if (!fields.ok() || record.content.size() != mcap::kFooterBytes ||
      (summary_start != 0 && summary_start != summary_start_)) {
    return corrupt(record_offset_, {"the footer is damaged", "el pie está dañado"});
  }
  if (crc != 0 && mcap::crc32(bytes_.substr(summary_start_, covered_end - summary_start_)) != crc) {
    return corrupt(summary_start_,
                   {"the summary does not match its checksum", "el resumen no coincide con su suma de control"});
  }
  if (bytes_.substr(record.offset + record.size()) != mcap::kMagic) {
    return corrupt(record.offset + record.size(),
                   {"the file must end with its magic bytes and nothing after them",
                    "el archivo debe terminar con sus bytes de identificación y nada después"});
  }
  if (!sink_) {
    content_.messages = stated_messages_.value_or(0);
  } else if (stated_messages_ && *stated_messages_ != content_.messages && content_.damages.empty()) {
    return corrupt(
        summary_start_,
        {"the summary counts {} messages, the data has {}", "el resumen cuenta {} mensajes, los datos tienen {}"},
        *stated_messages_, content_.messages);
  }
  return {};
}

}  // namespace

Result<McapContent> parse_mcap(std::string_view bytes, const std::string& name, Recover recover,
                               const MessageSink& sink, std::size_t max_unpacked_bytes) {
  return Parser(bytes, name, recover, sink, max_unpacked_bytes).parse();
}

Result<McapContent> read_mcap(const std::filesystem::path& path, Recover recover, const MessageSink& sink) {
  const auto bytes = read_file(path, mcap::kMaxMcapFileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return parse_mcap(*bytes, path.string(), recover, sink);
}

}  // namespace ganglion
