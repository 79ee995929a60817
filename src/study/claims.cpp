#include "study/claims.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <condition_variable>
#include <cstring>
#include <fstream>
#include <mutex>
#include <random>
#include <sstream>
#include <thread>

namespace platen::study {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ostringstream content;
  content << std::ifstream(path).rdbuf();
  return content.str();
}

/// When the process began, in ticks since the boot: tells it from a later one of the same number. Empty:
/// there is none, or it is dead and nobody has collected it.
std::string birth(long process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(file, line)) return {};
  std::istringstream rest(line.substr(line.rfind(')') + 1)); // field 3 on; proc(5): the start is field 22
  std::string field;
  for (int i = 3; i <= 22; ++i) {
    rest >> field;
    if (i == 3 && (field == "Z" || field == "X")) return {};
  }
  return field;
}

/// Names the table of processes that this one is in: the boot of the kernel, and the name space.
const std::string& process_table() {
  static const std::string name = [] {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    std::error_code error;
    return fmt::format("{}/{}", boot, fs::read_symlink("/proc/self/ns/pid", error).string());
  }();
  return name;
}

constexpr int digits = 10;
std::string beat_text(long beat) { return fmt::format("{:0{}}", beat, digits); }

/// "BEAT TOKEN PROCESS_TABLE PROCESS BIRTH": the token is like no other, the rest says where the owner is.
std::string new_owner() {
  std::random_device random;
  return fmt::format(" {:08x}{:08x} {} {} {}\n", random(), random(), process_table(), ::getpid(),
                     birth(::getpid()));
}

enum class Owner { alive, dead, elsewhere };
Owner owner(const std::string& content) {
  std::istringstream words(content);
  std::string beat, token, table, began;
  long process = 0;
  if (!(words >> beat >> token >> table >> process >> began) || table != process_table())
    return Owner::elsewhere;
  return birth(process) == began ? Owner::alive : Owner::dead;
}

constexpr int new_file = O_WRONLY | O_CREAT | O_EXCL;

/// At the start of the file; closes it, which is when others see it on a network file system. The error, 0
/// for none.
int write(const fs::path& path, int flags, std::string_view text) {
  const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int error = 0;
  if (const auto count = ::write(file, text.data(), text.size()); count != static_cast<ssize_t>(text.size()))
    error = count < 0 ? errno : ENOSPC;
  if (::close(file) != 0 && error == 0) error = errno;
  if (error != 0 && flags == new_file) ::unlink(path.c_str());
  return error;
}

[[noreturn]] void fail(const fs::path& path, int error) {
  throw core::IoError(fmt::format("{}: cannot be written: {}", path.string(), std::strerror(error)));
}

bool is_claim(const fs::path& path) { return !path.filename().string().starts_with('.'); }

} // namespace

/// Counts on until it is destroyed.
struct Claim::Heart {
  Heart(fs::path file_, std::string owner_, Pace pace)
      : file(std::move(file_)), owner(std::move(owner_)), thread([this, pace](const std::stop_token& stop) {
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any wake;
          for (long beat = 1; !wake.wait_for(lock, stop, pace.beat, [&] { return stop.stop_requested(); });
               ++beat)
            (void)write(file, O_WRONLY,
                        beat_text(beat)); // one that does not get through costs a press, no result
        }) {}
  ~Heart() {
    thread.request_stop();
    thread.join();
    if (content_of(file).ends_with(owner)) ::unlink(file.c_str()); // else it was believed dead meanwhile
  }
  fs::path file;
  std::string owner;
  std::jthread thread;
};

Claim::Claim(fs::path file, std::string owner, Pace pace)
    : heart_(std::make_unique<Heart>(std::move(file), std::move(owner), pace)) {}
Claim::Claim(Claim&&) noexcept = default;
Claim::~Claim() = default;

std::optional<Claim> Claims::take(const std::string& key) {
  const fs::path file = folder_ / key;
  for (int attempt = 0; attempt < 2; ++attempt) {
    const std::string mine = new_owner();
    const int error = write(file, new_file, beat_text(0) + mine);
    if (error == 0) {
      seen_.erase(key);
      return Claim(file, mine, pace_);
    }
    if (error != EEXIST) fail(file, error);
    const std::string content = content_of(file);
    const Owner who = owner(content);
    if (who == Owner::alive || (who == Owner::elsewhere && !stands_still(key, content))) return {};
    remove_dead(key, content);
  }
  return {};
}

bool Claims::stands_still(const std::string& name, const std::string& content) {
  const auto now = std::chrono::steady_clock::now();
  const auto [seen, is_new] = seen_.try_emplace(name, content, now);
  if (seen->second.content != content) seen->second = {content, now};
  return !is_new && now - seen->second.since > pace_.silence;
}

/// One at a time: between looking and removing, another worker might make a new claim.
void Claims::remove_dead(const std::string& key, const std::string& content) {
  const std::string right = "." + key;
  if (const int error = write(folder_ / right, new_file, {}); error != 0) {
    if (error != EEXIST) fail(folder_ / right, error);
    if (stands_still(right, {})) ::unlink((folder_ / right).c_str()); // its owner died within these lines
    return;
  }
  if (content_of(folder_ / key) == content) ::unlink((folder_ / key).c_str());
  ::unlink((folder_ / right).c_str());
  seen_.erase(right);
}

int Claims::count() const {
  int count = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error))
    count += is_claim(entry.path()) && owner(content_of(entry.path())) != Owner::dead;
  return count;
}

} // namespace platen::study
