#pragma once
// What the fuzz targets share. A reader may refuse its input with one of our errors; anything else that it
// throws ends the program, and is found.

#include "core/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace platen::fuzz {

/// The input as a file with this extension, for readers that take a path; the same name for all inputs of a
/// process.
inline std::string file_of(const std::uint8_t* data, std::size_t size, const std::string& extension) {
  static const std::string stem = "/dev/shm/platen-fuzz-" + std::to_string(::getpid());
  const std::string name = stem + extension;
  std::FILE* file = std::fopen(name.c_str(), "wb");
  std::fwrite(data, 1, size, file);
  std::fclose(file);
  return name;
}

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

template <class Read> int allow_refusal(const Read& read) {
  try {
    read();
  } catch (const core::InvalidInput& refused) {
    if (std::string(refused.what()).empty()) __builtin_trap();
  } catch (const core::IoError&) {}
  return 0;
}

} // namespace platen::fuzz

#define PLATEN_FUZZ extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
