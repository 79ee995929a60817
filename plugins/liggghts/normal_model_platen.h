// Contact laws of Platen as a normal model of LIGGGHTS: `pair_style gran model platen`, `fix wall/gran model platen`.
// GPL-2, because it is made with LIGGGHTS's headers.
//
// The laws are cards, named by variables of the input script; they have no radius:
//   variable law_1 string granule.toml        # of particles, and walls, of type 1; `law` is that of all other types
//   pair_style gran model platen tangential history restitution 0.5
//
// A sphere on a wall is a sphere on a rigid plane. A contact remembers its largest overlap until it parts. `restitution`
// adds viscous damping that gives it to an elastic contact; plastic loss comes on top. Tangential and rolling models
// get Mindlin's stiffness 8 G* a, a the contact radius of the law.
#ifdef NORMAL_MODEL
NORMAL_MODEL(PLATEN, platen, 60)
#else
#ifndef NORMAL_MODEL_PLATEN_H
#define NORMAL_MODEL_PLATEN_H

#include "core/error.hpp"
#include "dem/contacts.hpp"

#include "atom.h"
#include "contact_models.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "normal_model_base.h"
#include "update.h"
#include "variable.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace LIGGGHTS {
namespace ContactModels {

template <> class NormalModel<PLATEN> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* lmp, IContactHistorySetup* setup, ContactModelBase* base)
      : NormalModelBase(lmp, setup, base), wall_(base->is_wall()),
        history_(setup->add_history_value("platen_overlap_max", "0")) {}

  void registerSettings(Settings& settings) override {
    settings.registerDoubleSetting("restitution", restitution_, 1.0);
    settings.registerOnOff("tangential_damping", tangential_damping_, true);
  }
  void postSettings(IContactHistorySetup*, ContactModelBase*) override {}
  double stressStrainExponent() override { return 1.5; }
  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

  void connectToProperties(PropertyRegistry&) override {
    if (std::string(update->unit_style) != "si")
      error->all(FLERR, "model platen needs units si");
    tried([&] {
      types_ = atom->get_properties()->max_type() + 1;
      laws_.clear();
      laws_.resize(static_cast<std::size_t>(types_ * types_));
      for (int i = 1; i < types_; i++)
        for (int j = wall_ ? 1 : i; j < types_; j++) {
          platen::dem::Contact contact;
          contact.one = card(i);
          if (wall_) contact.on_plane = true;
          else contact.two = card(j);
          contact.restitution = restitution_;
          platen::dem::check(contact);
          laws_[index(i, j)] = std::make_unique<platen::dem::Laws>(contact, 0, platen::dem::Units{});
        }
    });
  }

  void surfacesIntersect(SurfacesIntersectData& s, ForceData& i_forces, ForceData& j_forces) override {
    if (s.contact_flags) *s.contact_flags |= CONTACT_NORMAL_MODEL;
    const bool swapped = !wall_ && s.itype > s.jtype;
    platen::dem::Laws& laws = *laws_[swapped ? index(s.jtype, s.itype) : index(s.itype, s.jtype)];
    double& remembered = s.contact_history[history_];
    platen::law::Response now;
    tried([&] {
      const auto at = laws.at(swapped ? s.radj : s.radi, wall_ ? 0 : swapped ? s.radi : s.radj);
      now = platen::dem::respond(at, remembered, s.deltan);
      if (!laws.valid(*at.table, now.state.gamma_max * at.scale.x_per_gamma)) beyond(laws.contact);
    }, true);
    if (s.computeflag && s.shearupdate) remembered = now.state.gamma_max;

    s.kn = s.deltan > 0 ? now.force / s.deltan : now.stiffness;
    s.kt = 8 * shear_modulus(laws) * now.contact_radius;
    s.gamman = laws.damping * std::sqrt(now.stiffness * s.meff);
    s.gammat = tangential_damping_ ? laws.damping * std::sqrt(s.kt * s.meff) : 0;
    s.Fn = now.force > 0 ? std::fmax(now.force - s.gamman * s.vn, 0) : 0; // never pulls
    const double area = s.is_wall ? s.area_ratio : 1;
    for (int k = 0; k < 3; k++) {
      i_forces.delta_F[k] += s.Fn * area * s.en[k];
      if (!s.is_wall) j_forces.delta_F[k] -= s.Fn * s.en[k];
    }
  }

  void surfacesClose(SurfacesCloseData& s, ForceData&, ForceData&) override {
    if (!s.contact_history) return;
    if (s.contact_flags) *s.contact_flags &= ~CONTACT_NORMAL_MODEL;
    s.contact_history[history_] = 0;
  }

 private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(i * types_ + j); }
  /// Of the pair, G*: what `Laws` keeps is 8 G*.
  static double shear_modulus(const platen::dem::Laws& laws) { return laws.shear / 8; }

  platen::fit::LawCard card(int type) {
    std::string names[] = {"law_" + std::to_string(type), "law"};
    for (std::string& name : names)
      if (char* file = input->variable->retrieve(name.data())) return platen::fit::read_law_card(file);
    throw platen::core::InvalidInput("no law for particles of type " + std::to_string(type) + "; say: variable " +
                                     names[0] + " string CARD");
  }

  /// What Platen refuses is an error of LIGGGHTS, on all ranks or on this `one`.
  template <class Act> void tried(const Act& act, bool one = false) {
    std::string why;
    try {
      return act();
    } catch (const std::exception& problem) { why = std::string("model platen: ") + problem.what(); }
    if (!one) error->all(FLERR, why.c_str());
    std::fprintf(stderr, "%s\n", why.c_str()); // what `one` says is lost where its output is no terminal
    error->one(FLERR, why.c_str());
  }

  /// Once.
  void beyond(const platen::dem::Contact& contact) {
    if (warned_) return;
    warned_ = true;
    error->warning(FLERR, ("contacts are beyond the validity of " + contact.one->file +
                           "; the law goes on monotonically").c_str());
  }

  bool warned_ = false, wall_ = false, tangential_damping_ = true;
  int history_ = 0, types_ = 0;
  double restitution_ = 1;
  std::vector<std::unique_ptr<platen::dem::Laws>> laws_;
};

} // namespace ContactModels
} // namespace LIGGGHTS

#endif
#endif
