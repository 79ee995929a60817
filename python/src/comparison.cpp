// Laws and curves beside a curve.

#include "core.hpp"

#include "fit/comparison.hpp"
#include "material/card.hpp"
#include "plot/compare_picture.hpp"
#include "plot/gnuplot.hpp"
#include "press/curve_csv.hpp"

namespace platen::python {
namespace {

fit::CurveItem curve_item(const std::string& text, const std::string& label, std::optional<double> radius) {
  return {press::parse_curve(text, label, radius), label};
}

nb::dict dict_of(const fit::Trace& t) {
  nb::dict d;
  d["name"] = t.name;
  d["force_N"] = array_of(t.force);
  d["contact_radius_m"] = array_of(t.radius);
  d["lost_work_J"] = array_of(t.lost_work);
  return d;
}

nb::dict compare(const std::string& curve, const std::string& label, std::optional<double> radius,
                 const nb::list& items, const material::Card* material, const law::ParameterTexts& parameters,
                 const std::vector<double>& ends, const std::string& picture, const std::string& title) {
  if (!picture.empty()) (void)plot::format_of(picture); // before any work
  fit::Question q;
  q.reference = curve_item(curve, label, radius);
  for (const auto& item : items) {
    const auto three = nb::cast<nb::tuple>(item);
    const auto name = nb::cast<std::string>(three[0]);
    if (nb::isinstance<fit::LawCard>(three[1]))
      q.items.push_back(fit::LawItem{nb::cast<fit::LawCard>(three[1]), {}, name});
    else q.items.push_back(curve_item(nb::cast<std::string>(three[1]), name, radius));
  }
  if (material) q.material = material->material;
  q.parameters = parameters;
  q.ends = ends;
  const auto c = long_work([&] {
    auto found = fit::compare(q);
    if (!picture.empty()) plot::compare_picture(q, found, title, picture);
    return found;
  });
  nb::list rows, traces;
  for (const auto& range : c.ranges)
    for (std::size_t k = 0; k < c.traces.size(); ++k) {
      const fit::Deviation& d = range.deviations[k];
      rows.append(nb::make_tuple(range.above, range.to, c.traces[k].name, d.rank, d.force, d.radius,
                                 d.stiffness, d.lost_work, d.in_range));
    }
  for (const auto& trace : c.traces) traces.append(dict_of(trace));
  nb::dict result;
  result["rows"] = rows;
  result["delta_m"] = array_of(c.reference.delta);
  result["reference"] = dict_of(c.reference.trace);
  result["traces"] = traces;
  result["radius_m"] = c.reference.radius_m;
  result["warnings"] = c.warnings;
  result["words"] = words_of(c, q.reference.curve.material);
  return result;
}

} // namespace

void add_comparison(nb::module_& m) {
  m.def("compare", &compare, nb::arg("curve"), nb::arg("label"), nb::arg("radius").none(), nb::arg("items"),
        nb::arg("material").none(), nb::arg("parameters"), nb::arg("ends"), nb::arg("picture"),
        nb::arg("title"), "Deviations of laws (name, card) and curves (name, text) from a curve.");
}

} // namespace platen::python
