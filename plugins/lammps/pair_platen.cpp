#include "pair_platen.h"

#include "dem/contact_block.hpp"
#include "host.hpp"
#include "lammps_input.hpp"

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace LAMMPS_NS;
namespace dem = platen::dem;
namespace law = platen::law;

// The loops over contacts for any processor, for those with AVX2 (of 2013 and later), and for those with
// AVX-512, chosen when the program starts.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 &&                     \
    defined(__GLIBC__) && !defined(PLATEN_PLAIN)
#define PLATEN_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PLATEN_CLONES
#endif

namespace {

std::string history_id(int instance, bool made) {
  return (made ? "NEIGH_HISTORY_PLATEN" : "NEIGH_HISTORY_PLATEN_DUMMY") + std::to_string(instance);
}

} // namespace

PairPlaten::PairPlaten(LAMMPS* host) : Pair(host) {
  single_enable = 1;
  no_virial_fdotr_compute = 1;
  centroidstressflag = CENTROID_NOTAVAIL;
  finitecutflag = 1;
  restartinfo = 0; // cards are read anew; what contacts remember is in the restart file, with NEIGH_HISTORY
  nondefault_history_transfer = 1; // seen from the other sphere only the tangential force changes its sign
  single_extra = 8;
  svector = new double[8];
  modify->add_fix(history_id(instance_me, false) +
                  " all DUMMY"); // holds the place of NEIGH_HISTORY in the order
}

PairPlaten::~PairPlaten() {
  if (copymode) return;
  warn_beyond(true);
  delete[] svector;
  modify->delete_fix(history_id(instance_me, history_made_));
  if (allocated) {
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }
}

void PairPlaten::allocate() {
  allocated = 1;
  const int n = atom->ntypes + 1;
  memory->create(setflag, n, n, "pair:setflag");
  memory->create(cutsq, n, n, "pair:cutsq");
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) setflag[i][j] = 0;
  contact_of_types_.assign(of_types(n, 0), -1);
}

std::size_t PairPlaten::of_types(int i, int j) const {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(atom->ntypes + 1) +
         static_cast<std::size_t>(j);
}

void PairPlaten::settings(int narg, char**) {
  if (narg != 0)
    error->all(FLERR, std::string("Illegal pair_style command: pair_style platen takes no arguments"));
}

void PairPlaten::coeff(int narg, char** arg) {
  const std::string usage =
      "Illegal pair_coeff command: pair_coeff I J CARD_I [CARD_J] [damping E] [friction MU]";
  if (narg < 3) error->all(FLERR, usage);
  if (!allocated) allocate();
  int ilo, ihi, jlo, jhi;
  utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
  utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
  dem::Contact contact;
  const auto card = [&](const char* file) {
    if (!cards_.contains(file))
      platen_try(error, FLERR, "pair_coeff platen", [&] { cards_[file] = platen::fit::read_law_card(file); });
    return cards_.at(file);
  };
  contact.one = contact.two = card(arg[2]);
  int next = 3;
  const auto keyword = [](const std::string& word) { return word == "damping" || word == "friction"; };
  if (next < narg && !keyword(arg[next])) {
    contact.two = card(arg[next]);
    ++next;
  }
  for (; next < narg; next += 2) {
    if (!keyword(arg[next]) || next + 1 >= narg) error->all(FLERR, usage);
    const double value = platen_number(error, FLERR, "pair_coeff platen", arg[next + 1], lmp);
    (arg[next] == std::string("damping") ? contact.restitution : contact.friction) = value;
  }
  platen_try(error, FLERR, "pair_coeff platen", [&] { dem::check(contact); });
  int count = 0;
  for (int i = ilo; i <= ihi; i++)
    for (int j = std::max(jlo, i); j <= jhi; j++) {
      contact_of_types_[of_types(i, j)] = static_cast<int>(contacts_.size());
      setflag[i][j] = 1;
      count++;
    }
  if (count == 0)
    error->all(FLERR, std::string("Incorrect args for pair coefficients: I must not be above J"));
  contacts_.push_back(std::move(contact));
}

