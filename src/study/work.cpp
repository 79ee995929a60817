#include "study/work.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/say.hpp"
#include "press/press.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <thread>

namespace platen::study {
namespace {

using Clock = std::chrono::steady_clock;

double cpu_now() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void stop_where_asked() {
  if (core::interrupted())
    throw core::Interrupted(
        "stopped as asked; the finished runs are in the store, and the same command goes on");
}

void press_one(const Run& run, const Store& store, const std::string& key, const Claim& claim) {
  const double cpu = cpu_now();
  const auto start = Clock::now();
  auto refreshed = start;
  const auto result = press::press(run.press_case, [&](double, const press::CurvePoint& point) {
    if (Clock::now() - refreshed > std::chrono::seconds(30)) {
      claim.refresh();
      refreshed = Clock::now();
    }
    return !core::interrupted() && !(run.stop_at > 0 && point.delta_bar > run.stop_at);
  });
  if (result.interrupted) stop_where_asked(); // unless it stopped where the run says
  store.keep(key, run.press_case, result,
             {cpu_now() - cpu, std::chrono::duration<double>(Clock::now() - start).count()});
}

/// In a child process; its exit code, as the program's.
int worker(const Study& study, const Store& store, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM); // nobody presses on unseen when the program was killed
  if (::getppid() != parent) return 130;
  (void)!::nice(10); // the machine may be somebody else's as well
  try {
    work(study, store);
    return 0;
  } catch (const core::Interrupted&) { return 130; } catch (const std::exception& error) {
    core::say(fmt::format("platen: {}\n", error.what()));
    return 4;
  }
}

} // namespace

Tally tally(const Study& study, const Store& store) {
  Tally t;
  for (const auto& run : study.runs) {
    const auto key = store.key(run.press_case);
    const auto state = store.state(key);
    ++t.runs;
    t.done += state == Store::State::done;
    t.failed += state == Store::State::failed;
    if (state == Store::State::missing) continue;
    const auto cost = store.cost(key);
    t.cpu_s += cost.cpu_s;
    t.wall_s += cost.wall_s;
  }
  return t;
}

void work(const Study& study, const Store& store) {
  for (;;) {
    bool all_there = true;
    for (const auto& run : study.runs) {
      stop_where_asked();
      const auto key = store.key(run.press_case);
      if (store.state(key) != Store::State::missing) continue;
      if (const auto claim = store.claim(key)) press_one(run, store, key, *claim);
      else all_there = false;
    }
    if (all_there) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(250)); // who has claimed the rest may die
  }
}

void work(const Study& study, const Store& store, int workers,
          const std::function<void(const Tally&)>& show) {
  std::fflush(nullptr); // or each child would print it again
  const pid_t self = ::getpid();
  std::vector<pid_t> children;
  for (int i = 0; i < workers; ++i) {
    const pid_t child = ::fork();
    if (child == 0) std::_Exit(worker(study, store, self));
    if (child > 0) children.push_back(child);
  }
  if (children.empty()) throw core::IoError("no worker process could be started");
  int worst = 0;
  bool told = false;
  auto shown = Clock::now();
  while (!children.empty()) {
    if (core::interrupted() && !told) {
      for (const pid_t child : children) ::kill(child, SIGTERM);
      told = true;
    }
    std::erase_if(children, [&](pid_t child) {
      int status = 0;
      if (::waitpid(child, &status, WNOHANG) != child) return false;
      worst = std::max(worst, WIFEXITED(status) ? WEXITSTATUS(status) : 4);
      return true;
    });
    if (children.empty() || Clock::now() - shown > std::chrono::milliseconds(200)) {
      show(tally(study, store));
      shown = Clock::now();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  stop_where_asked();
  if (worst == 130)
    throw core::Interrupted(
        "a worker was stopped; the finished runs are in the store, and the same command goes on");
  if (worst != 0)
    throw core::IoError("a worker stopped (its message is above, if it could give one); finished runs are in "
                        "the store, and the "
                        "same command goes on");
}

} // namespace platen::study
