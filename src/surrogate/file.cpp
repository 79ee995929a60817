#include "surrogate/surrogate.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

namespace platen::surrogate {
namespace {

constexpr std::string_view head =
    "platen-surrogate 4"; // raised when the coordinates of a model, or what follows, change

class Writer {
 public:
  std::string text = std::string(head) + "\n";

  void word(std::string_view key, std::string_view value) { text += fmt::format("{} {}\n", key, value); }
  template <class List> void list(std::string_view key, const List& values) {
    text += key;
    for (const auto value : values) text += " " + core::number_text(static_cast<double>(value));
    text += "\n";
  }
};

/// Lines in the order in which they were written.
class Reader {
 public:
  Reader(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {
    if (line() != head)
      throw core::InvalidInput(
          fmt::format("{} is no surrogate that this version reads; make it again with `platen "
                      "study surrogate`",
                      file_));
  }

  /// The key of the next line.
  std::string peek() const { return std::string(rest_.substr(0, rest_.find_first_of(" \n"))); }

  std::string_view word(std::string_view key) {
    const auto one = line();
    if (!one.starts_with(key) || (one.size() > key.size() && one[key.size()] != ' '))
      throw core::InvalidInput(
          fmt::format("{}, line {}: '{}' is expected; the file is damaged", file_, number_, key));
    return one.substr(std::min(one.size(), key.size() + 1));
  }
  std::vector<double> list(std::string_view key) {
    const auto text = word(key);
    std::vector<double> values;
    for (const char *at = text.data(), *end = at + text.size(); at < end;) {
      double value = 0;
      const auto read = std::from_chars(at, end, value);
      if (read.ec != std::errc() || !std::isfinite(value))
        throw core::InvalidInput(
            fmt::format("{}, line {}: not a list of numbers; the file is damaged", file_, number_));
      values.push_back(value);
      at = read.ptr + (read.ptr < end);
    }
    return values;
  }
  std::vector<double> list(std::string_view key, std::size_t length) {
    auto values = list(key);
    if (values.size() != length)
      throw core::InvalidInput(
          fmt::format("{}, line {}: {} numbers where {} are expected; the file is damaged", file_, number_,
                      values.size(), length));
    return values;
  }
  double number(std::string_view key) { return list(key, 1)[0]; }
  int whole(std::string_view key) { return count_of(number(key)); }
  /// Of materials, runs, elements: whole and within reason.
  int count_of(double value) const {
    if (!(value >= 0 && value <= 1e6) || value != std::floor(value))
      throw core::InvalidInput(fmt::format("{}, line {}: {} is no count; the file is damaged", file_, number_,
                                           core::number_text(value)));
    return static_cast<int>(value);
  }
  /// A list with at least one number, growing.
  std::vector<double> growing_list(std::string_view key) {
    auto values = list(key);
    if (values.empty() || !(values.front() > 0) ||
        std::adjacent_find(values.begin(), values.end(), std::greater_equal()) != values.end())
      throw core::InvalidInput(
          fmt::format("{}, line {}: '{}' must grow from above 0; the file is damaged", file_, number_, key));
    return values;
  }

 private:
  std::string_view line() {
    ++number_;
    const auto end = std::min(rest_.find('\n'), rest_.size());
    const auto one = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return one;
  }

  std::string_view rest_;
  std::string file_;
  int number_ = 0;
};

std::vector<double> list_of(const Quantiles& q) { return {q.median, q.p95, q.worst}; }
Quantiles quantiles(const std::vector<double>& q) { return {q[0], q[1], q[2]}; }

void write(Writer& out, std::string_view name, const Components& c) {
  out.list(fmt::format("{}.mean", name), c.mean);
  out.list(fmt::format("{}.rest", name), c.rest);
  out.word(fmt::format("{}.components", name), fmt::format("{}", c.basis.size()));
  for (std::size_t i = 0; i < c.basis.size(); ++i) {
    const Process& p = c.processes[i];
    out.list("basis", c.basis[i]);
    out.list("variance_plane_nugget", std::vector{p.variance, p.plane, p.nugget});
    out.list("w", p.w);
    out.list("weights", p.weights);
  }
}

void write(Writer& out, const Layer& layer) {
  out.list("inputs", layer.inputs.values);
  write(out, "force", layer.force);
  write(out, "radius", layer.radius);
  write(out, "work", layer.work);
  write(out, "exponent", layer.exponent);
}

Components read_components(Reader& in, std::string_view name, std::size_t values, const Inputs& inputs) {
  Components c;
  c.mean = in.list(fmt::format("{}.mean", name), values);
  c.rest = in.list(fmt::format("{}.rest", name), values);
  const int count = in.whole(fmt::format("{}.components", name));
  for (int i = 0; i < count; ++i) {
    c.basis.push_back(in.list("basis", values));
    const auto numbers = in.list("variance_plane_nugget", 3);
    Process p{{}, numbers[0], numbers[1], numbers[2], {}};
    p.w = in.list("w", inputs.dimensions);
    p.weights = in.list("weights", inputs.size());
    c.processes.push_back(std::move(p));
  }
  return c;
}

void write(Writer& out, std::string_view name, const LeaveOneOut& e) {
  out.list(fmt::format("{}.materials", name), std::vector{e.materials, e.locked});
  out.list(fmt::format("{}.force", name), list_of(e.force));
  out.list(fmt::format("{}.radius", name), list_of(e.radius));
  out.list(fmt::format("{}.work", name), list_of(e.work));
  out.list(fmt::format("{}.residual", name), list_of(e.residual));
  out.list(fmt::format("{}.coverage", name), std::vector{e.coverage});
}

LeaveOneOut read_errors(Reader& in, std::string_view name) {
  LeaveOneOut e;
  const auto counts = in.list(fmt::format("{}.materials", name), 2);
  e.materials = in.count_of(counts[0]);
  e.locked = in.count_of(counts[1]);
  e.force = quantiles(in.list(fmt::format("{}.force", name), 3));
  e.radius = quantiles(in.list(fmt::format("{}.radius", name), 3));
  e.work = quantiles(in.list(fmt::format("{}.work", name), 3));
  e.residual = quantiles(in.list(fmt::format("{}.residual", name), 3));
  e.coverage = in.number(fmt::format("{}.coverage", name));
  return e;
}

Layer read_layer(Reader& in, std::size_t dimensions, std::size_t knots, std::size_t unloadings) {
  Layer layer({dimensions, in.list("inputs")});
  layer.force = read_components(in, "force", knots, layer.inputs);
  layer.radius = read_components(in, "radius", knots, layer.inputs);
  layer.work = read_components(in, "work", unloadings, layer.inputs);
  layer.exponent = read_components(in, "exponent", unloadings, layer.inputs);
  return layer;
}

} // namespace

std::string text_of(const Surrogate& s) {
  Writer out;
  out.word("pool", s.pool);
  out.word("model", s.model);
  out.list("engine", std::vector{s.engine});
  out.list("asked", std::vector{s.asked});
  out.list("fine", std::vector{s.fine});
  out.list("knots", s.knots);
  out.list("unload_delta_bar", s.unload_delta_bar);
  out.list("ranges", std::vector{s.ranges.size()});
  for (const auto& range : s.ranges) out.list(range.key, std::vector{range.low, range.high});
  out.list("low", s.low);
  out.list("high", s.high);
  out.list("runs", std::vector{s.runs.size()});
  for (std::size_t i = 0; i < s.runs.size(); ++i) out.list(s.runs[i], s.numbers[i]);
  out.list("layers", std::vector{s.layers.size()});
  for (const auto& layer : s.layers) write(out, layer);
  out.list("band", std::vector{s.band});
  write(out, "left_out", s.left_out);
  if (!s.guide) return out.text;
  out.list("guide", std::vector{static_cast<double>(s.guide->elements), s.guide->step_max});
  out.list("band", std::vector{s.guide->band});
  write(out, "left_out", s.guide->left_out);
  return out.text;
}

Surrogate read_surrogate(const std::filesystem::path& file) {
  return parse_surrogate(core::read_file(file), file.string());
}

Surrogate parse_surrogate(std::string_view text, const std::string& file) {
  Reader in(text, file);
  Surrogate s;
  s.pool = in.word("pool");
  s.model = in.word("model");
  s.engine = in.whole("engine");
  s.asked = in.whole("asked");
  s.fine = in.whole("fine");
  s.knots = in.growing_list("knots");
  s.unload_delta_bar = in.list("unload_delta_bar");
  s.ranges.resize(static_cast<std::size_t>(in.whole("ranges")));
  for (auto& range : s.ranges) {
    range.key = in.peek();
    const auto ends = in.list(range.key, 2);
    range.low = ends[0];
    range.high = ends[1];
  }
  s.low = in.list("low");
  s.high = in.list("high", s.low.size());
  for (int run = in.whole("runs"); run > 0; --run) {
    s.runs.push_back(in.peek());
    s.numbers.push_back(in.list(s.runs.back(), s.ranges.size()));
  }
  const auto varying = input_of(s, s.low).size();
  const int layers = in.whole("layers");
  if (layers == 0) throw core::InvalidInput(fmt::format("{}: it has no layer; the file is damaged", file));
  for (int i = 0; i < layers; ++i)
    s.layers.push_back(read_layer(in, varying, s.knots.size(), s.unload_delta_bar.size()));
  s.band = in.number("band");
  s.left_out = read_errors(in, "left_out");
  if (in.peek() != "guide") return s;
  const auto press = in.list("guide", 2);
  Guide guide{in.count_of(press[0]), press[1], 0, {}};
  guide.band = in.number("band");
  guide.left_out = read_errors(in, "left_out");
  s.guide = guide;
  return s;
}

} // namespace platen::surrogate
