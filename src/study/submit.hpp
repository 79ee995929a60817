#pragma once
// A study on a cluster: a Slurm job array whose tasks claim runs from one store.

#include "study/card.hpp"
#include "study/store.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace platen::study {

struct Job {
  std::vector<std::string> worker;  ///< words of the command that presses, in one process, what is missing
  int tasks = 16;                   ///< of the array; not more than runs are left
  std::vector<std::string> options; ///< of sbatch, as "--time=4:00:00"
};

/// `PROGRAM study run CARD --store STORE --workers 1`. Paths become absolute: each task starts where Slurm
/// likes.
std::vector<std::string> worker_of(const std::filesystem::path& program, const std::filesystem::path& card,
                                   const std::filesystem::path& store);

/// The batch script of what is left.
std::string batch_script(const Study&, const Store&, const Job&);

/// Writes the script into the store, as submit.sh, and hands it to sbatch: what sbatch says. Empty: nothing
/// is left to press. IoError where sbatch does not take it, or is not there.
std::string submit(const Study&, Store&, const Job&, OldRuns);

} // namespace platen::study
