#include "pair_platen.h"

#include "dem/contact_step.hpp"
#include "host.hpp"
#include "lammps_input.hpp"

#include "platen/law/batch.hpp"

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

// The loops over contacts twice, for any processor and for those with fused multiply-add (of 2013 and later),
// chosen when the program starts: a fifth faster there.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 &&                     \
    defined(__GLIBC__) && !defined(PLATEN_PLAIN)
#define PLATEN_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
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
  const double* s = m.tangential;
  *reinterpret_cast<dem::Memory*>(to) = {m.gamma_max, {-s[0], -s[1], -s[2]}, m.k_t};
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

/// Touching pairs in blocks, which take three turns: who touches, the law, what follows of its force. Each
/// turn is short enough for the processor to work on several contacts at once.
struct PairPlaten::Block {
  static constexpr int size = law::Batch::size;
  int count = 0;
  int i[size], j[size];
  dem::Memory* memory[size];
  dem::Laws* laws[size];
  double r[size], reach[size], d[size][3]; // distance, sum of radii, x_i - x_j
  law::Batch law;
};

PLATEN_CLONES void PairPlaten::contacts() {
  Block block;
  double* const* x = atom->x;
  const double* radius = atom->radius;
  const int *type = atom->type, types = atom->ntypes + 1;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], count = list->numneigh[i], *neighbours = list->firstneigh[i];
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], radius_i = radius[i];
    int* const touch = history_->firstflag[i];
    auto* const remembered = reinterpret_cast<dem::Memory*>(history_->firstvalue[i]);
    dem::Laws* const* const row = laws_of_types_.data() + static_cast<std::ptrdiff_t>(type[i]) * types;
    for (int jj = 0; jj < count; jj++) {
      const int j = neighbours[jj] & NEIGHMASK;
      const double dx = xi - x[j][0], dy = yi - x[j][1], dz = zi - x[j][2];
      const double rsq = dx * dx + dy * dy + dz * dz, reach = radius_i + radius[j];
      if (rsq >= reach * reach) {
        if (touch[jj]) touch[jj] = 0, remembered[jj] = {};
        continue;
      }
      touch[jj] = 1;
      const int c = block.count++;
      block.i[c] = i, block.j[c] = j;
      block.memory[c] = &remembered[jj];
      block.laws[c] = row[type[j]];
      block.r[c] = std::sqrt(rsq), block.reach[c] = reach;
      block.d[c][0] = dx, block.d[c][1] = dy, block.d[c][2] = dz;
      if (block.count == Block::size) follow(block);
    }
  }
  follow(block);
}

/// The radius of the sphere of the first type comes first.
PLATEN_HOT dem::Laws::At PairPlaten::at(dem::Laws& laws, int i, int j) const {
  const bool swapped = atom->type[i] > atom->type[j];
  return laws.at(atom->radius[swapped ? j : i], atom->radius[swapped ? i : j]);
}

PLATEN_HOT void PairPlaten::laws_of(Block& block) {
  law::Batch& b = block.law;
  try {
    for (int c = 0; c < block.count; c++) {
      const dem::Laws::At here = at(*block.laws[c], block.i[c], block.j[c]);
      b.law(c, *here.table, here.scale);
      b.overlap[c] = (block.reach[c] - block.r[c]) * units_.length;
      b.gamma_max[c] = block.memory[c]->gamma_max;
    }
  } catch (...) { // none leaves a function that was cloned: GCC 12 ends the program there
    failure_ = std::current_exception();
    block.count = 0;
    return;
  }
  if (any_friction_ || any_damping_) law::evaluate<law::Want::contact>(b, block.count);
  else law::evaluate<law::Want::force>(b, block.count);
  for (int c = 0; c < block.count; c++) {
    double& gamma_max = block.memory[c]->gamma_max;
    const dem::Laws& laws = *block.laws[c];
    const auto valid = [&](double gamma) { return laws.valid(*b.table[c], gamma * b.x_per_gamma[c]); };
    if (gamma_max < b.gamma_max[c] && !valid(b.gamma_max[c]) && valid(gamma_max)) [[unlikely]]
      beyond(laws.index, block.j[c]);
    gamma_max = b.gamma_max[c];
  }
}

