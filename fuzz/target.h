#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace ganglion::fuzz {

/// Stops the fuzzer where something that must hold for every input does not.
inline void must(bool holds, const char* what, const std::string& detail = "") {
  if (holds) return;
  std::fprintf(stderr, "must hold: %s\n%s\n", what, detail.c_str());
  std::abort();
}

/// A folder of this process in memory, for readers that take files.
inline const std::filesystem::path& folder() {
  static const std::filesystem::path kFolder = [] {
    const std::filesystem::path made = "/dev/shm/ganglion_fuzz_" + std::to_string(::getpid());
    std::filesystem::create_directories(made);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    return made;
  }();
  return kFolder;
}

/// Written in place: quicker than write_file(), and nobody else reads it.
inline std::filesystem::path put(const char* name, std::string_view bytes) {
  const std::filesystem::path path = folder() / name;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  must(file != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size(),
       "the folder can be written");
  std::fclose(file);
  return path;
}

/// The first byte of an input chooses among `count` readers and is taken away; 0 for an empty input.
inline int choice(std::string_view& input, int count) {
  if (input.empty()) return 0;
  const int chosen = static_cast<unsigned char>(input.front()) % count;
  input.remove_prefix(1);
  return chosen;
}

}  // namespace ganglion::fuzz
