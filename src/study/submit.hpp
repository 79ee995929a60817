#pragma once
// A study on a cluster: a Slurm job array whose tasks claim runs from one store.

#include <filesystem>
#include <string>
#include <vector>

namespace platen::study {

struct Job {
  std::string study; ///< name of the study, and of the job
  std::filesystem::path program, card, store;
  int tasks = 1;
  std::vector<std::string> options; ///< of sbatch, as "--time=4:00:00"
};

/// The batch script. Paths become absolute: each task starts where Slurm likes.
std::string batch_script(const Job&);

/// One word for a shell, whatever is in it.
std::string quoted(const std::string&);

} // namespace platen::study
