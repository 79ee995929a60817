// Data pools, and what is made of them: surrogates, methods side by side, what to press next, what matters.

#include "study.hpp"

#include "core/file.hpp"
#include "material/card.hpp"
#include "plot/gnuplot.hpp"
#include "plot/surrogate/sobol_picture.hpp"
#include "study/check.hpp"
#include "surrogate/refine_study.hpp"
#include "surrogate/words.hpp"

#include <fmt/format.h>

#include <limits>
#include <memory>
#include <variant>

namespace platen::python {
namespace {

namespace fs = std::filesystem;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void within(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw core::InvalidInput(fmt::format("{} = {}: it must be a number in [{}, {}]", name, value, low, high));
}

nb::dict dict_of(const surrogate::Quantiles& q) {
  nb::dict d;
  d["median"] = q.median, d["p95"] = q.p95, d["worst"] = q.worst;
  return d;
}

nb::dict dict_of(const surrogate::LeaveOneOut& e) {
  nb::dict d;
  d["materials"] = e.materials;
  d["locked"] = e.locked;
  d["force"] = dict_of(e.force);
  d["radius"] = dict_of(e.radius);
  d["work"] = dict_of(e.work);
  d["residual"] = dict_of(e.residual);
  d["coverage"] = e.coverage;
  return d;
}

nb::dict dict_of(const surrogate::RockErrors& e) {
  nb::dict d;
  d["materials"] = e.materials;
  for (std::size_t k = 0; k < e.of.size(); ++k) d[surrogate::coefficient_names[k]] = dict_of(e.of[k]);
  d["force"] = dict_of(e.force);
  d["work"] = dict_of(e.work);
  return d;
}

/// Of granules and metals, or of rock.
struct Surrogate {
  std::variant<surrogate::Surrogate, surrogate::Rock> of;
  std::shared_ptr<const surrogate::ReadPools> made_of = {};

