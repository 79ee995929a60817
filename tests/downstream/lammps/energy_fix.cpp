// fix ID GROUP platen/energy: energies of a run of pair_style platen on one rank, for energy.py. GROUP moves
// as prescribed.
//   f_ID[1]  work that GROUP put in [J]
//   f_ID[2]  work of the law on all contacts so far: F over gamma, as the contacts themselves state both
//   f_ID[3]  work of friction: tangential force over the sliding of the surfaces
//   f_ID[4]  contacts
//   f_ID[5]  memory of the process [pages]
// Each by the trapezoidal rule over steps.
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
    size_vector = 5;
    global_freq = 1;
    extvector = 1;
  }
  int setmask() override { return FixConst::END_OF_STEP; }
  void setup(int) override {
    if (update->ntimestep != step_) account(false);
    pushed_ = push(); // walls may go another way in the next run
  }
  void end_of_step() override { account(true); }
  double compute_vector(int i) override {
    if (i < 3) return work_[i];
    if (i == 3) return static_cast<double>(contacts_.size());
    long pages = 0, resident = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
      if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2) resident = 0;
      std::fclose(file);
    }
    return static_cast<double>(resident);
  }

 private:
  struct Contact {
    double overlap, force, power; ///< power of friction
    bigint step;
  };

  /// Power of what moves as prescribed.
  [[nodiscard]] double push() const {
    double power = 0;
    for (int i = 0; i < atom->nlocal; i++)
      if (atom->mask[i] & groupbit)
        for (int k = 0; k < 3; k++) power -= atom->f[i][k] * atom->v[i][k];
    return power;
  }

  void account(bool moved) {
    step_ = update->ntimestep;
    const double pushed = push();
    if (moved) work_[0] += (pushed_ + pushed) / 2 * update->dt;
    pushed_ = pushed;
    const NeighList* list = force->pair->list;
    for (int ii = 0; ii < list->inum; ii++) {
      const int i = list->ilist[ii];
      for (int jj = 0; jj < list->numneigh[i]; jj++) contact(i, list->firstneigh[i][jj] & NEIGHMASK, moved);
    }
    for (auto one = contacts_.begin(); one != contacts_.end();) {
      if (one->second.step == step_) {
        ++one;
        continue;
      }
      work_[1] -= one->second.force * one->second.overlap / 2; // parted in this step
      work_[2] += one->second.power / 2 * update->dt;
      one = contacts_.erase(one);
    }
  }

  void contact(int i, int j, bool moved) {
    const double *xi = atom->x[i], *xj = atom->x[j];
    double n[3], rsq = 0;
    for (int k = 0; k < 3; k++) n[k] = xi[k] - xj[k], rsq += n[k] * n[k];
    const double reach = atom->radius[i] + atom->radius[j];
    if (rsq >= reach * reach) return;
    const std::uint64_t a = static_cast<std::uint64_t>(atom->tag[i]),
                        b = static_cast<std::uint64_t>(atom->tag[j]);
    const std::uint64_t name = a < b ? a << 32 | b : b << 32 | a;
    if (const auto found = contacts_.find(name); found != contacts_.end() && found->second.step == step_)
      return; // seen across the periodic face already
    double F_over_r = 0;
    force->pair->single(i, j, atom->type[i], atom->type[j], rsq, 1, 1, F_over_r);
    const double* s = force->pair->svector; // overlap, force, ..., tangential force on i
    const double r = std::sqrt(rsq), flat = r / reach;
    double w[3], along = 0, power = 0;
    for (int k = 0; k < 3; k++) {
      n[k] /= r;
      w[k] = atom->v[i][k] - atom->v[j][k];
      along += w[k] * n[k];
    }
    double wr[3];
    for (int k = 0; k < 3; k++)
      wr[k] = flat * (atom->radius[i] * atom->omega[i][k] + atom->radius[j] * atom->omega[j][k]);
    const double turn[3] = {n[2] * wr[1] - n[1] * wr[2], n[0] * wr[2] - n[2] * wr[0],
                            n[1] * wr[0] - n[0] * wr[1]};
    for (int k = 0; k < 3; k++) power -= s[5 + k] * (w[k] - along * n[k] - turn[k]);
    auto [at, fresh] = contacts_.try_emplace(name, Contact{0, 0, 0, step_});
    Contact& c = at->second;
    if (moved) {
      work_[1] += (c.force + s[1]) / 2 * (s[0] - c.overlap);
      work_[2] += (c.power + power) / 2 * update->dt;
    }
    c = {s[0], s[1], power, step_};
  }

  std::unordered_map<std::uint64_t, Contact> contacts_;
  double work_[3] = {0, 0, 0}, pushed_ = 0;
  bigint step_ = -1;
};

} // namespace

extern "C" void platen_register(void* handle) {
  auto* lmp = static_cast<LAMMPS*>(handle);
  (*lmp->modify->fix_map)["platen/energy"] = [](LAMMPS* l, int n, char** a) -> Fix* {
    return new FixEnergy(l, n, a);
  };
}
