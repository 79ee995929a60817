// The papers beside what we say.

#include "study.hpp"

#include "reproduce/reproduce.hpp"

#include <fmt/format.h>

namespace platen::python {
namespace {

nb::dict reproduce(const std::string& paper, const std::string& folder, bool fresh, int workers,
                   const std::string& previous, nb::object progress) {
  const reproduce::Request request{paper, folder, fresh, processes(workers), previous};
  Callback callback(std::move(progress));
  std::vector<std::string> said;
  const auto papers = watched(callback, [&] {
    return reproduce::reproduce(
        request,
        [&](const std::string& stage, double share, const std::string& note) {
          return callback(share, stage + ", " + note);
        },
        [&](const std::string& sentence) { said.push_back(sentence); });
  });
  nb::list rows, found;
  for (const auto& one : papers) {
    const auto t = reproduce::tally(one.rows);
    found.append(
        nb::make_tuple(one.name, t.rows, t.reproduced, t.differing, t.not_comparable, t.with_number));
    for (const auto& row : one.rows)
      rows.append(nb::make_tuple(one.name, row.id, row.name, row.subject,
                                 std::string(reproduce::name_of(reproduce::verdict(row))),
                                 reproduce::sentence(row)));
  }
  nb::dict d;
  d["papers"] = found;
  d["rows"] = rows;
  d["said"] = said;
  d["words"] = words_of(papers);
  d["page"] = (std::filesystem::path(folder) / "index.html").string();
  return d;
}

} // namespace

void add_reproduce(nb::module_& m) {
  m.def("reproduce", &reproduce, nb::arg("paper"), nb::arg("folder"), nb::arg("fresh"), nb::arg("workers"),
        nb::arg("previous"), nb::arg("progress").none(), "Writes the page of the papers.");
  m.attr("papers") = reproduce::paper_names();
}

} // namespace platen::python