  std::string text() const {
    return std::visit([](const auto& s) { return surrogate::text_of(s); }, of);
  }
  std::string words(const std::string& file) const {
    if (const auto* rock = std::get_if<surrogate::Rock>(&of)) return words_of(*rock, file);
    const auto& s = std::get<surrogate::Surrogate>(of);
    if (!made_of) return words_of(s, file);
    const auto pools = made_of->all();
    return words_of(s, file, &pools);
  }
  /// That of granules or metals. InvalidInput.
  const surrogate::Surrogate& curves(const char* for_what) const {
    if (const auto* s = std::get_if<surrogate::Surrogate>(&of)) return *s;
    throw core::InvalidInput(fmt::format("a surrogate of rock is not for {}: it has no curves", for_what));
  }
};

Surrogate make_surrogate(const std::string& pool, const std::vector<std::string>& with,
                         const std::string& coarse) {
  return long_work([&]() -> Surrogate {
    if (surrogate::is_of_rock(pool)) {
      if (!with.empty() || !coarse.empty())
        throw core::InvalidInput(pool + ": a pool of rock is taken alone");
      return {surrogate::rock_of_pool(pool)};
    }
    auto pools = std::make_shared<surrogate::ReadPools>(surrogate::read_pools(pool, with, coarse));
    auto s = surrogate::fit_surrogate(pools->all());
    return {std::move(s), std::move(pools)};
  });
}

Surrogate read_surrogate(const std::string& what) {
  const fs::path path = what;
  return long_work([&]() -> Surrogate {
    if (path.extension() == ".csv") return {surrogate::read_rock(path)};
    if (fs::is_directory(path) && !fs::exists(path / "surrogate.txt") && fs::exists(path / "grains.csv"))
      return {surrogate::read_rock(path / "grains.csv")};
    return {surrogate::find_surrogate(path)};
  });
}

Surrogate parse_surrogate(const std::string& text, const std::string& file, bool of_rock) {
  if (of_rock) return {surrogate::read_rock(core::parse_csv(text, file))};
  return {surrogate::parse_surrogate(text, file)};
}

nb::dict about(const Surrogate& s) {
  nb::dict d;
  if (const auto* rock = std::get_if<surrogate::Rock>(&s.of)) {
    d["pool"] = rock->pool;
    d["model"] = "drucker-prager";
    d["engine"] = rock->engine;
    d["materials"] = rock->grains.size();
    d["left_out"] = dict_of(rock->left_out);
    d["guided"] = nb::none();
    d["ranges"] = nb::dict();
    return d;
  }
  const auto& one = std::get<surrogate::Surrogate>(s.of);
  d["pool"] = one.pool;
  d["model"] = one.model;
  d["engine"] = one.engine;
  d["materials"] = one.runs.size();
  d["left_out"] = dict_of(one.left_out);
  d["guided"] = one.guide ? nb::object(dict_of(one.guide->left_out)) : nb::none();
  nb::dict ranges;
  for (const auto& r : one.ranges) ranges[r.key.c_str()] = nb::make_tuple(r.low, r.high);
  d["ranges"] = ranges;
  return d;
}

nb::tuple beside(const Surrogate& s, const std::string& pool) {
  const auto& one = s.curves("curves beside those of a pool");
  const auto found = long_work([&] {
    const auto other = surrogate::read_pool_data(pool, surrogate::Take::all);
    return std::pair{surrogate::errors_beside(one, other), std::pair{other, words_beside(one, other)}};
  });
  nb::list rows;
  const auto& [other, words] = found.second;
  for (std::size_t i = 0; i < found.first.size(); ++i) {
    const auto& e = found.first[i];
    rows.append(nb::make_tuple(other.runs[i].run, other.runs[i].material.name, e.force, e.radius, e.expected,
                               e.locks));
  }
  return nb::make_tuple(rows, words);
}

/// name, materials, and median, 95 %, worst of each error: force, work, residual; not-a-number where a way
/// says nothing of it.
nb::tuple row_of(const surrogate::Method& m, bool loading) {
  const surrogate::Quantiles none{nan, nan, nan};
  const auto &f = loading ? m.force : none, &w = loading ? none : m.work, &r = loading ? none : m.residual;
  return nb::make_tuple(loading ? "loading" : "unloading", m.name, m.materials, f.median, f.p95, f.worst,
                        w.median, w.p95, w.worst, r.median, r.p95, r.worst);
}

nb::tuple methods(const std::string& pool, const std::vector<std::string>& with, const Surrogate* made) {
  nb::list rows;
  if (surrogate::is_of_rock(pool)) {
    const auto [rock, found] = long_work([&] {
      auto read = surrogate::rock_of_pool(pool);
      auto ways = surrogate::rock_methods(read);
      return std::pair{std::move(read), std::move(ways)};
    });
    for (const auto& [name, e] : found)
      rows.append(nb::make_tuple("both", name, e.materials, e.force.median, e.force.p95, e.force.worst,
                                 e.work.median, e.work.p95, e.work.worst, nan, nan, nan));
    return nb::make_tuple(rows, words_of(rock, found));
  }
  const surrogate::Surrogate* given = made ? &made->curves("methods side by side") : nullptr;
  const auto [found, name] = long_work([&] {
    const auto pools = surrogate::read_pools(pool, with);
    const auto anew = given ? surrogate::Surrogate{} : surrogate::fit_surrogate(pools.all());
    return std::pair{surrogate::methods_side_by_side(given ? *given : anew, pools.fine), pools.fine.name};
  });
  for (const auto& m : found.loading) rows.append(row_of(m, true));
  for (const auto& m : found.unloading) rows.append(row_of(m, false));
  return nb::make_tuple(rows, words_of(found, name));
}

nb::dict check(const std::string& folder, double share, std::int64_t seed, bool cheapest, double until,
               int workers, nb::object progress) {
  within("share", share, 0, 1);
  within("seed", static_cast<double>(seed), 0, 1e9);
  if (until != 0) within("until", until, 1e-4, 1);
  const study::CheckOptions how{share, static_cast<std::uint64_t>(seed), cheapest, until, processes(workers)};
  Callback callback(std::move(progress));
  const auto found =
      watched(callback, [&] { return study::check(study::read_pool(folder), how, counting(callback)); });
  nb::list rows;
  for (const auto& c : found.runs)
    rows.append(nb::make_tuple(c.run + 1, found.same(c), c.difference.value_or(nan), c.reason));
  nb::dict d;
  d["rows"] = rows;
  d["engine"] = found.engine;
  d["tolerance"] = found.tolerance;
  d["words"] = words_of(found);
  d["refusal"] = "";
  try {
    study::refuse_different(found);
  } catch (const core::InvalidInput& error) { d["refusal"] = error.what(); }
  return d;
}

nb::dict refine(const Study& s, const Surrogate& surrogate, double target, int most,
                const std::string& file) {
  within("target", target, 1e-5, 1);
  within("most", most, 1, 100000);
  const auto& curves = surrogate.curves("a refinement");
  const auto r = long_work(
      [&] { return surrogate::refine_study(s.study, curves, target, static_cast<std::size_t>(most), file); });
  std::vector<std::int64_t> runs;
  for (const auto i : r.refined.chosen) runs.push_back(static_cast<std::int64_t>(i) + 1);
  nb::dict d;
  d["runs"] = array_of(runs);
  d["expected"] = array_of(r.refined.largest);
  d["candidates"] = r.candidates;
  d["card"] = r.card.string();
  d["table"] = r.table.string();
  d["words"] = words_of(r, target);
  return d;
}

nb::dict sobol(const material::Card& card, double share, const std::string& picture) {
  within("within", share, 0.001, 0.9);
  if (!picture.empty()) (void)plot::format_of(picture);
  const auto s = long_work([&] {
    auto found = surrogate::sobol_of_catalogue(card.material, share);
    if (!picture.empty()) plot::sobol_picture(found, picture);
    return found;
  });
  nb::list numbers;
  for (const auto& n : s.numbers) {
    nb::dict one;
    one["key"] = n.key;
    one["low"] = n.low;
    one["high"] = n.high;
    one["alone"] = array_of(n.alone);
    one["total"] = array_of(n.total);
    numbers.append(one);
  }
  nb::dict d;
  d["pool"] = s.pool;
  d["outputs"] = s.outputs;
  d["deviation"] = array_of(s.deviation);
  d["numbers"] = numbers;
  d["held"] = s.held;
  d["words"] = words_of(s, card.material.name, share);
  return d;
}

} // namespace

void add_pools(nb::module_& m) {
  nb::class_<Surrogate>(m, "Surrogate", "What is known of materials between those that were pressed.")
      .def_static("make", &make_surrogate, nb::arg("pool"), nb::arg("with_"), nb::arg("coarse"),
                  "Of a pool, by its folder.")
      .def_static("read", &read_surrogate, nb::arg("what"), "By its file, or the folder of its pool.")
      .def_static("parse", &parse_surrogate, nb::arg("text"), nb::arg("file"), nb::arg("of_rock"),
                  "From its text.")
      .def("text", &Surrogate::text, "The file.")
      .def("words", &Surrogate::words, nb::arg("file"), "What it is made of, and its errors.")
      .def("about", &about, "Pool, model, ranges, errors.")
      .def_prop_ro("of_rock",
                   [](const Surrogate& s) { return std::holds_alternative<surrogate::Rock>(s.of); })
      .def("beside", &beside, nb::arg("pool"), "Errors on a pool that it is not made of, and words.");
  m.def("methods", &methods, nb::arg("pool"), nb::arg("with_"), nb::arg("surrogate").none(),
        "Ways to predict the materials of a pool, and words.");
  m.def("check", &check, nb::arg("pool"), nb::arg("share"), nb::arg("seed"), nb::arg("cheapest"),
        nb::arg("until"), nb::arg("workers"), nb::arg("progress").none(), "Runs of a pool pressed again.");
  m.def("refine", &refine, nb::arg("study"), nb::arg("surrogate"), nb::arg("target"), nb::arg("most"),
        nb::arg("file"), "Writes a study of what to press next.");
  m.def("sobol", &sobol, nb::arg("material"), nb::arg("within"), nb::arg("picture"),
        "Sobol indices of a material.");
}

} // namespace platen::python