template <bool friction, bool damping> PLATEN_HOT void PairPlaten::forces(const Block& block) {
  double *const *v = atom->v, **f = atom->f, *const *omega = atom->omega, **torque = atom->torque;
  const double *radius = atom->radius, *rmass = atom->rmass;
  const int *mask = atom->mask, nlocal = atom->nlocal;
  const dem::Units u = units_;
  const double per_force = 1 / u.force;
  const double dt =
      update->setupflag ? 0.0 : update->dt; // setup moves nothing, and a restart gives the same bits
  for (int c = 0; c < block.count; c++) {
    const int i = block.i[c], j = block.j[c];
    const dem::Laws& laws = *block.laws[c];
    const double rinv = 1 / block.r[c];
    const double n[3] = {block.d[c][0] * rinv, block.d[c][1] * rinv, block.d[c][2] * rinv};
    double F = block.law.force[c] * per_force;
    double w[3], v_n = 0;
    if constexpr (friction || damping) {
      for (int k = 0; k < 3; k++) w[k] = v[i][k] - v[j][k];
      v_n = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    }
    if constexpr (damping) {
      double mass = rmass[i] * rmass[j] / (rmass[i] + rmass[j]);
      if (mask[i] & freeze_) mass = rmass[j];
      if (mask[j] & freeze_) mass = rmass[i];
      F = dem::damped(laws.damping, u, block.law.stiffness[c], F, mass, v_n);
    }
    double push[3] = {F * n[0], F * n[1], F * n[2]};
    if constexpr (friction) {
      // the contact divides the distance as the radii do: torques and forces keep the angular momentum
      const double flat = block.r[c] / block.reach[c], arm_i = radius[i] * flat, arm_j = radius[j] * flat;
      double wr[3];
      for (int k = 0; k < 3; k++) wr[k] = arm_i * omega[i][k] + arm_j * omega[j][k];
      w[0] -= v_n * n[0] + n[2] * wr[1] - n[1] * wr[2];
      w[1] -= v_n * n[1] + n[0] * wr[2] - n[2] * wr[0];
      w[2] -= v_n * n[2] + n[1] * wr[0] - n[0] * wr[1];
      if (dt > 0)
        dem::slide(laws.shear, laws.contact.friction, block.law.contact_radius[c], F, n, w, dt,
                   *block.memory[c]);
      const double* s = block.memory[c]->tangential;
      const double turn[3] = {n[1] * s[2] - n[2] * s[1], n[2] * s[0] - n[0] * s[2],
                              n[0] * s[1] - n[1] * s[0]};
      for (int k = 0; k < 3; k++) {
        push[k] += s[k];
        torque[i][k] -= arm_i * turn[k];
        if (j < nlocal) torque[j][k] -= arm_j * turn[k];
      }
    }
    for (int k = 0; k < 3; k++) {
      f[i][k] += push[k];
      if (j < nlocal) f[j][k] -= push[k];
    }
    if (evflag)
      ev_tally_xyz(i, j, nlocal, 0, 0.0, 0.0, push[0], push[1], push[2], block.d[c][0], block.d[c][1],
                   block.d[c][2]);
  }
}

PLATEN_CLONES void PairPlaten::follow(Block& block) {
  laws_of(block);
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
  const law::Response now = dem::respond(at(*laws, i, j), m.gamma_max, (reach - r) * units_.length);
  const double F = now.force / units_.force;
  svector[0] = reach - r;
  svector[1] = F;
  svector[2] = now.contact_radius / units_.length;
  svector[3] = now.mean_pressure * units_.length * units_.length / units_.force;
  svector[4] = now.dissipated_work / (units_.force * units_.length);
  for (int k = 0; k < 3; k++) svector[5 + k] = sign * m.tangential[k];
  fforce = F / r;
  return 0;
}

double PairPlaten::memory_usage() {
  double sum = 0;
  for (const auto& laws : laws_) sum += static_cast<double>(laws->bytes());
  return sum;
}
