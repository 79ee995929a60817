#include "study/submit.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "study/work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>

namespace platen::study {
namespace {

std::string absolute_text(const std::filesystem::path& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

/// One word for a shell, whatever is in it.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// A word as it is where a shell takes it so.
std::string word(const std::string& text) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_' || c == '.'; };
  return !text.empty() && std::ranges::all_of(text, plain) ? text : quoted(text);
}

/// What a command of the shell says, on both of its streams; nothing where it fails, whose words are in
/// `said`.
bool run(const std::string& command, std::string& said) {
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (!pipe) return false;
  char part[256];
  while (std::fgets(part, sizeof part, pipe)) said += part;
  const int status = ::pclose(pipe);
  while (said.ends_with('\n')) said.pop_back();
  return status == 0;
}

int left_in(const Study& s, const Store& store) {
  const auto t = tally(s, store);
  return t.runs - t.done - t.failed;
}

/// In the name of a file, where Slurm takes % for the number of a job.
std::string percents_doubled(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
  return result;
}

std::string script_of(const Study& s, const Store& store, const Job& job, int left) {
  std::string name;
  for (const char c : s.name) name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' ? c : '-';
  std::string script =
      fmt::format("#!/bin/bash\n"
                  "# Each task presses runs that no other has claimed; more tasks may join, and a "
                  "task that is lost costs one run.\n"
                  "#SBATCH --job-name=platen-{}\n"
                  "#SBATCH --array=1-{}\n"
                  "#SBATCH --ntasks=1\n"
                  "#SBATCH --cpus-per-task=1\n"
                  "#SBATCH --output=\"{}\"\n",
                  name, std::clamp(left, 1, job.tasks),
                  percents_doubled(std::filesystem::absolute(store.folder()).string()) + "/slurm-%A_%a.log");
  for (const auto& option : job.options) script += fmt::format("#SBATCH {}\n", option);
  script += "export OPENBLAS_NUM_THREADS=1\n";
  if (const char* catalogue = std::getenv("PLATEN_CATALOGUE"); catalogue && *catalogue)
    script += fmt::format("export PLATEN_CATALOGUE={}\n", quoted(absolute_text(catalogue)));
  script += "exec";
  for (const auto& w : job.worker) script += " " + word(w);
  return script + "\n";
}

} // namespace

std::vector<std::string> worker_of(const std::filesystem::path& program, const std::filesystem::path& card,
                                   const std::filesystem::path& store) {
  return {absolute_text(program), "study",     "run", absolute_text(card), "--store",
          absolute_text(store),   "--workers", "1"};
}

std::string batch_script(const Study& s, const Store& store, const Job& job) {
  return script_of(s, store, job, left_in(s, store));
}

std::string submit(const Study& s, Store& store, const Job& job, OldRuns old) {
  const int left = left_in(s, store);
  if (left == 0) return {};
  store.open_for_writing(old);
  const auto file = (store.folder() / "submit.sh").string();
  core::write_file(file, script_of(s, store, job, left));
  std::string said;
  if (!run("sbatch " + quoted(file), said))
    throw core::IoError(fmt::format("sbatch did not take the job ({}); its script is {}",
                                    said.empty() ? "it said nothing" : said, file));
  return said.empty() ? "sbatch took the job" : said;
}

} // namespace platen::study
