#pragma once
// What LAMMPS's public headers need of its own copy of fmt, which Debian's liblammps-dev leaves out. Nothing of it
// is called: messages are std::string.
#include <string>

namespace fmt {
inline namespace v7_lmp {
class string_view;
class format_args;
template <class... Args, class S> format_args make_args_checked(const S&, const Args&...);
} // namespace v7_lmp
} // namespace fmt