void PairPlaten::init_style() {
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR,
               std::string("Pair platen requires atom attributes radius, rmass: use atom_style sphere"));
  if (force->newton_pair)
    error->all(FLERR,
               std::string("Pair platen requires newton pair off: put 'newton off' before the box is made"));
  units_ = platen_units(error, update, "Pair platen");
  any_friction_ = any_damping_ = false;
  for (const auto& contact : contacts_) {
    any_friction_ = any_friction_ || contact.friction > 0;
    any_damping_ = any_damping_ || contact.restitution < 1;
  }
  if ((any_friction_ || any_damping_) && comm->ghost_velocity == 0)
    error->all(FLERR,
               std::string("Pair platen with damping or friction requires ghost atoms store velocity: use "
                           "comm_modify vel yes"));

  request_history(neighbor, this, instance_me);
  if (!history_made_) {
    modify->replace_fix(
        history_id(instance_me, false),
        history_id(instance_me, true) + " all NEIGH_HISTORY " + std::to_string(dem::memory_size), 1);
    history_made_ = true;
  }
  history_ = static_cast<FixNeighHistory*>(modify->fix[modify->find_fix(history_id(instance_me, true))]);
  history_->pair = this;

  freeze_ = 0;
  std::vector<double> mine(static_cast<std::size_t>(atom->ntypes) + 1, 0);
  for (int k = 0; k < modify->nfix; k++) {
    Fix* const fix = modify->fix[k];
    if (utils::strmatch(fix->style, "^freeze")) freeze_ = fix->groupbit;
    if (!utils::strmatch(fix->style, "^pour") && !utils::strmatch(fix->style, "^deposit")) continue;
    for (int type = 1; type <= atom->ntypes; type++) { // of particles still to come
      int asked = type;
      double& largest = mine[static_cast<std::size_t>(type)];
      largest = std::max(largest, *static_cast<double*>(fix->extract("radius", asked)));
    }
  }
  for (int i = 0; i < atom->nlocal; i++) {
    double& largest = mine[static_cast<std::size_t>(atom->type[i])];
    largest = std::max(largest, atom->radius[i]);
  }
  largest_radius_ = mine;
  MPI_Allreduce(mine.data(), largest_radius_.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX,
                world);

  beyond_.resize(contacts_.size());
  warned_.resize(contacts_.size());
  laws_.clear();
  platen_try(error, FLERR, "Pair platen", [&] {
    for (std::size_t c = 0; c < contacts_.size(); c++)
      laws_.push_back(std::make_unique<dem::Laws>(contacts_[c], static_cast<int>(c), units_));
  });
  const int n = atom->ntypes + 1;
  laws_of_types_.assign(of_types(n, 0), nullptr);
  for (int i = 1; i < n; i++)
    for (int j = i; j < n; j++)
      if (const int c = contact_of_types_[of_types(i, j)]; c >= 0)
        laws_of_types_[of_types(i, j)] = laws_of_types_[of_types(j, i)] =
            laws_[static_cast<std::size_t>(c)].get();
}

double PairPlaten::init_one(int i, int j) {
  if (setflag[i][j] == 0)
    error->all(FLERR, std::string("All pair coeffs are not set: pair platen does not mix types"));
  return largest_radius_[static_cast<std::size_t>(i)] + largest_radius_[static_cast<std::size_t>(j)];
}

