#include "study/store.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"
#include "core/sha256.hpp"
#include "press/case_card.hpp"
#include "press/curve_csv.hpp"
#include "press/summary.hpp"
#include "study/grid.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

namespace platen::study {
namespace {

namespace fs = std::filesystem;

/// Marks what this process writes: like no other on any host.
const std::string& token() {
  static pid_t owner = 0;
  static std::string text;
  if (owner != ::getpid()) { // also after a fork
    std::random_device random;
    text = fmt::format("{:08x}{:08x}", random(), random());
    owner = ::getpid();
  }
  return text;
}

/// What every run has, in the order of sums.txt. A failed one has failure.txt too.
constexpr std::array run_files = {"case.toml", "identity.txt", "curve.csv", "summary.json", "cost.txt"};

/// A line as sha256sum writes and checks it.
std::string sum_line(const std::string& name, std::string_view content) {
  return fmt::format("{}  {}\n", core::sha256(content), name);
}

/// study.txt: "ENGINE STUDY", then "keep ENGINE" for each other engine whose runs count. InvalidInput for
/// anything else.
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
  bool good = static_cast<bool>(std::getline(file, head.study)) && head.engine > 0;
  for (std::string line; good && std::getline(file, line);) {
    std::istringstream words(line);
    std::string keep, more;
    int engine = 0;
    good = words >> keep >> engine && keep == "keep" && engine > 0 && !(words >> more);
    head.kept.push_back(engine);
  }
  if (!good)
    throw core::InvalidInput(fmt::format(
        "{}: is not as it was written: the number of an engine and the name of the study, then lines "
        "'keep ENGINE'; mend it, or give another folder",
        (store / "study.txt").string()));
  return head;
}

/// Everything written to the file system of the folder so far is on its disk.
void sync_all(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool synced = file >= 0 && ::syncfs(file) == 0;
  const int error = errno;
  if (file >= 0) ::close(file);
  if (!synced)
    throw core::IoError(fmt::format("{}: cannot be written: {}", folder.string(), std::strerror(error)));
}

/// Whether what is not there may be remembered for a while: by file systems that are reached over a network,
/// and by those of user space, which may be.
bool remembers_names(const fs::path& folder) {
  constexpr std::array<unsigned long, 9> distant{0x6969,     0x65735546, 0xFE534D42, 0xFF534D42, 0x00C36400,
                                                 0x0BD00BD0, 0x01021997, 0x47504653, 0x5346414F};
  // NFS, FUSE, SMB2, CIFS, Ceph, Lustre, 9P, GPFS, AFS: statfs(2)
  struct statfs about {};
  return ::statfs(folder.c_str(), &about) == 0 &&
         std::ranges::count(distant, static_cast<unsigned long>(about.f_type) & 0xFFFFFFFFUL) > 0;
}

/// There, a network asked anew: what this client changes in a folder it does not remember, and then a listing
/// is a new one.
bool is_there_now(const fs::path& folder, const std::string& name, const fs::path& unused) {
  if (!remembers_names(folder)) return fs::is_directory(folder / name);
  std::error_code error;
  fs::create_directory(unused, error);
  fs::remove(unused, error);
  return std::ranges::any_of(fs::directory_iterator(folder), [&](const fs::directory_entry& entry) {
    return entry.path().filename() == name;
  });
}

} // namespace

std::string identity_of(const press::Case& c, int engine) {
  constexpr int schema = 1; // raised when what names a run changes, though its result does not
  return fmt::format("schema = {}\nengine = {}\n{}", schema, engine, press::case_identity(c));
}

std::string key_of(const press::Case& c, int engine) {
  return core::sha256(identity_of(c, engine)).substr(0, 32);
}

Store::Store(fs::path folder, std::string study, Pace pace)
    : folder_(std::move(folder)), study_(std::move(study)), engines_{core::engine},
      claims_(folder_ / "claims", pace) {
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
  auto own = key_of(c);
  if (engines_.size() == 1 || state(own) != State::missing) return own;
  for (const int engine : engines_)
    if (auto key = key_of(c, engine); state(key) != State::missing) return key;
  return own;
}

