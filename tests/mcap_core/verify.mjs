// node verify.mjs FILE...
// Reads MCAP files with the format's reference library, by index and as a stream, every checksum included, and prints what they
// hold. Exit code 0 when all files are good, 1 when one is not, 2 when called wrongly.
import { readFile } from "node:fs/promises";
import { crc32 } from "@foxglove/crc";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { ZSTDDecoder } from "zstddec";

const zstd = new ZSTDDecoder();
await zstd.init();
const decompressHandlers = { zstd: (bytes, size) => zstd.decode(bytes, Number(size)) };

function demand(condition, words) {
  if (!condition) throw new Error(words);
}

// Depends on the content of every message, not on their order, which is by time for one reader and by file for the other.
function fingerprint(message) {
  return (crc32(message.data) + message.channelId * 65537 + message.sequence * 257 + Number(message.logTime % 65521n)) % 2 ** 32;
}

async function readByIndex(bytes) {
  const readable = {
    size: async () => BigInt(bytes.byteLength),
    read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  const counts = { messages: 0, attachments: 0, metadata: 0, chunks: reader.chunkIndexes.length, content: 0 };
  const perChannel = new Map();
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    demand(reader.channelsById.has(message.channelId), `no channel ${message.channelId} in the summary`);
    counts.messages += 1;
    counts.content = (counts.content + fingerprint(message)) % 2 ** 32;
    perChannel.set(message.channelId, (perChannel.get(message.channelId) ?? 0n) + 1n);
  }
  for await (const _ of reader.readAttachments({ validateCrcs: true })) counts.attachments += 1;
  for await (const _ of reader.readMetadata()) counts.metadata += 1;

  const statistics = reader.statistics;
  demand(statistics, "there is no statistics record");
  demand(statistics.messageCount === BigInt(counts.messages), "the statistics count other messages");
  demand(statistics.chunkCount === counts.chunks, "the statistics count other chunks");
  demand(statistics.attachmentCount === counts.attachments, "the statistics count other attachments");
  demand(statistics.metadataCount === counts.metadata, "the statistics count other metadata");
  demand(statistics.channelCount === reader.channelsById.size, "the statistics count other channels");
  demand(statistics.schemaCount === reader.schemasById.size, "the statistics count other schemas");
  for (const [channel, count] of statistics.channelMessageCounts) {
    demand((perChannel.get(channel) ?? 0n) === count, `the statistics count other messages of channel ${channel}`);
  }
  for (const [opcode, group] of reader.summaryOffsetsByOpcode) {
    demand(bytes[Number(group.groupStart)] === opcode, `summary offset ${opcode} points elsewhere`);
  }
  demand(reader.footer.summaryCrc !== 0, "the summary has no checksum");
  demand(reader.dataSectionCrc !== undefined, "the data section has no checksum");
  const dataCrc = crc32(bytes.subarray(0, Number(reader.dataEndOffset)));
  demand(dataCrc === reader.dataSectionCrc, "the data section does not match its checksum");
  return counts;
}

function readAsStream(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true, includeChunks: true });
  const counts = { messages: 0, attachments: 0, metadata: 0, chunks: 0, content: 0 };
  const kinds = { Message: "messages", Attachment: "attachments", Metadata: "metadata", Chunk: "chunks" };
  const piece = 65536;
  for (let offset = 0; offset < bytes.byteLength; offset += piece) {
    reader.append(bytes.subarray(offset, offset + piece));
    for (let record = reader.nextRecord(); record; record = reader.nextRecord()) {
      if (record.type === "Chunk") demand(record.uncompressedCrc !== 0, "a chunk has no checksum");
      if (record.type === "Message") counts.content = (counts.content + fingerprint(record)) % 2 ** 32;
      const kind = kinds[record.type];
      if (kind) counts[kind] += 1;
    }
  }
  demand(reader.done(), "the stream ends before the footer");
  return counts;
}

const files = process.argv.slice(2);
if (files.length === 0) {
  console.error("usage: node verify.mjs FILE...");
  process.exit(2);
}
let good = true;
for (const file of files) {
  try {
    const bytes = new Uint8Array(await readFile(file));
    const byIndex = JSON.stringify(await readByIndex(bytes));
    const asStream = JSON.stringify(readAsStream(bytes));
    demand(byIndex === asStream, `by index ${byIndex}, as a stream ${asStream}`);
    console.log(`${file}: ${byIndex}`);
  } catch (error) {
    console.error(`${file}: ${error.message}`);
    good = false;
  }
}
process.exit(good ? 0 : 1);
