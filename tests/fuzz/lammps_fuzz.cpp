// A line of LAMMPS, "pair_coeff ..." or "fix w all wall/platen ...", in LAMMPS itself; a word that names a
// card of the corpus "law" is that card. It is refused by an error of LAMMPS, or a step can be made with it.
#include "fuzz.hpp"

#include "fix_wall_platen.h"
#include "pair_platen.h"

#include "atom.h"
#include "error.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"

#include <cmath>
#include <filesystem>
#include <memory>
#include <mpi.h>
#include <sstream>
#include <vector>

using namespace LAMMPS_NS;

namespace {

struct Refused {
  std::string why;
};

} // namespace

// LAMMPS's errors end the program; these come before its own where symbols are bound.
void Error::all(const std::string&, int, const std::string& why) { throw Refused{why}; }
void Error::one(const std::string&, int, const std::string& why) { throw Refused{why}; }

/// What libraries of MPI and Python leave behind is not ours.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) { return MPI_Init(argc, argv); }

namespace {

/// Two spheres that touch each other and the plane x = -1e-3.
std::unique_ptr<LAMMPS> two_spheres() {
  static std::vector<std::string> words = {"lmp", "-screen", "none", "-log", "none", "-nocite"};
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  auto lmp = std::make_unique<LAMMPS>(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_WORLD);
  (*lmp->force->pair_map)["platen"] = [](LAMMPS* l) -> Pair* { return new PairPlaten(l); };
  (*lmp->modify->fix_map)["wall/platen"] = [](LAMMPS* l, int n, char** a) -> Fix* {
    return new FixWallPlaten(l, n, a);
  };
  for (const char* line :
       {"units si", "atom_style sphere", "newton off", "comm_modify vel yes", "boundary f f f",
        "region box block -1e-2 1e-2 -1e-2 1e-2 -1e-2 1e-2", "create_box 2 box",
        "create_atoms 1 single 0 0 0", "create_atoms 2 single 1.99e-3 0 0", "set group all diameter 2.002e-3",
        "set group all density 1500", "timestep 1e-8", "thermo_modify norm no", "pair_style platen"})
    lmp->input->one(line);
  return lmp;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    const auto card = std::filesystem::path(PLATEN_FUZZ_CARDS) / word;
    const bool known =
        word.find('/') == word.npos && word.ends_with(".toml") && std::filesystem::exists(card);
    words.push_back(known ? card.string() : word);
  }
  return words;
}

void demand(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "accepted: %s\n", what);
  __builtin_trap();
}

/// The words after the command are its arguments.
void obey(LAMMPS* lmp, const std::string& line) {
  auto words = words_of(line);
  const bool wall = words.size() > 3 && words[0] == "fix" && words[3] == "wall/platen";
  if (!wall && (words.empty() || words[0] != "pair_coeff")) return;
  if (wall) words[1] = "w", words[2] = "all";
  std::vector<char*> arguments;
  for (std::size_t i = 1; i < words.size(); ++i) arguments.push_back(words[i].data());
  const int count = static_cast<int>(arguments.size());
  if (wall) lmp->modify->add_fix(count, arguments.data());
  else lmp->force->pair->coeff(count, arguments.data());
}

void make_a_step(LAMMPS* lmp) {
  lmp->input->one("run 1");
  const int w = lmp->modify->find_fix("w");
  if (w >= 0)
    for (int k = 0; k < 5; ++k) demand(std::isfinite(lmp->modify->fix[w]->compute_vector(k)), "wall");
  for (int i = 0; i < lmp->atom->nlocal; ++i)
    for (int k = 0; k < 3; ++k) demand(std::isfinite(lmp->atom->f[i][k]), "force");
}

} // namespace

PLATEN_FUZZ {
  static std::unique_ptr<LAMMPS> lmp;
  static int served = 0;
  if (!lmp || ++served % 1000 == 0) lmp = two_spheres();
  const std::string every = std::string("pair_coeff * * ") + PLATEN_FUZZ_CARDS + "/hertz.toml";
  for (const std::string& line : {std::string("pair_style none"), std::string("pair_style platen"), every})
    lmp->input->one(line);
  try {
    obey(lmp.get(), platen::fuzz::text_of(data, size));
  } catch (const Refused& refused) {
    demand(!refused.why.empty(), "without a sentence");
    return 0;
  }
  try {
    make_a_step(lmp.get());
    if (lmp->modify->find_fix("w") >= 0) lmp->modify->delete_fix("w");
  } catch (const Refused& refused) {
    demand(!refused.why.empty(), "without a sentence");
    lmp.reset(); // within a step
  }
  return 0;
}
