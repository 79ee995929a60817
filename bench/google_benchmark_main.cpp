// Google Benchmark's main with the option of all our benches, --out FILE.json. Each function is timed nine
// times: read the median. Options of Google Benchmark come last and win.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

int main(int argc, char** argv) {
  std::vector<std::string> arguments = {argv[0], "--benchmark_repetitions=9", "--benchmark_min_time=0.1",
                                        "--benchmark_display_aggregates_only=true"};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  for (std::size_t i = 1; i + 1 < arguments.size(); ++i)
    if (arguments[i] == "--out") {
      arguments[i] = "--benchmark_out=" + arguments[i + 1];
      arguments[i + 1] = "--benchmark_out_format=json";
    }
  std::vector<char*> pointers;
  for (auto& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
