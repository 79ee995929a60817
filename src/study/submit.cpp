#include "study/submit.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

namespace platen::study {
namespace {

std::string absolute_word(const std::filesystem::path& path) {
  return quoted(std::filesystem::absolute(path).lexically_normal().string());
}

} // namespace

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string batch_script(const Job& job) {
  std::string name;
  for (const char c : job.study) name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
  std::string script =
      fmt::format("#!/bin/bash\n"
                  "# Each task presses runs that no other has claimed; more tasks may join, and a "
                  "task that is lost costs one run.\n"
                  "#SBATCH --job-name=platen-{}\n"
                  "#SBATCH --array=1-{}\n"
                  "#SBATCH --ntasks=1\n"
                  "#SBATCH --cpus-per-task=1\n"
                  "#SBATCH --output=\"{}\"\n",
                  name, job.tasks, (std::filesystem::absolute(job.store) / "slurm-%A_%a.log").string());
  for (const auto& option : job.options) script += fmt::format("#SBATCH {}\n", option);
  script += "export OPENBLAS_NUM_THREADS=1\n";
  if (const char* catalogue = std::getenv("PLATEN_CATALOGUE"); catalogue && *catalogue)
    script += fmt::format("export PLATEN_CATALOGUE={}\n", absolute_word(catalogue));
  script += fmt::format("exec {} study run {} --store {} --workers 1\n", absolute_word(job.program),
                        absolute_word(job.card), absolute_word(job.store));
  return script;
}

} // namespace platen::study
