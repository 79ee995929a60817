#include "study/store.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/summary.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>

namespace platen::study {
namespace {

namespace fs = std::filesystem;

std::string host() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// When the process began, in ticks: tells it from a later one of the same number. Empty: there is none.
std::string birth(long process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(file, line)) return {};
  std::istringstream rest(line.substr(line.rfind(')') + 1)); // field 3 on; proc(5): the start is field 22
  std::string field;
  for (int i = 3; i <= 22; ++i) {
    rest >> field;
    if (i == 3 && (field == "Z" || field == "X")) return {}; // killed, and nobody has collected it
  }
  return field;
}

bool stale(const fs::path& claim) {
  std::ifstream file(claim);
  std::string where, began;
  long process = 0;
  std::error_code error;
  const auto age = fs::file_time_type::clock::now() - fs::last_write_time(claim, error);
  if (error) return false; // given back meanwhile
  const bool readable = static_cast<bool>(file >> where >> process >> began);
  if (readable && where == host()) return birth(process) != began;
  return age > std::chrono::minutes(15);
}

/// False when somebody else has it. link(2) is exclusive as O_EXCL is, and the claim is never there without
/// its words.
bool make(const fs::path& claim) {
  const fs::path own = claim.parent_path() / fmt::format(".{}-{}", host(), ::getpid());
  core::write_file(own, fmt::format("{} {} {}\n", host(), ::getpid(), birth(::getpid())));
  const bool made = ::link(own.c_str(), claim.c_str()) == 0;
  const int error = errno;
  ::unlink(own.c_str());
  if (!made && error != EEXIST)
    throw core::IoError(fmt::format("{} cannot be made: {}", claim.string(), std::strerror(error)));
  return made;
}

/// Removes a stale claim. One at a time: between looking and removing, another worker might make a new one.
void remove_if_stale(const fs::path& claim) {
  const fs::path lock = claim.parent_path() / ".lock";
  const int file = ::open(lock.c_str(), O_RDWR | O_CREAT, 0644);
  if (file < 0)
    throw core::IoError(fmt::format("{} cannot be made: {}", lock.string(), std::strerror(errno)));
  if (::flock(file, LOCK_EX) == 0 && stale(claim)) ::unlink(claim.c_str());
  ::close(file); // gives the lock back
}

} // namespace

std::string key_of(const press::Case& c, int engine) {
  return core::sha256(fmt::format("engine = {}\n{}", engine, press::case_text(c))).substr(0, 32);
}

Claim::~Claim() {
  if (file_.empty()) return;
  // After a long sleep another worker may have taken it over: that claim stays.
  std::ifstream file(file_);
  std::string where;
  long process = 0;
  if (file >> where >> process && where == host() && process == ::getpid()) ::unlink(file_.c_str());
}

void Claim::refresh() const {
  std::error_code error;
  fs::last_write_time(file_, fs::file_time_type::clock::now(), error);
}

Store::Store(fs::path folder, std::string study) : folder_(std::move(folder)), study_(std::move(study)) {}

void Store::open_for_writing(bool recompute) const {
  core::prepare_folder(folder_);
  core::prepare_folder(folder_ / "runs");
  core::prepare_folder(folder_ / "claims");
  const fs::path head = folder_ / "study.txt";
  if (fs::exists(head)) {
    std::ifstream file(head);
    int engine = 0;
    std::string name;
    file >> engine >> std::ws;
    std::getline(file, name);
    if (name != study_)
      throw core::InvalidInput(
          fmt::format("{} holds the runs of the study '{}', not of '{}'; give another folder",
                      folder_.string(), name, study_));
    if (engine == core::engine) return;
    if (!recompute)
      throw core::InvalidInput(fmt::format(
          "{} was computed by engine {}, this program is engine {}; to press again beside the old runs, give "
          "--recompute; to keep the old runs as they are, use another folder",
          folder_.string(), engine, core::engine));
  }
  core::write_file(head, fmt::format("{} {}\n", core::engine, study_));
}

Store::State Store::state(const std::string& key) const {
  if (!fs::is_directory(run(key))) return State::missing;
  return fs::exists(run(key) / "failure.txt") ? State::failed : State::done;
}

std::optional<Claim> Store::claim(const std::string& key) const {
  const fs::path file = folder_ / "claims" / key;
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (make(file)) {
      Claim mine(file);
      // It may have been finished between the caller's look and now.
      if (state(key) != State::missing) return {};
      return mine;
    }
    if (stale(file)) remove_if_stale(file);
  }
  return {};
}

void Store::keep(const std::string& key, const press::Case& c, const press::Result& result, Cost cost) const {
  const fs::path folder = folder_ / "runs" / fmt::format(".{}-{}-{}", key, host(), ::getpid());
  std::error_code error;
  fs::remove_all(folder, error);
  try {
    fs::create_directories(folder);
    core::write_file(folder / "case.toml", press::case_text(c));
    press::write_curve(result.curve, folder / "curve.csv");
    core::write_file(folder / "summary.json", press::summary_json(c, result));
    core::write_file(folder / "cost.txt", fmt::format("{:.3f} {:.3f}\n", cost.cpu_s, cost.wall_s));
    if (result.failure) core::write_file(folder / "failure.txt", *result.failure + "\n");
    fs::rename(folder, run(key));
  } catch (const fs::filesystem_error& problem) {
    fs::remove_all(folder, error);
    throw core::IoError(problem.what());
  } catch (...) {
    fs::remove_all(folder, error);
    throw;
  }
}

void Store::forget(const std::string& key) const { fs::remove_all(run(key)); }

Store::Cost Store::cost(const std::string& key) const {
  Cost cost;
  std::ifstream(run(key) / "cost.txt") >> cost.cpu_s >> cost.wall_s;
  return cost;
}

std::string Store::failure(const std::string& key) const {
  std::string line;
  std::ifstream file(run(key) / "failure.txt");
  std::getline(file, line);
  return line;
}

int Store::merge(const Store& from) const {
  int copied = 0;
  for (const auto& entry : fs::directory_iterator(from.folder_ / "runs")) {
    const std::string key = entry.path().filename().string();
    if (key.starts_with('.') || !entry.is_directory()) continue;
    const State here = state(key);
    if (here == State::done || (here == State::failed && from.state(key) == State::failed)) continue;
    const fs::path temporary = folder_ / "runs" / fmt::format(".{}-{}-{}", key, host(), ::getpid());
    fs::remove_all(temporary);
    fs::copy(entry.path(), temporary, fs::copy_options::recursive);
    if (here == State::failed) forget(key);
    fs::rename(temporary, run(key));
    ++copied;
  }
  return copied;
}

} // namespace platen::study