#ifdef PLATEN_LAMMPS_LOADS_PLUGINS
void PairPlaten::transfer_history(double* from, double* to, int, int) {
#else
double PairPlaten::atom2cut(int i) { return 2 * atom->radius[i]; }
double PairPlaten::radii2cut(double r1, double r2) { return r1 + r2; }

void PairPlaten::transfer_history(double* from, double* to) {
#endif
  const dem::Memory& m = *reinterpret_cast<const dem::Memory*>(from);
  *reinterpret_cast<dem::Memory*>(to) = {m.gamma_max, -1 * m.tangential, m.k_t};
}

/// A contact whose other sphere is a ghost is met twice, here and where that sphere is owned (or its image).
void PairPlaten::beyond(int contact, int j) {
  beyond_[static_cast<std::size_t>(contact)] += j < atom->nlocal ? 2 : 1;
}

/// Once for each pair_coeff when contacts first leave the validity of its card, and their number at the end.
void PairPlaten::warn_beyond(bool last) {
  for (std::size_t c = 0; c < beyond_.size(); c++) {
    if (warned_[c] && !last) continue;
    long all = 0;
    MPI_Allreduce(&beyond_[c], &all, 1, MPI_LONG, MPI_SUM, world);
    if (all == 0) continue;
    warned_[c] = true;
    if (comm->me != 0) continue;
    const std::string card = contacts_[c].one->file;
    if (last)
      error->warning(FLERR, std::to_string((all + 1) / 2) + " contacts went beyond the validity of " + card);
    else
      error->warning(FLERR, "Contacts are beyond the validity of " + card +
                                "; the law goes on monotonically, their number follows at the end");
  }
}

void PairPlaten::compute(int eflag, int vflag) {
  ev_init(eflag, vflag);
  platen_try(
      error, FLERR, "Pair platen",
      [&] {
        contacts();
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
      },
      true);
  if (neighbor->ago == 0) warn_beyond(false); // on all ranks alike
}

/// Touching pairs in blocks, and whose they are.
struct PairPlaten::Block : dem::Block {
  int i[size], j[size];
};

PLATEN_CLONES void PairPlaten::contacts() {
  if (list->inum == 0) return;
  Block block;
  const double *x = atom->x[0], *v = atom->v[0], *omega = atom->omega[0]; // three numbers each, side by side
  const double *radius = atom->radius, *rmass = atom->rmass;
  const int *type = atom->type, *mask = atom->mask, types = atom->ntypes + 1;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], count = list->numneigh[i], *neighbours = list->firstneigh[i];
    const dem::Vec at_i = dem::vec(x + 3 * i), v_i = dem::vec(v + 3 * i),
                   spin_i = radius[i] * dem::vec(omega + 3 * i);
    const double radius_i = radius[i];
    int* const touch = history_->firstflag[i];
    auto* const remembered = reinterpret_cast<dem::Memory*>(history_->firstvalue[i]);
    dem::Laws* const* const row = laws_of_types_.data() + static_cast<std::ptrdiff_t>(type[i]) * types;
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const dem::Vec apart = at_i - dem::vec(x + 3 * j);
      const double distance2 = dot(apart, apart), reach = radius_i + radius[j];
      if (distance2 >= reach * reach) {
        if (touch[jj]) touch[jj] = 0, remembered[jj] = {};
        continue;
      }
      touch[jj] = 1;
      const int c = block.count++;
      block.i[c] = i, block.j[c] = j;
      block.memory[c] = &remembered[jj];
      __builtin_prefetch(block.memory[c]);
      block.laws[c] = row[type[j]];
      block.distance2[c] = distance2, block.apart.set(c, apart);
      const bool swapped = type[i] > type[j]; // the radius of the sphere of the first type comes first
      block.R1[c] = radius[swapped ? j : i], block.R2[c] = radius[swapped ? i : j];
      block.velocity.set(c, v_i - dem::vec(v + 3 * j));
      block.spin.set(c, spin_i + radius[j] * dem::vec(omega + 3 * j));
      if (any_damping_) block.mass[c] = mass_of_both(rmass, mask, i, j);
      if (block.count == Block::size) follow(block);
    }
  }
  follow(block);
}

double PairPlaten::mass_of_both(const double* mass, const int* mask, int i, int j) const {
  if (mask[j] & freeze_) return mass[i];
  return mask[i] & freeze_ ? mass[j] : mass[i] * mass[j] / (mass[i] + mass[j]);
}