/// Claims of the dead, and unfinished runs that nobody has claimed.
void Store::sweep() {
  for (const auto& entry : fs::directory_iterator(folder_ / "claims"))
    if (const std::string name = entry.path().filename().string(); !name.starts_with('.'))
      (void)claims_.take(name);
  for (const auto& entry : fs::directory_iterator(folder_ / "runs")) {
    const std::string name = entry.path().filename().string(); // .KEY-TOKEN
    std::error_code error;
    if (name.starts_with('.') && !claims_.has(name.substr(1, name.find('-') - 1)))
      fs::remove_all(entry.path(), error);
  }
}

fs::path Store::temporary(const std::string& key) const {
  return folder_ / "runs" / fmt::format(".{}-{}", key, token());
}

Store::State Store::state(const std::string& key) const {
  if (!fs::is_directory(run(key))) return State::missing;
  return fs::exists(run(key) / "failure.txt") ? State::failed : State::done;
}

Store::State Store::verified(const std::string& key) const {
  return damage(key).empty() ? state(key) : State::damaged;
}

std::string Store::damage(const std::string& key) const {
  const fs::path folder = run(key);
  if (state(key) == State::missing)
    return fs::exists(fs::symlink_status(folder)) ? folder.string() + ": is no folder of a run" : "";
  const bool failed = state(key) == State::failed;
  const auto is_wrong = [&](std::string_view name, std::string_view what) {
    return fmt::format("{}: {}", (folder / name).string(), what);
  };
  const bool summed =
      fs::is_regular_file(folder / "sums.txt"); // older programs wrote none, and at first no identity.txt
  std::vector<std::string> names(run_files.begin(), run_files.end());
  if (failed) names.emplace_back("failure.txt");
  std::string sums;
  for (const auto& name : names) {
    if (!fs::exists(folder / name)) {
      if (!summed && name == "identity.txt") continue;
      return is_wrong(name, "is missing");
    }
    if (!fs::is_regular_file(folder / name)) return is_wrong(name, "is no file");
    const std::string content = core::read_file(folder / name);
    if (!content.ends_with('\n')) return is_wrong(name, "has no end");
    if (name == "identity.txt" && core::sha256(content).substr(0, 32) != key)
      return is_wrong(name, "is that of another run");
    sums += sum_line(name, content);
  }
  if (summed)
    return core::read_file(folder / "sums.txt") == sums
               ? ""
               : is_wrong("sums.txt", "does not belong to these files");
  try {
    if (!failed) (void)press::read_curve(folder / "curve.csv");
  } catch (const core::InvalidInput& problem) { return problem.what(); }
  return {};
}

std::optional<Claim> Store::claim(const std::string& key) {
  auto mine = claims_.take(key);
  if (!mine) return {};
  if (is_there_now(folder_ / "runs", key, temporary(key)))
    return {}; // finished between the caller's look and now
  return mine;
}

/// Whether it is this one that is there now.
bool Store::publish(const fs::path& temporary, const std::string& key) const {
  std::error_code error;
  fs::rename(temporary, run(key), error);
  if (error && state(key) == State::missing)
    throw core::IoError(fmt::format("{}: cannot be written: {}", run(key).string(), error.message()));
  return !error;
}

void Store::keep(const std::string& key, const press::Case& c, const press::Result& result, Cost cost) const {
  const fs::path folder = temporary(key);
  std::error_code error;
  fs::remove_all(folder, error);
  const std::array contents = {press::case_text(c), identity_of(c), press::curve_csv(result.curve),
                               press::summary_json(c, result),
                               fmt::format("{:.3f} {:.3f}\n", cost.cpu_s, cost.wall_s)};
  bool published = false;
  try {
    std::string sums;
    const auto add = [&](const std::string& name, const std::string& content) {
      core::write_through(folder / name, content);
      sums += sum_line(name, content);
    };
    fs::create_directories(folder);
    for (std::size_t i = 0; i < run_files.size(); ++i) add(run_files[i], contents[i]);
    if (result.failure) add("failure.txt", *result.failure + "\n");
    core::write_through(folder / "sums.txt", sums);
    core::sync_folder(folder);
    published = publish(folder, key);
    if (published) core::sync_folder(folder_ / "runs");
    else fs::remove_all(folder, error);
  } catch (const std::exception& problem) {
    fs::remove_all(folder, error);
    if (!published && state(key) != State::missing)
      return; // another worker was faster, and swept up after this one
    throw core::IoError(problem.what());
  }
}

