#include "fix_wall_platen.h"

#include "lammps_input.hpp"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "input.h"
#include "memory.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
namespace dem = platen::dem;
namespace law = platen::law;

namespace {
constexpr const char* who = "Fix wall/platen";
}

// fix ID group wall/platen CARD plane x|y|z lo|hi POSITION [velocity V | force F mass M] [damping E]
// [friction MU] fix ID group wall/platen CARD cylinder x|y|z RADIUS [damping E] [friction MU]
FixWallPlaten::FixWallPlaten(LAMMPS* host, int narg, char** arg) : Fix(host, narg, arg) {
  const std::string usage =
      "Illegal fix wall/platen command: CARD plane x|y|z lo|hi POSITION [velocity V | force F "
      "mass M], or CARD cylinder x|y|z RADIUS; then [damping E] [friction MU]";
  if (narg < 7) error->all(FLERR, usage);
  contact_.on_plane = true;
  platen_try(error, FLERR, who, [&] { contact_.one = platen::fit::read_law_card(arg[3]); });
  const std::string kind = arg[4], axis = arg[5];
  if ((kind != "plane" && kind != "cylinder") || (axis != "x" && axis != "y" && axis != "z"))
    error->all(FLERR, usage);
  cylinder_ = kind == "cylinder";
  axis_ = axis[0] - 'x';
  int next = 6;
  if (!cylinder_) {
    const std::string side = arg[next++];
    if (side != "lo" && side != "hi") error->all(FLERR, usage);
    inward_ = side == "lo" ? 1 : -1;
  }
  if (next >= narg) error->all(FLERR, usage);
  const auto number = [&](const char* text) { return platen_number(error, FLERR, who, text, lmp); };
  position_ = number(arg[next++]);
  if (cylinder_ && !(position_ > 0)) error->all(FLERR, std::string(who) + ": the radius must be positive");
  for (; next < narg; next += 2) {
    if (next + 1 >= narg) error->all(FLERR, usage);
    const std::string key = arg[next];
    const char* value = arg[next + 1];
    if (key == "damping") contact_.restitution = number(value);
    else if (key == "friction") contact_.friction = number(value);
    else if (key == "mass") mass_ = number(value);
    else if ((key == "velocity" || key == "force") && !cylinder_ && drive_ == Drive::fixed) {
      drive_ = key == "force" ? Drive::force : Drive::velocity;
      drive_value_ = value;
    } else error->all(FLERR, usage);
  }
  if ((drive_ == Drive::force) != (mass_ > 0))
    error->all(FLERR, std::string(who) + ": a wall under a force needs both force and a positive mass");
  platen_try(error, FLERR, who, [&] { dem::check(contact_); });
  if (!atom->radius_flag || !atom->rmass_flag)
    error->all(FLERR, std::string(who) + " requires atom attributes radius, rmass: use atom_style sphere");
  if (domain->periodicity[axis_] && !cylinder_)
    error->all(FLERR, std::string(who) + ": the box is periodic across the plane");

  vector_flag = 1;
  size_vector = 5;
  global_freq = 1;
  extvector = 0;
  restart_peratom = restart_global = create_attribute = 1;
  FixWallPlaten::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
}

FixWallPlaten::~FixWallPlaten() {
  if (total_[3] > 0 && comm->me == 0)
    error->warning(FLERR, std::to_string(std::lround(total_[3])) + " contacts with wall " + id +
                              " went beyond the validity of " + contact_.one->file);
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  memory->destroy(memory_);
}

int FixWallPlaten::setmask() {
  return FixConst::INITIAL_INTEGRATE | FixConst::POST_FORCE | FixConst::END_OF_STEP;
}

void FixWallPlaten::init() {
  units_ = platen_units(error, update, who);
  platen_try(error, FLERR, who, [&] { laws_ = std::make_unique<dem::Laws>(contact_, 0, units_); });
  if (drive_ != Drive::fixed) driven(drive_value_);
}

void FixWallPlaten::setup(int vflag) {
  post_force(vflag);
  end_of_step();
}

double FixWallPlaten::driven(const std::string& text) const {
  if (text.rfind("v_", 0) != 0) return platen_number(error, FLERR, who, text.c_str(), lmp);
  const int variable = input->variable->find(text.c_str() + 2);
  if (variable < 0 || !input->variable->equalstyle(variable))
    error->all(FLERR, std::string(who) + ": there is no equal-style variable " + text.substr(2));
  return input->variable->compute_equal(variable);
}

/// Leapfrog: a kick with the last force, then the drift; the velocity belongs to the middle of the step.
void FixWallPlaten::initial_integrate(int) {
  if (drive_ == Drive::fixed) return;
  modify->clearstep_compute(); // a variable may ask for computes
  const double value = driven(drive_value_);
  modify->addstep_compute(update->ntimestep + 1);
  if (drive_ == Drive::velocity) velocity_ = value;
  else velocity_ += update->dt * (value + total_[axis_]) / mass_;
  position_ += velocity_ * update->dt;
  if (!std::isfinite(position_))
    error->all(FLERR, std::string(who) +
                          ": the wall's position is not finite any more; are its velocity, force "
                          "and mass right?");
}