template <bool friction, bool damping> PLATEN_HOT void PairPlaten::forces(Block& block) {
  constexpr law::Want want = friction || damping ? law::Want::contact : law::Want::force;
  try {
    dem::normal_forces<want>(block, units_, [&](int c) { beyond(block.laws[c]->index, block.j[c]); });
  } catch (...) { // none leaves a function that was cloned: GCC 12 ends the program there
    failure_ = std::current_exception();
    return;
  }
  // setup moves nothing, and a restart gives the same bits
  dem::step<friction, damping>(block, units_, update->setupflag ? 0.0 : update->dt);
  double *f = atom->f[0], *torque = atom->torque[0];
  const double* radius = atom->radius;
  const int nlocal = atom->nlocal;
  for (int c = 0; c < block.count; c++) {
    const int i = block.i[c], j = block.j[c];
    const dem::Vec push = block.push[c];
    dem::add(f + 3 * i, push);
    if (j < nlocal) dem::add(f + 3 * j, -1 * push);
    if constexpr (friction) {
      const dem::Vec turn = block.turn[c];
      dem::add(torque + 3 * i, -radius[i] * turn);
      if (j < nlocal) dem::add(torque + 3 * j, -radius[j] * turn);
    }
    if (evflag) {
      const dem::Vec d = block.apart[c];
      ev_tally_xyz(i, j, nlocal, 0, 0.0, 0.0, push.x, push.y, push.z, d.x, d.y, d.z);
    }
  }
}

PLATEN_CLONES void PairPlaten::follow(Block& block) {
  if (any_friction_) any_damping_ ? forces<true, true>(block) : forces<true, false>(block);
  else any_damping_ ? forces<false, true>(block) : forces<false, false>(block);
  block.count = 0;
}

/// Reads what the contact remembers and changes nothing. svector: overlap, normal force of the law, contact
/// radius, mean pressure, work that unloading would not return, tangential force (3), all in units of the
/// run.
double PairPlaten::single(int i, int j, int, int, double rsq, double, double, double& fforce) {
  fforce = 0;
  std::fill(svector, svector + single_extra, 0.0);
  const double reach = atom->radius[i] + atom->radius[j];
  dem::Laws* const laws =
      laws_of_types_.empty() ? nullptr : laws_of_types_[of_types(atom->type[i], atom->type[j])];
  if (rsq >= reach * reach || !laws) return 0;
  dem::Memory m{};
  double sign = 1;
  const auto find = [&](int of, int other) {
    if (of >= atom->nlocal) return false;
    for (int jj = 0; jj < list->numneigh[of]; jj++)
      if ((list->firstneigh[of][jj] & NEIGHMASK) == other) {
        m = reinterpret_cast<const dem::Memory*>(history_->firstvalue[of])[jj];
        return true;
      }
    return false;
  };
  if (!find(i, j) && find(j, i)) sign = -1;
  const double r = std::sqrt(rsq);
  const int first = atom->type[i] > atom->type[j] ? j : i;
  const law::Response now = dem::respond(laws->at(atom->radius[first], atom->radius[first == i ? j : i]),
                                         m.gamma_max, (reach - r) * units_.length);
  const double F = now.force / units_.force;
  svector[0] = reach - r;
  svector[1] = F;
  svector[2] = now.contact_radius / units_.length;
  svector[3] = now.mean_pressure * units_.length * units_.length / units_.force;
  svector[4] = now.dissipated_work / (units_.force * units_.length);
  const dem::Vec s = sign * m.tangential;
  svector[5] = s.x, svector[6] = s.y, svector[7] = s.z;
  fforce = F / r;
  return 0;
}

double PairPlaten::memory_usage() {
  double sum = 0;
  for (const auto& laws : laws_) sum += static_cast<double>(laws->bytes());
  return sum;
}
