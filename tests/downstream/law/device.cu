// Every law on a GPU: its table, which is what a contact loop runs, and where they are plain data its
// formulas.
#define PLATEN_FUNCTION __host__ __device__ inline
#ifdef __clang__
#undef __noinline__ // CUDA's headers make a macro of what libstdc++ writes as __attribute__((__noinline__))
#endif
#include "platen/law/catalogue.hpp"

#include <type_traits>

namespace law = platen::law;

/// One step of many contacts of one law and one pair of sizes.
__global__ void step(law::TableView table, law::Scale scale, const double* overlap, law::State* state,
                     double* force, int contacts) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= contacts) return;
  const law::Response now = law::evaluate(table, scale, state[i], overlap[i]);
  state[i] = now.state;
  force[i] = now.force + now.contact_radius + now.dissipated_work;
}

template <class Formulas>
__global__ void exact(Formulas formulas, const double* overlap, law::State* state, double* force,
                      int contacts) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i >= contacts) return;
  const law::Response now = law::evaluate(formulas, state[i], overlap[i]);
  state[i] = now.state;
  force[i] = now.force;
}

template <class Material> void launch(const law::Reader& one) {
  using Formulas = decltype(prepare_on_rigid_plane(Material::read(one), 1.0));
  if constexpr (std::is_trivially_copyable_v<Formulas>)
    exact<<<1, 32>>>(prepare_on_rigid_plane(Material::read(one), 1.0), nullptr, nullptr, nullptr, 0);
}

template <class... Material>
void launch_all(const law::Reader& one, std::type_identity<std::tuple<Material...>>) {
  (launch<Material>(one), ...);
}

void launch_all(const law::Reader& one, const law::Law& any) {
  step<<<1, 32>>>(*any.table, any.scale, nullptr, nullptr, nullptr, 0);
  launch_all(one, std::type_identity<law::LawTypes>{});
}
