// Loaded before LIGGGHTS begins (LD_PRELOAD), this adds `model platen` to its tables of contact models.
// GPL-2, as LIGGGHTS.
#include "comm.h"
#include "fix_insert_stream.h"
#include "neighbor.h"

#include "granular_pair_style.h"
#include "granular_wall.h"

#include "contact_models.h"
#include "fix_wall_gran_base.h"
#include "pair_gran_base.h"

namespace {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

template <class Interface, class Style>
Interface* make(LAMMPS_NS::LAMMPS* lmp, typename Interface::ParentType* parent, int64_t hash) {
  return new Style(lmp, parent, hash);
}

template <int tangential, int rolling> void add() {
  using Model = GranStyle<PLATEN, tangential, COHESION_OFF, rolling, SURFACE_DEFAULT>;
  using Both = ContactModel<Model>;
  const int hash = static_cast<int>(Model::HASHCODE);
  PairStyles::Factory::instance().addStyle("gran", hash,
                                           make<PairStyles::IGranularPairStyle, PairStyles::Granular<Both>>);
  Walls::Factory::instance().addStyle("gran", hash, make<Walls::IGranularWall, Walls::Granular<Both>>);
}

template <int tangential> void add_rolling() {
  add<tangential, ROLLING_OFF>();
  add<tangential, ROLLING_CDT>();
  add<tangential, ROLLING_EPSD>();
  add<tangential, ROLLING_EPSD2>();
  add<tangential, ROLLING_EPSD3>();
}

const bool added = [] {
  ContactModels::Factory::instance().addNormalModel("platen", PLATEN);
  add_rolling<TANGENTIAL_OFF>();
  add_rolling<TANGENTIAL_NO_HISTORY>();
  add_rolling<TANGENTIAL_HISTORY>();
  return true;
}();

} // namespace
