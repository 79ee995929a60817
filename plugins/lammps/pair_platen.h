#pragma once
// pair_style platen: contact laws of Platen between spheres.

#include "dem/contacts.hpp"
#include "host.hpp"

#include <exception>
#include <map>
#include <string>

namespace LAMMPS_NS {

class PairPlaten : public Pair {
 public:
  explicit PairPlaten(LAMMPS*);
  ~PairPlaten() override;
  PairPlaten(const PairPlaten&) = delete;
  PairPlaten& operator=(const PairPlaten&) = delete;

  void compute(int eflag, int vflag) override;
  void settings(int, char**) override;
  void coeff(int, char**) override;
  void init_style() override;
  double init_one(int, int) override;
  double single(int, int, int, int, double, double, double, double& fforce) override;
  double memory_usage() override;
#ifdef PLATEN_LAMMPS_LOADS_PLUGINS
  void transfer_history(double* from, double* to, int, int) override;
#else
  double atom2cut(int i) override;
  double radii2cut(double, double) override;
  void transfer_history(double* from, double* to) override;
#endif

 private:
  void allocate();
  std::size_t of_types(int i, int j) const; ///< where two types' entry stands
  void contacts();
  void warn_beyond(bool last);
  void beyond(int contact, int j);
  struct Block;
  void follow(Block&);
  double mass_of_both(const double* mass, const int* mask, int i, int j) const;
  template <bool friction, bool damping> void forces(Block&);

  std::map<std::string, platen::dem::Card> cards_; // by file
  std::vector<platen::dem::Contact> contacts_;
  std::vector<int> contact_of_types_;
  std::vector<std::unique_ptr<platen::dem::Laws>> laws_; // of each pair_coeff
  std::exception_ptr failure_; ///< of a law that could not be made within the loop over contacts
  std::vector<platen::dem::Laws*> laws_of_types_;        // [type * (types + 1) + type]; null: none
  platen::dem::Units units_;
  std::vector<double> largest_radius_;
  std::vector<long> beyond_; // twice the contacts that left the validity of their card, by pair_coeff; on this rank
  std::vector<bool> warned_;
  bool history_made_ = false, any_friction_ = false, any_damping_ = false;
  int freeze_ = 0; // group bit
  class FixNeighHistory* history_ = nullptr;
};

} // namespace LAMMPS_NS
