#include "study/work.hpp"

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/say.hpp"

#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <random>
#include <thread>

namespace platen::study {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds longest_pause{5000};

double cpu_now() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void stop_where_asked(const Store& store) {
  if (core::interrupted())
    throw core::Interrupted(
        fmt::format("stopped as asked; the finished runs are in {}, and the same command goes on",
                    store.folder().string()));
}

void press_one(const Run& run, const Store& store, const std::string& key, const Press& press) {
  const double cpu = cpu_now();
  const auto start = Clock::now();
  const auto result = press(run.press_case, [&](double, const press::CurvePoint& point) {
    return !core::interrupted() && !(run.stop_at > 0 && point.delta_bar > run.stop_at);
  });
  if (result.out_of_memory) throw core::IoError(*result.failure); // another machine may have enough
  if (result.interrupted) stop_where_asked(store);                // unless it stopped where the run says
  store.keep(key, run.press_case, result,
             {cpu_now() - cpu, std::chrono::duration<double>(Clock::now() - start).count()});
}

std::vector<std::string> keys_of(const Study& study, const Store& store) {
  std::vector<std::string> keys(study.runs.size());
  core::in_parallel(keys.size(), [&](std::size_t i) { keys[i] = store.key(study.runs[i].press_case); });
  return keys;
}

struct Task {
  const Run* run;
  std::string key;
};

/// Goes through the tasks once; what remains.
std::vector<Task> pass(std::vector<Task> tasks, Store& store, const Press& press) {
  std::vector<Task> left;
  for (auto& task : tasks) {
    stop_where_asked(store);
    if (store.state(task.key) != Store::State::missing) continue;
    if (const auto claim = store.claim(task.key)) press_one(*task.run, store, task.key, press);
    else left.push_back(std::move(task));
  }
  return left;
}

std::vector<Task> tasks_of(const Study& study, const Store& store) {
  const auto keys = keys_of(study, store);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < keys.size(); ++i) tasks.push_back({&study.runs[i], keys[i]});
  return tasks;
}

void press_all(std::vector<Task> tasks, Store& store, const Press& press) {
  // Each worker begins elsewhere: so they seldom want the same run.
  if (!tasks.empty())
    std::rotate(tasks.begin(), tasks.begin() + std::random_device()() % tasks.size(), tasks.end());
  for (auto pause = std::chrono::milliseconds(50);; pause = std::min(2 * pause, longest_pause)) {
    tasks = pass(std::move(tasks), store, press);
    if (tasks.empty()) return;
    std::this_thread::sleep_for(pause); // who has claimed the rest may die
  }
}

/// In a child process; its exit code, as the program's.
int worker(const std::vector<Task>& tasks, Store& store, const Press& press, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM); // nobody presses on unseen when the program was killed
  if (::getppid() != parent) return 130;
  (void)!::nice(10);                 // the machine may be somebody else's as well
  core::ask_for_interrupts(nullptr); // signals are this process's own, whatever program it is a copy of
  core::watch_for_interrupts();
  try {
    press_all(tasks, store, press);
    return 0;
  } catch (const core::Interrupted&) { return 130; } catch (const std::exception& error) {
    core::say(fmt::format("platen: {}\n", error.what()));
    return 4;
  }
}

} // namespace

Census::Census(const Study& study, const Store& store) : store_(store), missing_(keys_of(study, store)) {
  tally_.runs = static_cast<int>(missing_.size());
}

const Tally& Census::take() {
  std::vector<Store::Glance> seen(missing_.size());
  core::in_parallel(seen.size(), [&](std::size_t i) { seen[i] = store_.glance(missing_[i]); });
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].state == Store::State::missing) {
      missing.push_back(std::move(missing_[i]));
      continue;
    }
    tally_.cpu_s += seen[i].cost.cpu_s;
    tally_.wall_s += seen[i].cost.wall_s;
    const bool failed = seen[i].state == Store::State::failed;
    if (failed) tally_.failures.push_back(std::move(missing_[i]));
    ++(failed ? tally_.failed : tally_.done);
  }
  missing_ = std::move(missing);
  return tally_;
}

Tally tally(const Study& study, const Store& store) { return Census(study, store).take(); }

void refuse_total_failure(const Study& study, const Store& store, const Tally& t) {
  if (t.done > 0 || t.failures.empty()) return;
  throw core::ConvergenceError(
      fmt::format("every press of the study failed, the first with: {}; change the case or the factors of {} "
                  "(a finer or coarser mesh, a shorter path, a material that can be pressed)",
                  store.failure(t.failures.front()), study.file),
      0, 0, 0);
}

std::vector<std::string> forget_damaged(const Study& study, Store& store) {
  std::vector<std::string> said;
  for (const auto& run : study.runs) {
    const auto key = store.key(run.press_case);
    if (store.verified(key) != Store::State::damaged) continue;
    if (const auto what = store.forget_damaged(key); !what.empty())
      said.push_back(fmt::format("{}; the run is pressed again", what));
  }
  return said;
}

void work(const Study& study, Store& store, const Press& press) {
  press_all(tasks_of(study, store), store, press);
}

void work(const Study& study, Store& store, int workers, const std::function<void(const Tally&)>& show,
          const Press& press) {
  std::fflush(nullptr); // or each child would print it again
  const pid_t self = ::getpid();
  const auto tasks = tasks_of(study, store);
  std::vector<pid_t> children;
  for (int i = 0; i < workers; ++i) {
    const pid_t child = ::fork();
    if (child == 0) std::_Exit(worker(tasks, store, press, self));
    if (child > 0) children.push_back(child);
  }
  if (children.empty()) throw core::IoError("no worker process could be started");
  int worst = 0;
  bool told = false;
  Census census(study, store);
  auto next = Clock::now();
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
    if (const auto now = Clock::now(); children.empty() || now > next) {
      show(census.take());
      next =
          Clock::now() + std::max<Clock::duration>(std::chrono::milliseconds(200), 20 * (Clock::now() - now));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  stop_where_asked(store);
  if (worst == 130)
    throw core::Interrupted(
        "a worker was stopped; the finished runs are in the store, and the same command goes on");
  if (worst != 0)
    throw core::IoError("a worker stopped (its message is above, if it could give one); finished runs are in "
                        "the store, and the "
                        "same command goes on");
}

} // namespace platen::study
