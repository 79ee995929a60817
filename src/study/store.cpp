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

#include <algorithm>
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

/// study.txt: "ENGINE STUDY", then "keep ENGINE" for each other engine whose runs count.
struct Head {
  int engine = 0; ///< 0: there is no such file
  std::string study;
  std::vector<int> kept;
};
Head read_head(const fs::path& store) {
  Head head;
  std::ifstream file(store / "study.txt");
  if (!file) return head;
  file >> head.engine >> std::ws;
  std::getline(file, head.study);
  std::string word;
  for (int engine = 0; file >> word >> engine;) head.kept.push_back(engine);
  return head;
}

constexpr auto silence = std::chrono::minutes(15);

bool old(const fs::path& path) {
  std::error_code error;
  const auto written = fs::last_write_time(path, error);
  return !error && fs::file_time_type::clock::now() - written > silence;
}

bool stale(const fs::path& claim) {
  std::ifstream file(claim);
  std::string where, began;
  long process = 0;
  const bool readable = static_cast<bool>(file >> where >> process >> began);
  if (readable && where == host()) return birth(process) != began;
  return old(claim); // not so where it was given back meanwhile
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

std::string identity_of(const press::Case& c, int engine) {
  constexpr int schema = 1; // raised when what names a run changes, though its result does not
  return fmt::format("schema = {}\nengine = {}\n{}", schema, engine, press::case_identity(c));
}

std::string key_of(const press::Case& c, int engine) {
  return core::sha256(identity_of(c, engine)).substr(0, 32);
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

Store::Store(fs::path folder, std::string study)
    : folder_(std::move(folder)), study_(std::move(study)), engines_{core::engine} {
  const Head head = read_head(folder_);
  if (head.engine == 0) return;
  if (head.study != study_)
    throw core::InvalidInput(
        fmt::format("{} holds the runs of the study '{}', not of '{}'; give another folder", folder_.string(),
                    head.study, study_));
  if (head.engine != core::engine) engines_.push_back(head.engine);
  for (const int engine : head.kept)
    if (engine != core::engine) engines_.push_back(engine);
}

void Store::open_for_writing(OldRuns old) {
  core::prepare_folder(folder_, "--store");
  core::prepare_folder(folder_ / "runs", "--store");
  core::prepare_folder(folder_ / "claims", "--store");
  sweep();
  const Head head = read_head(folder_);
  if (head.engine != 0 && head.engine != core::engine && old == OldRuns::ask)
    throw core::InvalidInput(
        fmt::format("{} was computed by engine {}, this program is engine {}; give --keep to count the old "
                    "runs and press "
                    "only what is missing, or --recompute to press all again beside them",
                    folder_.string(), head.engine, core::engine));
  if (old == OldRuns::recompute) engines_ = {core::engine};
  std::string text = fmt::format("{} {}\n", core::engine, study_);
  for (std::size_t i = 1; i < engines_.size(); ++i) text += fmt::format("keep {}\n", engines_[i]);
  const fs::path file = folder_ / "study.txt";
  if (!fs::exists(file) || core::read_file(file) != text) core::write_file(file, text);
}

std::string Store::key(const press::Case& c) const {
  for (const int engine : engines_)
    if (const auto key = key_of(c, engine); state(key) != State::missing) return key;
  return key_of(c);
}

/// Unfinished runs of dead processes, and claims of dead workers. Workers on other hosts that were silent for
/// a quarter of an hour count as dead.
void Store::sweep() const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / "runs")) {
    const std::string name = entry.path().filename().string(); // .KEY-HOST-PROCESS
    const auto first = name.find('-'), last = name.rfind('-');
    if (!name.starts_with('.') || first == last) continue;
    const auto process = core::number_from(name.substr(last + 1));
    const bool dead = name.substr(first + 1, last - first - 1) == host()
                          ? process && birth(static_cast<long>(*process)).empty()
                          : old(entry.path());
    if (dead) fs::remove_all(entry.path(), error);
  }
  for (const auto& entry : fs::directory_iterator(folder_ / "claims")) {
    if (entry.path().filename().string().starts_with('.')) {
      if (entry.path().filename() != ".lock" && old(entry.path())) fs::remove(entry.path(), error);
    } else if (stale(entry.path())) remove_if_stale(entry.path());
  }
}

fs::path Store::temporary(const std::string& key) const {
  return folder_ / "runs" / fmt::format(".{}-{}-{}", key, host(), ::getpid());
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
  const fs::path folder = temporary(key);
  std::error_code error;
  fs::remove_all(folder, error);
  try {
    fs::create_directories(folder);
    core::write_file(folder / "case.toml", press::case_text(c));
    core::write_file(folder / "identity.txt", identity_of(c));
    press::write_curve(result.curve, folder / "curve.csv");
    core::write_file(folder / "summary.json", press::summary_json(c, result));
    core::write_file(folder / "cost.txt", fmt::format("{:.3f} {:.3f}\n", cost.cpu_s, cost.wall_s));
    if (result.failure) core::write_file(folder / "failure.txt", *result.failure + "\n");
    fs::rename(folder, run(key), error);
    if (error && state(key) == State::missing)
      throw core::IoError(fmt::format("{}: {}", run(key).string(), error.message()));
    if (error) fs::remove_all(folder, error);
  } catch (const fs::filesystem_error& problem) {
    fs::remove_all(folder, error);
    throw core::IoError(problem.what());
  } catch (...) {
    fs::remove_all(folder, error);
    throw;
  }
}

/// Out of the way first, lest half a run be taken for a whole one.
void Store::forget(const std::string& key) const {
  std::error_code error;
  fs::rename(run(key), temporary(key), error);
  if (error && state(key) != State::missing) // else another program was faster
    throw core::IoError(fmt::format("{} cannot be removed: {}", run(key).string(), error.message()));
  fs::remove_all(temporary(key), error);
}

int Store::claimed() const {
  int count = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ / "claims", error))
    count += !entry.path().filename().string().starts_with('.') && !stale(entry.path());
  return count;
}

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

int Store::merge(const std::vector<Store>& others, OldRuns old) {
  for (const auto& other : others) {
    if (read_head(other.folder_).engine == 0)
      throw core::InvalidInput(
          fmt::format("{} is no run store: there is no study.txt in it", other.folder_.string()));
    for (const int engine : other.engines_) {
      if (std::find(engines_.begin(), engines_.end(), engine) != engines_.end()) continue;
      if (old != OldRuns::keep)
        throw core::InvalidInput(fmt::format(
            "{} has runs of engine {}, this program is engine {}; give --keep to count them, or leave it out",
            other.folder_.string(), engine, core::engine));
      engines_.push_back(engine);
    }
  }
  open_for_writing(old);
  int copied = 0;
  for (const auto& other : others)
    for (const auto& entry : fs::directory_iterator(other.folder_ / "runs")) {
      const std::string key = entry.path().filename().string();
      if (key.starts_with('.') || !entry.is_directory()) continue;
      const State here = state(key);
      if (here == State::done || (here == State::failed && other.state(key) == State::failed)) continue;
      const fs::path copy = temporary(key + "+"); // forget() uses the name without +
      fs::remove_all(copy);
      fs::copy(entry.path(), copy, fs::copy_options::recursive);
      if (here == State::failed) forget(key);
      fs::rename(copy, run(key));
      ++copied;
    }
  return copied;
}

} // namespace platen::study
