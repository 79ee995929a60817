#include "calibrate/ask.hpp"

#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace platen::calibrate {

std::vector<std::vector<double>> read_asked(const std::string& file, const std::vector<FreeParameter>& free) {
  const auto csv = core::read_csv(file);
  std::vector<std::size_t> columns;
  for (const auto& f : free) columns.push_back(csv.column(f.key));
  std::vector<std::vector<double>> sets;
  for (const auto& row : csv.rows) {
    sets.emplace_back();
    for (const auto column : columns) sets.back().push_back(csv.number(row, column));
  }
  if (sets.empty()) throw core::InvalidInput(fmt::format("{}: no row asks for anything", file));
  return sets;
}

std::string told_csv(const Calibration& c) {
  std::string text;
  for (const auto& free : c.free) text += free.key + ",";
  text += "deviance,R2,relative_l2\n";
  for (const auto& told : c.told) {
    for (const double value : told.values) text += core::number_text(value) + ",";
    const auto number = [](double x) { return std::isfinite(x) ? fmt::format("{:.10g}", x) : "inf"; };
    text += fmt::format("{},{},{}\n", number(told.deviance), told.force_N.empty() ? "-inf" : number(told.R2),
                        number(told.relative_l2));
  }
  return text;
}

std::string told_json(const Calibration& c) {
  nlohmann::ordered_json keys = nlohmann::ordered_json::array(), particles = keys, sets = keys;
  for (const auto& free : c.free) keys.push_back(free.key);
  for (const auto& p : c.particles) {
    std::vector<double> measured;
    for (std::size_t i = 0; i < p.samples.force_N.size(); ++i) measured.push_back(p.measured_N(i));
    particles.push_back({{"name", p.name},
                         {"diameter_m", p.diameter_m},
                         {"travel_m", p.samples.travel_m},
                         {"force_N", measured}});
  }
  for (const auto& told : c.told) { // what JSON cannot say, inf, is null
    nlohmann::ordered_json one = {{"values", told.values}};
    if (!told.force_N.empty()) {
      one["deviance"] = told.deviance, one["R2"] = told.R2, one["relative_l2"] = told.relative_l2;
      one["force_N"] = told.force_N;
    } else one["deviance"] = nullptr;
    sets.push_back(std::move(one));
  }
  return nlohmann::ordered_json{
             {"parameters", keys}, {"best", c.values}, {"measured", particles}, {"sets", sets}}
             .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
         "\n";
}

} // namespace platen::calibrate
