#include "ganglion/record/mcap/compression.h"

#include <zstd.h>

#include "ganglion/base/expects.h"

namespace ganglion::mcap {

Compressor::Compressor(int level) : context_(ZSTD_createCCtx()) {
  expects(context_ != nullptr);
  ZSTD_CCtx_setParameter(static_cast<ZSTD_CCtx*>(context_.get()), ZSTD_c_compressionLevel, level);
}

void Compressor::Free::operator()(void* context) const noexcept { ZSTD_freeCCtx(static_cast<ZSTD_CCtx*>(context)); }

bool Compressor::compress(std::string_view bytes, std::string& out) {
  out.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(static_cast<ZSTD_CCtx*>(context_.get()), out.data(), out.size(), bytes.data(), bytes.size());
  const bool good = ZSTD_isError(size) == 0;
  out.resize(good ? size : 0);
  return good;
}

Decompressor::Decompressor() : context_(ZSTD_createDCtx()) { expects(context_ != nullptr); }

void Decompressor::Free::operator()(void* context) const noexcept { ZSTD_freeDCtx(static_cast<ZSTD_DCtx*>(context)); }

bool Decompressor::decompress(std::string_view bytes, std::size_t size, std::string& out) {
  // A frame that states another size is damaged: seen before memory is taken. Frames of streaming writers state none.
  const unsigned long long stated = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (stated == ZSTD_CONTENTSIZE_ERROR || (stated != ZSTD_CONTENTSIZE_UNKNOWN && stated > size)) return false;
  out.resize(size);
  const std::size_t got =
      ZSTD_decompressDCtx(static_cast<ZSTD_DCtx*>(context_.get()), out.data(), out.size(), bytes.data(), bytes.size());
  return ZSTD_isError(got) == 0 && got == size;
}

}  // namespace ganglion::mcap
