// In programs of the debug preset an invalid operation, a division by zero or an overflow is a signal where
// it happens.
#include <cfenv>

namespace {
[[maybe_unused]] const int before = ::feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
} // namespace
