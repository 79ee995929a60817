#pragma once
// fix wall/platen: rigid planes and cylinders, with the laws of Platen.

#include "dem/contact_step.hpp"
#include "fix.h"

#include <memory>
#include <string>

namespace LAMMPS_NS {

class FixWallPlaten : public Fix {
 public:
  FixWallPlaten(LAMMPS*, int, char**);
  ~FixWallPlaten() override;
  FixWallPlaten(const FixWallPlaten&) = delete;
  FixWallPlaten& operator=(const FixWallPlaten&) = delete;

  int setmask() override;
  void init() override;
  void setup(int) override;
  void initial_integrate(int) override;
  void post_force(int) override;
  void end_of_step() override;
  double compute_vector(int) override;

  double memory_usage() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double*) override;
  int unpack_exchange(int, double*) override;
  int pack_restart(int, double*) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;
  void write_restart(FILE*) override;
  void restart(char*) override;

 private:
  enum class Drive { fixed, velocity, force };
  double driven(const std::string& text) const;
  void contacts();

  platen::dem::Contact contact_;
  std::unique_ptr<platen::dem::Laws> laws_;
  platen::dem::Units units_;
  int axis_ = 2;       // normal of the plane, axis of the cylinder
  int inward_ = 1;     // particles lie on this side of the plane
  bool cylinder_ = false;
  Drive drive_ = Drive::fixed;
  std::string drive_value_; // a number, or v_NAME
  double position_ = 0, velocity_ = 0, mass_ = 0; // of the plane; position_ is the radius of a cylinder
  double force_[4] = {}, total_[4] = {}; // here, everywhere: force of the particles on the wall, and the number of
                                         // contacts that left the validity of the card
  double** memory_ = nullptr; // [atom][platen::dem::memory_size]
};

} // namespace LAMMPS_NS
