// fix ID GROUP platen/energy: energies of a run of pair_style platen on one rank, for energy.py. GROUP moves
// as prescribed.
//   f_ID[1]  work that GROUP put in [J]
//   f_ID[2]  work of the law on all contacts so far: F over gamma, as the contacts themselves state F
//   f_ID[3]  work of friction: tangential force over the sliding of the surfaces
//   f_ID[4]  kinetic energy of the others: v(-) v(+)/2 m and its like of rotation, half a step before and
//   after f_ID[5]  contacts f_ID[6]  memory of the process [pages]
// Work is the mean force of two steps over the way between them, which is that of the velocity half-way.
// Velocity Verlet changes that kinetic energy by just this work, whatever the step and however rough the
// force.
#include "atom.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair.h"
#include "update.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <unordered_map>

using namespace LAMMPS_NS;

namespace {

class FixEnergy : public Fix {
 public:
  FixEnergy(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
    vector_flag = 1;
    size_vector = 6;
    global_freq = 1;
    extvector = 1;
  }
  int setmask() override { return FixConst::END_OF_STEP; }
  void setup(int) override {
    if (update->ntimestep != step_) account(false);
  }
  void end_of_step() override { account(true); }
  double compute_vector(int i) override {
    if (i < 3) return work_[i];
    if (i == 3) return kinetic();
    if (i == 4) return static_cast<double>(contacts_.size());
    long pages = 0, resident = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
      std::fclose(file);
    }
    return static_cast<double>(resident);
  }

 private:
  struct Vector {
    double at[3] = {0, 0, 0};
    double operator[](int k) const { return at[k]; }
    double& operator[](int k) { return at[k]; }
  };
  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// Two spheres at one moment: apart r = |d|, n = d/r.
  struct Apart {
    double r;
    Vector n;
    explicit Apart(const Vector& d) : r(std::sqrt(dot(d, d))) {
      for (int k = 0; k < 3; k++) n[k] = d[k] / r;
    }
  };

  struct Contact {
    double force; ///< normal
    Vector tangential;
    bigint step;
  };

  [[nodiscard]] bool led(int i) const { return atom->mask[i] & groupbit; }
  [[nodiscard]] bool kicked(int i) const { return !led(i) && i < atom->nlocal; } ///< since; a ghost is not
  [[nodiscard]] double inertia(int i) const {
    return 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
  }

  /// Half a step ago.
  [[nodiscard]] Vector velocity(int i) const {
    Vector v;
    for (int k = 0; k < 3; k++)
      v[k] = atom->v[i][k] - (kicked(i) ? update->dt / 2 * atom->f[i][k] / atom->rmass[i] : 0);
    return v;
  }
  [[nodiscard]] Vector rotation(int i) const {
    Vector omega;
    for (int k = 0; k < 3; k++)
      omega[k] = atom->omega[i][k] - (kicked(i) ? update->dt / 2 * atom->torque[i][k] / inertia(i) : 0);
    return omega;
  }

  [[nodiscard]] double kinetic() const {
    double sum = 0;
    for (int i = 0; i < atom->nlocal; i++) {
      if (led(i)) continue;
      for (int k = 0; k < 3; k++) {
        const double kick = update->dt / 2 * atom->f[i][k] / atom->rmass[i],
                     turn = update->dt / 2 * atom->torque[i][k] / inertia(i);
        sum += atom->rmass[i] / 2 * (atom->v[i][k] * atom->v[i][k] - kick * kick) +
               inertia(i) / 2 * (atom->omega[i][k] * atom->omega[i][k] - turn * turn);
      }
    }
    return sum;
  }

  /// Of what moves as prescribed, with the velocity of this step.
  void push(bool moved) {
    for (int i = 0; i < atom->nlocal; i++) {
      if (!led(i)) continue;
      Vector& last = on_led_[atom->tag[i]];
      for (int k = 0; k < 3; k++) {
        if (moved) work_[0] -= update->dt / 2 * (last[k] + atom->f[i][k]) * atom->v[i][k];
        last[k] = atom->f[i][k];
      }
    }
  }

  void account(bool moved) {
    step_ = update->ntimestep;
    push(moved);
    const NeighList* list = force->pair->list;
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; jj++) contact(i, list->firstneigh[i][jj] & NEIGHMASK, moved);
    }
    std::erase_if(contacts_, [](const auto& one) { return one.second.force == 0; });
    for (const auto& one : contacts_)
      if (one.second.step != step_)
        error->all(FLERR, std::string("A contact parted farther than neighbours are listed"));
  }

  /// Velocity of the surfaces against each other, as the plug-in takes it.
  static Vector sliding(const Apart& at, double reach, const Vector& w, const Vector& wr) {
    const double flat = at.r / reach;
    Vector s = w;
    s[0] -= flat * (at.n[2] * wr[1] - at.n[1] * wr[2]);
    s[1] -= flat * (at.n[0] * wr[2] - at.n[2] * wr[0]);
    s[2] -= flat * (at.n[1] * wr[0] - at.n[0] * wr[1]);
    return s; // what of it is along n does no work
  }

  void contact(int i, int j, bool moved) {
    Vector d;
    for (int k = 0; k < 3; k++) d[k] = atom->x[i][k] - atom->x[j][k];
    const Apart now(d);
    const double reach = atom->radius[i] + atom->radius[j];
    const bool touching = now.r * now.r < reach * reach;
    const std::uint64_t a = static_cast<std::uint64_t>(atom->tag[i]),
                        b = static_cast<std::uint64_t>(atom->tag[j]);
    const std::uint64_t name = a < b ? a << 32 | b : b << 32 | a;
    const auto found = contacts_.find(name);
    if (found == contacts_.end() && !touching) return;
    Contact& c = found != contacts_.end() ? found->second : contacts_[name];
    if (c.step == step_ && found != contacts_.end()) return; // seen across the periodic face already
    Contact next{0, {}, step_};
    if (touching) {
      double F_over_r = 0;
      force->pair->single(i, j, atom->type[i], atom->type[j], now.r * now.r, 1, 1, F_over_r);
      const double* s = force->pair->svector; // overlap, force, ..., tangential force on i
      next.force = s[1];
      for (int k = 0; k < 3; k++) next.tangential[k] = (a < b ? 1 : -1) * s[5 + k];
    }
    if (moved) {
      const double dt = update->dt;
      const Vector vi = velocity(i), vj = velocity(j), oi = rotation(i), oj = rotation(j);
      Vector w, wr, before;
      for (int k = 0; k < 3; k++) {
        w[k] = vi[k] - vj[k];
        wr[k] = atom->radius[i] * oi[k] + atom->radius[j] * oj[k];
        before[k] = d[k] - dt * w[k];
      }
      const Apart then(before);
      work_[1] += (c.force + next.force) / 2 * (then.r - now.r);
      work_[2] -=
          (a < b ? 1 : -1) * dt / 2 *
          (dot(c.tangential, sliding(then, reach, w, wr)) + dot(next.tangential, sliding(now, reach, w, wr)));
    }
    c = next;
  }

  std::unordered_map<std::uint64_t, Contact> contacts_;
  std::unordered_map<tagint, Vector> on_led_; ///< force a step ago
  double work_[3] = {0, 0, 0};
  bigint step_ = -1;
};

} // namespace

extern "C" void platen_register(void* handle) {
  auto* lmp = static_cast<LAMMPS*>(handle);
  (*lmp->modify->fix_map)["platen/energy"] = [](LAMMPS* l, int n, char** a) -> Fix* {
    return new FixEnergy(l, n, a);
  };
}