void FixWallPlaten::post_force(int) {
  std::fill(force_, force_ + 3, 0.0);
  platen_try(
      error, FLERR, who, [&] { contacts(); }, true);
}

void FixWallPlaten::contacts() {
  const double dt = update->setupflag ? 0.0 : update->dt;
  const int a1 = (axis_ + 1) % 3, a2 = (axis_ + 2) % 3;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double *x = atom->x[i], R = atom->radius[i];
    double n[3] = {}, v[3] = {atom->v[i][0], atom->v[i][1], atom->v[i][2]}, distance;
    if (cylinder_) {
      const double rho = std::hypot(x[a1], x[a2]);
      distance = position_ - rho;
      if (rho > 0) n[a1] = -x[a1] / rho, n[a2] = -x[a2] / rho;
    } else {
      n[axis_] = inward_;
      distance = inward_ * (x[axis_] - position_);
    }
    auto& m = *reinterpret_cast<dem::Memory*>(memory_[i]);
    if (distance >= R) {
      m = {};
      continue;
    }
    const dem::Laws::At here = laws_->at(R, R);
    const double before = m.gamma_max;
    const law::Response now = dem::respond(here, before, (R - distance) * units_.length);
    m.gamma_max = now.state.gamma_max;
    const double x_per_gamma = here.scale.x_per_gamma;
    if (before < m.gamma_max && !laws_->valid(*here.table, m.gamma_max * x_per_gamma) &&
        laws_->valid(*here.table, before * x_per_gamma))
      force_[3]++;
    const dem::Vec normal = dem::vec(n);
    v[axis_] -= cylinder_ ? 0 : velocity_;
    const double v_n = dot(dem::vec(v), normal);
    const double F =
        dem::damped(laws_->damping, units_, now.stiffness, now.force / units_.force, atom->rmass[i], v_n);
    dem::Vec push = F * normal;
    if (contact_.friction > 0) {
      const double k_t = laws_->shear * now.contact_radius, limit = F > 0 ? contact_.friction * F : 0;
      const dem::Vec v_t = dem::vec(v) - v_n * normal + distance * cross(normal, dem::vec(atom->omega[i]));
      if (dt > 0) {
        m.tangential = dem::slide(m.tangential, m.k_t, k_t, limit, normal, v_t, dt);
        m.k_t = k_t;
      }
      push = push + m.tangential;
      dem::add(atom->torque[i], -distance * cross(normal, m.tangential));
    }
    dem::add(atom->f[i], push);
    dem::add(force_, -1 * push);
  }
}

void FixWallPlaten::end_of_step() {
  const bool before = total_[3] > 0;
  MPI_Allreduce(force_, total_, 4, MPI_DOUBLE, MPI_SUM, world);
  if (total_[3] > 0 && !before && comm->me == 0)
    error->warning(FLERR, std::string("Contacts with wall ") + id + " are beyond the validity of " +
                              contact_.one->file +
                              "; the law goes on monotonically, their number follows at the end");
}

/// Force of the particles on the wall (3), position (of a cylinder its radius), velocity.
double FixWallPlaten::compute_vector(int n) { return n < 3 ? total_[n] : n == 3 ? position_ : velocity_; }

double FixWallPlaten::memory_usage() { return static_cast<double>(atom->nmax) * sizeof(dem::Memory); }
void FixWallPlaten::grow_arrays(int n) { memory->grow(memory_, n, dem::memory_size, "wall/platen:memory"); }
void FixWallPlaten::copy_arrays(int i, int j, int) {
  std::memcpy(memory_[j], memory_[i], sizeof(dem::Memory));
}
void FixWallPlaten::set_arrays(int i) { std::memset(memory_[i], 0, sizeof(dem::Memory)); }
int FixWallPlaten::pack_exchange(int i, double* to) {
  std::memcpy(to, memory_[i], sizeof(dem::Memory));
  return dem::memory_size;
}
int FixWallPlaten::unpack_exchange(int i, double* from) {
  std::memcpy(memory_[i], from, sizeof(dem::Memory));
  return dem::memory_size;
}
int FixWallPlaten::pack_restart(int i, double* to) {
  to[0] = maxsize_restart();
  std::memcpy(to + 1, memory_[i], sizeof(dem::Memory));
  return maxsize_restart();
}
void FixWallPlaten::unpack_restart(int i, int nth) {
  const double* extra = atom->extra[i];
  int m = 0;
  for (int k = 0; k < nth; k++) m += static_cast<int>(extra[m]);
  std::memcpy(memory_[i], extra + m + 1, sizeof(dem::Memory));
}
int FixWallPlaten::size_restart(int) { return maxsize_restart(); }
int FixWallPlaten::maxsize_restart() { return dem::memory_size + 1; }

void FixWallPlaten::write_restart(FILE* file) {
  if (comm->me != 0) return;
  const double state[] = {position_, velocity_};
  const int size = sizeof(state);
  std::fwrite(&size, sizeof(int), 1, file);
  std::fwrite(state, sizeof(state), 1, file);
}

/// Where the wall was; what drives it stands in the input.
void FixWallPlaten::restart(char* from) {
  double state[2];
  std::memcpy(state, from, sizeof(state));
  position_ = state[0], velocity_ = state[1];
}