/// Out of the way first, lest half a run be taken for a whole one.
void Store::forget(const std::string& key) const {
  const fs::path away = temporary(key) += "-old";
  std::error_code error;
  fs::rename(run(key), away, error);
  if (error && state(key) != State::missing) // else another program was faster
    throw core::IoError(fmt::format("{} cannot be removed: {}", run(key).string(), error.message()));
  fs::remove_all(away, error);
}

std::string Store::forget_damaged(const std::string& key) {
  if (damage(key).empty()) return {};
  const auto mine = claims_.take(key);
  if (!mine) return {};
  const std::string what = damage(key);
  if (!what.empty()) forget(key);
  return what;
}

Store::Glance Store::glance(const std::string& key) const {
  const std::string folder = folder_.native() + "/runs/" + key; // a path would be taken to pieces
  Glance seen;
  if (::access(folder.c_str(), F_OK) != 0) return seen;
  const int file = ::open((folder + "/cost.txt").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    seen.state = state(key);
    return seen;
  }
  std::array<char, 64> text{};
  const bool read = ::read(file, text.data(), text.size() - 1) > 0;
  ::close(file);
  if (!read || std::sscanf(text.data(), "%lf %lf", &seen.cost.cpu_s, &seen.cost.wall_s) != 2) seen.cost = {};
  seen.state = ::access((folder + "/failure.txt").c_str(), F_OK) == 0 ? State::failed : State::done;
  return seen;
}

Store::Cost Store::cost(const std::string& key) const { return glance(key).cost; }

std::string Store::failure(const std::string& key) const {
  std::string line;
  std::ifstream file(run(key) / "failure.txt");
  std::getline(file, line);
  return line;
}

/// What is against taking the run of another store for the one here; empty: nothing.
std::string Store::contradiction(const Store& other, const std::string& key) const {
  const fs::path here = run(key) / "curve.csv", there = other.run(key) / "curve.csv";
  if (core::read_file(here) == core::read_file(there)) return {};
  constexpr double tolerance = 1e-3; // other processors round otherwise; as in `study check`
  const double apart = difference(press::read_curve(here), press::read_curve(there));
  if (apart <= tolerance) return {};
  if (!std::isfinite(apart)) return there.string() + ": has other branches than the one that is here";
  return fmt::format("{}: differs by {:.2g} % from the one that is here", there.string(), 100 * apart);
}

Store::Merged Store::merge(const std::vector<Store>& others, OldRuns old) {
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
  Merged merged;
  struct Copy {
    fs::path folder;
    std::string key;
    Claim claim; ///< else it were swept up as what a dead worker left
  };
  std::vector<Copy> copies;
  const auto publish_all = [&] {
    sync_all(folder_);
    for (const auto& copy : copies) {
      if (const State here = verified(copy.key); here == State::failed || here == State::damaged)
        forget(copy.key);
      merged.copied += publish(copy.folder, copy.key);
    }
    core::sync_folder(folder_ / "runs");
    copies.clear();
  };
  constexpr std::size_t at_once = 64; // runs that are brought to the disk together
  for (const auto& other : others)
    for (const auto& entry : fs::directory_iterator(other.folder_ / "runs")) {
      const std::string key = entry.path().filename().string();
      if (key.starts_with('.')) continue;
      if (const std::string wrong = other.damage(key); !wrong.empty()) {
        merged.left_out.push_back(wrong);
        continue;
      }
      const State here = verified(key), there = other.state(key);
      if (here == State::done && there == State::done)
        if (const std::string wrong = contradiction(other, key); !wrong.empty())
          merged.left_out.push_back(wrong);
      if (here == State::done || (here == State::failed && there == State::failed)) continue;
      auto mine = claims_.take(key);
      if (!mine) continue;
      const fs::path copy = temporary(key);
      fs::remove_all(copy);
      fs::copy(entry.path(), copy, fs::copy_options::recursive);
      copies.push_back({copy, key, std::move(*mine)});
      if (copies.size() == at_once) publish_all();
    }
  if (!copies.empty()) publish_all();
  return merged;
}

} // namespace platen::study
