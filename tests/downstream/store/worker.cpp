// worker STUDY.toml STORE WORKERS PRESS_MS LOG [BEAT_MS SILENCE_MS]: `platen study run` with a press that
// computes nothing: it takes PRESS_MS, gives a curve that is the run's own, and adds a line "KEY PROCESS" to
// LOG.
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/version.hpp"
#include "study/work.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <thread>

namespace {

using namespace platen;

/// F_bar = c delta_bar, a_bar = sqrt(2 delta_bar), with c of the key.
press::Result quick_press(const press::Case& c, const std::string& log, std::chrono::milliseconds duration) {
  const std::string key = study::key_of(c), line = key + " " + std::to_string(::getpid()) + "\n";
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (::write(file, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::_Exit(9);
  ::close(file);
  std::this_thread::sleep_for(duration);
  press::Result result;
  result.curve.radius_m = c.radius_m;
  result.curve.sigma_ref_Pa = 1e6;
  result.curve.E_Pa = 1e8;
  result.curve.nu = 0.3;
  result.curve.experiment = "simple";
  result.curve.version = core::version;
  result.curve.engine = core::engine;
  const double slope = 3 + std::stoul(key.substr(0, 8), nullptr, 16) / std::pow(2, 32);
  for (int i = 1; i <= 40; ++i) {
    press::CurvePoint point;
    point.delta_bar = 0.0025 * i;
    point.delta_m = point.delta_bar * c.radius_m;
    point.contact_radius_m = std::sqrt(2 * point.delta_bar) * c.radius_m;
    point.F_bar = slope * point.delta_bar;
    point.force_N = point.F_bar * 3.141592653589793 * c.radius_m * c.radius_m * result.curve.sigma_ref_Pa;
    result.curve.points.push_back(point);
  }
  return result;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 6 && argc != 8) return 2;
  core::watch_for_interrupts();
  try {
    const auto study = study::read_study(argv[1]);
    study::Pace pace;
    if (argc == 8)
      pace = {std::chrono::milliseconds(std::stoi(argv[6])), std::chrono::milliseconds(std::stoi(argv[7]))};
    study::Store store(argv[2], study.name, pace);
    store.open_for_writing(study::OldRuns::ask);
    for (const auto& what : study::forget_damaged(study, store))
      std::fprintf(stderr, "note: %s\n", what.c_str());
    const std::chrono::milliseconds duration(std::stoi(argv[4]));
    study::work(
        study, store, std::stoi(argv[3]), [](const study::Tally&) {},
        [&](const press::Case& c, const press::Progress&) { return quick_press(c, argv[5], duration); });
  } catch (const core::IoError& error) {
    std::fprintf(stderr, "worker: %s\n", error.what());
    return 4;
  } catch (const core::Interrupted&) { return 130; } catch (const std::exception& error) {
    std::fprintf(stderr, "worker: %s\n", error.what());
    return 2;
  }
  return 0;
}
