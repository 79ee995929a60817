// The browser knows encodings; the C library's tables of them are large. As much of iconv as measure/text.cpp
// asks.

#include <iconv.h>

#include <cstring>

extern "C" {

/// UTF-8 of bytes in an encoding; its size, or -1 where they are none.
__attribute__((import_module("page"), import_name("decode"))) int page_decode(const char* encoding,
                                                                              std::size_t, const char* bytes,
                                                                              std::size_t, char* out,
                                                                              std::size_t room);

iconv_t iconv_open(const char*, const char* from) { return const_cast<char*>(from); }
int iconv_close(iconv_t) { return 0; }
std::size_t iconv(iconv_t from, char** in, std::size_t* in_left, char** out, std::size_t* out_left) {
  const char* name = static_cast<const char*>(from);
  const int size = page_decode(name, std::strlen(name), *in, *in_left, *out, *out_left);
  if (size < 0) return static_cast<std::size_t>(-1);
  *in += *in_left;
  *in_left = 0;
  *out += size;
  *out_left -= static_cast<std::size_t>(size);
  return 0;
}
}
