// Studies: many presses, kept in a store.

#include "study.hpp"

#include "core/file.hpp"
#include "core/parallel.hpp"
#include "study/derived.hpp"
#include "study/design.hpp"
#include "study/filling.hpp"
#include "study/submit.hpp"
#include "study/table.hpp"
#include "study/work.hpp"

#include <fmt/format.h>

#include <limits>

namespace platen::python {

nb::list columns_of(const study::Sheet& sheet) {
  nb::list columns;
  for (std::size_t j = 0; j < sheet.columns.size(); ++j) {
    bool words = false, whole = true;
    for (const auto& row : sheet.rows) {
      words |= std::holds_alternative<std::string>(row[j]);
      whole &= std::holds_alternative<std::int64_t>(row[j]);
    }
    std::vector<double> numbers;
    std::vector<std::int64_t> counts;
    std::vector<std::string> texts;
    for (const auto& row : sheet.rows) {
      const auto* text = std::get_if<std::string>(&row[j]);
      const auto* count = std::get_if<std::int64_t>(&row[j]);
      const auto* number = std::get_if<double>(&row[j]);
      if (words)
        texts.push_back(text     ? *text
                        : count  ? fmt::format("{}", *count)
                        : number ? fmt::format("{}", *number)
                                 : "");
      else if (whole) counts.push_back(*count);
      else
        numbers.push_back(number  ? *number
                          : count ? static_cast<double>(*count)
                                  : std::numeric_limits<double>::quiet_NaN());
    }
    const auto& name = sheet.columns[j];
    if (words) columns.append(nb::make_tuple(name, texts));
    else if (whole && !sheet.rows.empty()) columns.append(nb::make_tuple(name, array_of(counts)));
    else columns.append(nb::make_tuple(name, array_of(numbers)));
  }
  return columns;
}

int processes(int workers) {
  if (workers < 0 || workers > 1024)
    throw core::InvalidInput(fmt::format("workers = {}: it must be a whole number in [1, 1024]", workers));
  return workers == 0 ? core::processors() : workers;
}

namespace {

study::OldRuns old_runs(const std::string& word) {
  if (word.empty()) return study::OldRuns::ask;
  if (word == "keep") return study::OldRuns::keep;
  if (word == "recompute") return study::OldRuns::recompute;
  throw core::InvalidInput(fmt::format("old = {}: it must be keep or recompute", word));
}

nb::dict dict_of(const study::Tally& t, const study::Store& store) {
  nb::dict failures, d;
  for (const auto& key : t.failures) failures[key.c_str()] = store.failure(key);
  d["runs"] = t.runs;
  d["done"] = t.done;
  d["failed"] = t.failed;
  d["left"] = t.runs - t.done - t.failed;
  d["claimed"] = store.claimed();
  d["cpu_s"] = t.cpu_s;
  d["wall_s"] = t.wall_s;
  d["failures"] = failures;
  return d;
}

void check_step(double step) {
  if (!(step >= 1e-5 && step <= 0.5))
    throw core::InvalidInput(fmt::format("step = {}: it must be a number in [1e-5, 0.5]", step));
}

/// As `platen study export`; what has to be read.
std::vector<std::string> export_tables(const Study& s, const std::string& runs_file,
                                       const std::string& curves_file, const std::string& variant,
                                       double step) {
  check_step(step);
  return long_work([&] {
    const auto store = s.store();
    const auto found = study::find_runs(s.study, store);
    const auto runs = study::runs_sheet(s.study, store, found, variant);
    const bool sqlite = study::is_sqlite(runs_file);
    if (sqlite || !curves_file.empty()) {
      const auto curves = study::curves_sheet(s.study, store, found, step);
      if (sqlite) study::write_sqlite(runs_file, {runs, curves});
      if (!curves_file.empty()) core::write_file(curves_file, study::csv_text(curves));
    }
    if (!sqlite) core::write_file(runs_file, study::csv_text(runs));
    if (const auto what = study::damage(store, found); !what.empty()) throw core::IoError(what);
    std::vector<std::string> said;
    if (auto what = study::nothing_done(store, found); !what.empty()) said.push_back(std::move(what));
    return said;
  });
}

/// Looks at the kept runs without the lock; what has to be read is added to `said`.
template <class Make> study::Sheet sheet_of(const Study& s, std::vector<std::string>& said, Make make) {
  return long_work([&] {
    const auto store = s.store();
    const auto found = study::find_runs(s.study, store);
    for (const auto& what : {study::nothing_done(store, found), study::damage(store, found)})
      if (!what.empty()) said.push_back(what);
    return make(store, found);
  });
}

nb::tuple run(const Study& s, int workers, nb::object progress, bool retry_failed, const std::string& old) {
  workers = processes(workers);
  auto store = s.store();
  Callback callback(std::move(progress));
  std::vector<std::string> said;
  const auto tally = watched(callback, [&] {
    store.open_for_writing(old_runs(old));
    said = study::forget_damaged(s.study, store);
    if (retry_failed)
      for (const auto& key : study::tally(s.study, store).failures) store.forget(key);
    study::work(s.study, store, workers, counting(callback));
    return study::tally(s.study, store);
  });
  study::refuse_total_failure(s.study, store, tally);
  if (tally.failed > 0)
    said.push_back(fmt::format("{} of {} presses failed: status().failures gives the reasons, "
                               "run(retry_failed=True) presses them again",
                               tally.failed, tally.runs));
  return nb::make_tuple(dict_of(tally, store), said);
}

/// `program`: words of a command that presses what is missing of the card and store behind them.
study::Job job_of(const Study& s, std::vector<std::string> program, int tasks,
                  const std::vector<std::string>& options) {
  if (tasks < 1 || tasks > 10000)
    throw core::InvalidInput(fmt::format("tasks = {}: it must be a whole number in [1, 10000]", tasks));
  for (const auto& path : {std::filesystem::path(s.study.file), s.folder})
    program.push_back(std::filesystem::absolute(path).lexically_normal().string());
  return {std::move(program), tasks, options};
}

std::vector<double> list_of(const study::Spread& s) {
  return {s.min_distance, s.min_distance_within, s.maxpro};
}

} // namespace

void add_study(nb::module_& m) {
  nb::class_<Study>(m, "Study", "A study and the folder of its runs.")
      .def_static(
          "read",
          [](const std::string& card, const std::string& folder) {
            Study s{study::read_study(card), folder};
            if (folder.empty()) s.folder = "out/" + s.study.name;
            return s;
          },
          nb::arg("card"), nb::arg("folder"))
      .def_prop_ro("name", [](const Study& s) { return s.study.name; })
      .def_prop_ro("file", [](const Study& s) { return s.study.file; })
      .def_prop_ro("folder", [](const Study& s) { return s.folder.string(); })
      .def_prop_ro("kind", [](const Study& s) { return s.study.kind; })
      .def("__len__", [](const Study& s) { return s.study.runs.size(); })
      .def("run", &run, nb::arg("workers"), nb::arg("progress").none(), nb::arg("retry_failed"),
           nb::arg("old"))
      .def("status",
           [](const Study& s) {
             const auto store = s.store();
             const auto tally = long_work([&] { return study::tally(s.study, store); });
             return dict_of(tally, store);
           })
      .def(
          "runs",
          [](const Study& s, const std::string& variant) {
            std::vector<std::string> said;
            const auto sheet = sheet_of(s, said, [&](const auto& store, const auto& found) {
              return study::runs_sheet(s.study, store, found, variant);
            });
            return nb::make_tuple(columns_of(sheet), said);
          },
          nb::arg("variant"))
      .def(
          "curves",
          [](const Study& s, double step) {
            check_step(step);
            std::vector<std::string> said;
            const auto sheet = sheet_of(s, said, [&](const auto& store, const auto& found) {
              return study::curves_sheet(s.study, store, found, step);
            });
            return nb::make_tuple(columns_of(sheet), said);
          },
          nb::arg("step"))
      .def("export", &export_tables, nb::arg("runs"), nb::arg("curves"), nb::arg("variant"), nb::arg("step"))
      .def("design", [](const Study& s) { return columns_of(study::design_sheet(s.study)); })
      .def("spread", [](const Study& s) { return list_of(study::spread_of(s.study)); })
      .def(
          "spread_beside",
          [](const Study& s, const Study& other) { return list_of(study::spread_of(other.study, s.study)); },
          nb::arg("other"))
      .def(
          "batch_script",
          [](const Study& s, const std::vector<std::string>& program, int tasks,
             const std::vector<std::string>& options) {
            return study::batch_script(s.study, s.store(), job_of(s, program, tasks, options));
          },
          nb::arg("program"), nb::arg("tasks"), nb::arg("options"))
      .def(
          "submit",
          [](const Study& s, const std::vector<std::string>& program, int tasks,
             const std::vector<std::string>& options, const std::string& old) {
            const auto job = job_of(s, program, tasks, options);
            return long_work([&] {
              auto store = s.store();
              return study::submit(s.study, store, job, old_runs(old));
            });
          },
          nb::arg("program"), nb::arg("tasks"), nb::arg("options"), nb::arg("old"))
      .def(
          "merge",
          [](const Study& s, const std::vector<std::string>& folders, const std::string& old) {
            auto store = s.store();
            const auto merged = long_work([&] {
              std::vector<study::Store> others;
              for (const auto& folder : folders) others.emplace_back(folder, s.study.name);
              return store.merge(others, old_runs(old));
            });
            return std::pair{merged.copied, merged.left_out};
          },
          nb::arg("folders"), nb::arg("old"))
      .def(
          "curve",
          [](const Study& s, const std::string& key) {
            const auto file = s.store().run(key) / "curve.csv";
            if (!core::is_there(file))
              throw core::InvalidInput(
                  fmt::format("run {}: there is no curve of it in {}", key, s.folder.string()));
            return core::read_file(file);
          },
          nb::arg("key"));
}

} // namespace platen::python
