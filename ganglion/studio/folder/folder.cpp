#include "ganglion/studio/folder/folder.h"

#include <algorithm>

#include "ganglion/base/beneath.h"
#include "ganglion/base/hash.h"
#include "ganglion/base/text.h"

namespace ganglion::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxText = std::size_t{4} << 20;
constexpr std::string_view kDraftHead = "# draft of ganglion studio, based on ";

bool below(const fs::path& path, const fs::path& root) {
  return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

/// Where a link below leads.
fs::path real_of(const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(file, error);
  return error ? file : real;
}

fs::path draft_of(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".draft"); }

Result<void> may_write(const fs::path& file, std::string_view text) {
  if (file.extension() != ".toml" && file.extension() != ".fll") {
    return fail_at({file.filename().string()}, ErrorCode::Unsupported,
                   {"only .toml and .fll files are written here", "aquí solo se escriben archivos .toml y .fll"});
  }
  if (text.size() > kMaxText) {
    return fail_at({file.filename().string()}, ErrorCode::TooLarge,
                   {"has {} bytes; the limit is {}", "tiene {} bytes; el límite es {}"}, text.size(), kMaxText);
  }
  return {};
}

}  // namespace

std::string text_hash(std::string_view text) {
  return fmt::format("{:016x}", combine(hash_bytes(std::as_bytes(std::span(text))), text.size()));
}

Result<Folder> Folder::open(const fs::path& root) {
  std::error_code error;
  const fs::path real = fs::canonical(root, error);
  if (error || !fs::is_directory(real, error)) {
    return fail_at({root.string()}, ErrorCode::NotFound, {"there is no such folder", "no existe esa carpeta"});
  }
  return Folder(real);
}

std::optional<fs::path> Folder::inner(const fs::path& path) const {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  if (error || !below(real, root_)) return std::nullopt;
  for (fs::path end = real; end != root_ && !fs::exists(end, error); end = end.parent_path()) {
    if (fs::is_symlink(end, error)) return std::nullopt;  // to what is not there yet: it may come to be anywhere
  }
  return real.lexically_relative(root_);
}

bool Folder::holds(const fs::path& path) const { return inner(path).has_value(); }

std::string Folder::name_of(const fs::path& path) const { return inner(path).value_or(fs::path()).generic_string(); }

Result<fs::path> Folder::resolve(std::string_view name) const {
  const auto refuse = [&] {
    return fail(ErrorCode::NotFound, {"\"{}\" is no file of this folder", "\"{}\" no es un archivo de esta carpeta"},
                printable(name, 200));
  };
  if (name.empty() || name.size() > 1000 || name.find('\0') != std::string_view::npos ||
      name.find('\\') != std::string_view::npos) {
    return refuse();
  }
  for (const std::string& part : split(name, '/')) {
    if (part.empty() || part.front() == '.') return refuse();  // "..", hidden files, "//", an absolute path
  }
  const fs::path path = root_ / fs::path(name);
  if (!holds(path)) return refuse();
  return path;
}

std::optional<fs::path> Folder::seat(const fs::path& path) const {
  const auto folder = inner(path.parent_path());
  return folder ? std::optional((*folder / path.filename()).lexically_normal()) : std::nullopt;
}

Result<std::string> Folder::text_of(const fs::path& path, std::size_t max_bytes) const {
  const auto place = seat(path);
  if (!place) return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  return read_beneath(root_, *place, max_bytes);
}

Result<std::string> Folder::bytes_of(const fs::path& path, std::size_t max_bytes) const {
  return text_of(real_of(path), max_bytes);
}

Result<void> Folder::put(const fs::path& path, std::string_view text) const {
  const auto place = seat(path);
  if (!place) return fail(ErrorCode::NotFound, {"there is no such file", "no existe el archivo"});
  return write_beneath(root_, *place, text);
}

void Folder::remove_draft(const fs::path& file) const {
  if (const auto place = seat(draft_of(file))) remove_beneath(root_, *place);
}

Result<StoredText> Folder::read(std::string_view name) const {
  const auto path = resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  auto text = text_of(real_of(*path), kMaxText);
  if (!text) return fail(text.error().code, {"\"{}\" {}", "\"{}\": {}"}, name, text.error().what);
  StoredText file{std::move(*text), "", std::nullopt};
  file.hash = text_hash(file.text);
  const auto draft = text_of(draft_of(*path), kMaxText + 200);
  if (draft && draft->starts_with(kDraftHead)) {
    const std::size_t end = std::min(draft->find('\n'), draft->size() - 1);
    file.draft = StoredText::Draft{draft->substr(end + 1), draft->substr(kDraftHead.size(), end - kDraftHead.size())};
  }
  return file;
}

Result<tl::expected<std::string, Conflict>> Folder::save(std::string_view name, std::string_view text,
                                                         const std::string& based_on) const {
  const auto path = resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  if (auto may = may_write(*path, text); !may) return tl::unexpected<Error>(may.error());
  Conflict now;
  auto present = text_of(real_of(*path), kMaxText);
  if (present) {
    now = {text_hash(*present), std::move(*present)};
  } else if (present.error().code != ErrorCode::NotFound) {
    return fail(present.error().code, {"\"{}\" {}", "\"{}\": {}"}, name, present.error().what);
  }
  using Saved = tl::expected<std::string, Conflict>;
  if (now.hash != based_on) return Saved(tl::unexpected<Conflict>(std::move(now)));
  if (auto written = put(real_of(*path), text); !written) return tl::unexpected<Error>(written.error());
  remove_draft(*path);
  return Saved(text_hash(text));
}

Result<void> Folder::autosave(std::string_view name, std::string_view text, const std::string& based_on) const {
  const auto path = resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  if (auto may = may_write(*path, text); !may) return may;
  const bool hash = based_on.size() <= 16 && std::all_of(based_on.begin(), based_on.end(), [](char c) {
                      return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
                    });
  if (!hash)
    return fail(ErrorCode::BadParameter, {"\"based_on\" must be the hash of the text that was opened",
                                          "\"based_on\" debe ser la huella del texto que se abrió"});
  std::error_code error;
  if (!fs::is_directory(path->parent_path(), error))
    return fail(ErrorCode::NotFound, {"there is no such folder", "no existe esa carpeta"});
  if (fs::is_symlink(draft_of(*path), error)) remove_draft(*path);  // nobody but this program has drafts
  return put(draft_of(*path), fmt::format("{}{}\n{}", kDraftHead, based_on, text));
}

Result<void> Folder::discard(std::string_view name) const {
  const auto path = resolve(name);
  if (!path) return tl::unexpected<Error>(path.error());
  remove_draft(*path);
  return {};
}

bool Folder::has_draft(const fs::path& file) const {
  std::error_code error;
  return fs::exists(draft_of(file), error);
}

}  // namespace ganglion::studio
