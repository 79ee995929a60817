// What std::to_chars asks for numbers from 2^53 on, and with a precision. libc++ has tables of 100 kB for it;
// printf of musl is exact as well. The functions are libc++'s own, so that its archive's are not needed.

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace std {
inline namespace __1 {
namespace {

to_chars_result written(const char* format, char* first, char* last, double value, uint32_t precision) {
  char digits[400];
  const int size = snprintf(digits, sizeof digits, format, static_cast<int>(precision), value);
  if (size < 0 || size > last - first) return {last, errc::value_too_large};
  memcpy(first, digits, static_cast<size_t>(size));
  return {first + size, errc{}};
}

} // namespace

__attribute__((visibility("default"))) to_chars_result __d2fixed_buffered_n(char* first, char* last,
                                                                            double value,
                                                                            uint32_t precision) {
  return written("%.*f", first, last, value, precision);
}
__attribute__((visibility("default"))) to_chars_result __d2exp_buffered_n(char* first, char* last,
                                                                          double value, uint32_t precision) {
  return written("%.*e", first, last, value, precision);
}

// Of float.
__attribute__((visibility("default"))) void __append_n_digits(uint32_t count, uint32_t digits, char* at) {
  for (; count-- > 0; digits /= 10) at[count] = static_cast<char>('0' + digits % 10);
}
__attribute__((visibility("default"))) void __append_nine_digits(uint32_t digits, char* at) {
  __append_n_digits(9, digits, at);
}

} // namespace __1
} // namespace std
