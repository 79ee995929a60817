#include "reproduce/page.hpp"

#include "core/file.hpp"
#include "core/version.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace platen::reproduce {
namespace {

namespace fs = std::filesystem;

constexpr const char* style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; color: #1f2933; background: #fff; margin: 0 auto; padding: 1rem; max-width: 75rem; }
h1 { font-size: 1.7rem; line-height: 1.2; }
h2 { font-size: 1.35rem; line-height: 1.25; margin-top: 2.5rem; border-top: 2px solid #1f2933; padding-top: .8rem; }
h3 { font-size: 1.05rem; margin: 0 0 .4rem; }
p { margin: .4rem 0; max-width: 46rem; }
a { color: #00558c; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; }
th, td { text-align: left; padding: .25rem .6rem .25rem 0; border-bottom: 1px solid #d9dee3; vertical-align: top; }
th.n, td.n { text-align: right; font-variant-numeric: tabular-nums; }
td.n, td:first-child > a { white-space: nowrap; }
td:first-child { min-width: 9rem; } .contents td:first-child { min-width: 0; }
article { border-left: 5px solid; padding: .2rem 0 .2rem .9rem; margin: 1.6rem 0; }
article.reproduced { border-color: #1b6e3c; } article.differs { border-color: #b35900; } article.not { border-color: #7b8794; }
.verdict { font-weight: 600; }
.reproduced .verdict, td.reproduced { color: #1b6e3c; } .differs .verdict, td.differs { color: #9a4a00; } .not .verdict, td.not { color: #4a5560; }
.out { color: #9a4a00; font-weight: 600; }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(21rem, 100%), 1fr)); gap: .8rem; margin: .6rem 0; }
.figures.maps { grid-template-columns: repeat(auto-fill, minmax(min(34rem, 100%), 1fr)); }
figure { margin: 0; }
figure img { width: 100%; height: auto; }
figcaption { font-size: .85rem; color: #4a5560; }
@media print {
  body { max-width: none; font-size: 10pt; }
  h2 { break-before: page; } h3 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  .figures { grid-template-columns: repeat(3, 1fr); }
  a { color: inherit; text-decoration: none; }
}
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    default:
      result += c;
    }
  return result;
}

const char* css_class(Verdict v) {
  return v == Verdict::reproduced ? "reproduced" : v == Verdict::differs ? "differs" : "not";
}

std::string tolerance_words(const Comparison& c) {
  return c.measure == Measure::relative ? fmt::format("{:.2g} %", 100 * c.tolerance)
                                        : fmt::format("{:.2g}", c.tolerance);
}

std::string comparison_table(const Row& row) {
  std::string text =
      "<div class=\"wide\" tabindex=\"0\"><table><thead><tr><th>number</th><th class=\"n\">paper</th><th "
      "class=\"n\">ours</th><th class=\"n\">difference</th>"
      "<th class=\"n\">tolerance</th></tr></thead><tbody>\n";
  for (const Comparison& c : row.comparisons)
    fmt::format_to(std::back_inserter(text),
                   "<tr><td>{}</td><td class=\"n\">{:.4g}</td><td class=\"n\">{:.4g}</td><td "
                   "class=\"n{}\">{}</td><td class=\"n\">{}</td></tr>\n",
                   escaped(c.what), c.theirs, c.ours, agrees(c) ? "" : " out", difference_text(c),
                   tolerance_words(c));
  return text + "</tbody></table></div>\n";
}

/// "es-fig-11-a"
std::string chart_name(const Row& row, std::size_t k) {
  return fmt::format("{}-{}", row.id, static_cast<char>('a' + k));
}
std::string picture_name(const Row& row, std::size_t k) {
  return fmt::format("{}-map-{}.svg", row.id, k + 1);
}

std::string figures(const Row& row) {
  std::string text;
  if (!row.pictures.empty()) {
    text += "<div class=\"figures maps\">\n";
    for (std::size_t k = 0; k < row.pictures.size(); ++k)
      fmt::format_to(std::back_inserter(text),
                     "<figure><a href=\"figures/{0}\"><img src=\"figures/{0}\" alt=\"{1}\" "
                     "loading=\"lazy\"></a><figcaption>{1}</figcaption></figure>\n",
                     picture_name(row, k), escaped(row.pictures[k].caption));
    text += "</div>\n";
  }
  if (row.charts.empty()) return text;
  text += "<div class=\"figures\">\n";
  for (std::size_t k = 0; k < row.charts.size(); ++k)
    fmt::format_to(std::back_inserter(text),
                   "<figure><a href=\"figures/{0}.svg\"><img src=\"figures/{0}.svg\" alt=\"{1}: {2} over "
                   "{3}\" width=\"{4}\" height=\"{5}\" loading=\"lazy\"></a>"
                   "<figcaption>{1} · <a href=\"figures/{0}.csv\">CSV</a></figcaption></figure>\n",
                   chart_name(row, k), escaped(row.charts[k].title), escaped(row.charts[k].y_label),
                   escaped(row.charts[k].x_label), chart_width, chart_height);
  return text + "</div>\n";
}

std::string article(const Row& row, const std::vector<Change>& changed) {
  const Verdict v = verdict(row);
  std::string text =
      fmt::format("<article id=\"{}\" class=\"{}\">\n<h3>{}: {}</h3>\n<p class=\"verdict\">{}</p>\n", row.id,
                  css_class(v), escaped(row.name), escaped(row.subject), escaped(sentence(row)));
  for (const Change& c : changed)
    if (c.row == row.id)
      fmt::format_to(std::back_inserter(text), "<p class=\"out\">Changed: {}: {} before, {} now.</p>\n",
                     escaped(c.what), difference_text(c.before, c.measure),
                     difference_text(c.now, c.measure));
  fmt::format_to(std::back_inserter(text), "<p>The paper: {}</p>\n", escaped(row.theirs));
  if (!row.ours.empty() && row.ours != "–")
    fmt::format_to(std::back_inserter(text), "<p>Ours: {}</p>\n", escaped(row.ours));
  if (!row.comparisons.empty()) {
    text += comparison_table(row);
    if (!row.because.empty()) fmt::format_to(std::back_inserter(text), "<p>{}</p>\n", escaped(row.because));
  }
  return text + figures(row) + "</article>\n";
}

std::string contents(const Paper& paper) {
  std::string text =
      "<div class=\"wide "
      "contents\"><table><thead><tr><th>row</th><th>what</th><th>verdict</th></tr></thead><tbody>\n";
  for (const Row& row : paper.rows) {
    const Verdict v = verdict(row);
    const Comparison* c = worst(row);
    fmt::format_to(std::back_inserter(text),
                   "<tr><td><a href=\"#{}\">{}</a></td><td>{}</td><td class=\"{}\">{}</td></tr>\n", row.id,
                   escaped(row.name), escaped(row.subject), css_class(v),
                   v == Verdict::differs ? fmt::format("differs by {}", difference_text(*c))
                                         : std::string(name_of(v)));
  }
  return text + "</tbody></table></div>\n";
}

std::string tally_row(const std::string& name, const Tally& t) {
  return fmt::format("<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
                     "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
                     name, t.rows, t.reproduced, t.differing, t.not_comparable, t.with_number);
}

std::string short_title(const std::string& title) { return title.substr(0, title.find(':')); }

std::string summary(const std::vector<Paper>& papers) {
  std::string text =
      "<div class=\"wide\" tabindex=\"0\"><table><thead><tr><th>paper</th><th class=\"n\">rows</th><th "
      "class=\"n\">reproduced</th><th class=\"n\">differing</th>"
      "<th class=\"n\">not comparable</th><th class=\"n\">with a number</th></tr></thead><tbody>\n";
  Tally all;
  for (const Paper& paper : papers) {
    const Tally t = tally(paper.rows);
    text +=
        tally_row(fmt::format("<a href=\"#{}\">{}</a>", paper.name, escaped(short_title(paper.title))), t);
    all.rows += t.rows;
    all.reproduced += t.reproduced;
    all.differing += t.differing;
    all.not_comparable += t.not_comparable;
    all.with_number += t.with_number;
  }
  if (papers.size() > 1) text += tally_row("all", all);
  return text + "</tbody></table></div>\n";
}

std::string source_table(const Data& data) {
  std::string text =
      "<details><summary>The data: pools and presses, engine and date</summary>\n<div "
      "class=\"wide\" tabindex=\"0\"><table><thead><tr><th>in the catalogue</th><th class=\"n\">runs</th>"
      "<th class=\"n\">engine</th><th>pressed</th></tr></thead><tbody>\n";
  for (const auto& s : data.sources())
    fmt::format_to(std::back_inserter(text),
                   "<tr><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td></tr>\n",
                   escaped(s.name), s.runs, escaped(s.engine), escaped(s.date));
  return text + "</tbody></table></div></details>\n";
}

std::string change_words(const std::vector<Change>& changed, const std::optional<Earlier>& earlier) {
  if (!earlier) return "<p>There is no earlier page to compare with.</p>\n";
  if (changed.empty())
    return fmt::format("<p>Against the numbers of engine {} nothing changed by more than its error.</p>\n",
                       escaped(earlier->engine));
  std::string text =
      fmt::format("<p class=\"out\">Against the numbers of engine {} {} changed by more than their error, or "
                  "their row's verdict did:</p>\n<div class=\"wide\" tabindex=\"0\"><table><thead><tr>"
                  "<th>row</th><th>number</th><th class=\"n\">difference before</th><th "
                  "class=\"n\">now</th><th>verdict</th></tr></thead><tbody>\n",
                  escaped(earlier->engine), changed.size());
  for (const Change& c : changed)
    fmt::format_to(std::back_inserter(text),
                   "<tr><td><a href=\"#{}\">{}</a></td><td>{}</td><td class=\"n\">{}</td><td "
                   "class=\"n\">{}</td><td>{}</td></tr>\n",
                   c.row, escaped(c.name), escaped(c.what), difference_text(c.before, c.measure),
                   difference_text(c.now, c.measure),
                   c.verdict_before == c.verdict_now
                       ? c.verdict_now
                       : fmt::format("{} → {}", c.verdict_before, c.verdict_now));
  return text + "</tbody></table></div>\n";
}

void draw_figures(const std::vector<Paper>& papers, const Data& data, const fs::path& folder,
                  const std::function<void(double)>& show) {
  std::size_t total = 0, done = 0;
  for (const Paper& paper : papers)
    for (const Row& row : paper.rows) total += row.charts.size();
  for (const Paper& paper : papers)
    for (const Row& row : paper.rows) {
      for (std::size_t k = 0; k < row.pictures.size(); ++k)
        core::write_file(folder / picture_name(row, k), core::read_file(data.file(row.pictures[k].source)));
      for (std::size_t k = 0; k < row.charts.size(); ++k) {
        draw(row.charts[k], folder / chart_name(row, k));
        show(static_cast<double>(++done) / static_cast<double>(total));
      }
    }
}

} // namespace

Tally tally(const std::vector<Row>& rows) {
  Tally t;
  for (const Row& row : rows) {
    ++t.rows;
    const Verdict v = verdict(row);
    t.reproduced += v == Verdict::reproduced;
    t.differing += v == Verdict::differs;
    t.not_comparable += v == Verdict::not_comparable;
    t.with_number += !row.comparisons.empty();
  }
  return t;
}

void write_page(const std::vector<Paper>& papers, const Data& data, const std::optional<Earlier>& earlier,
                const fs::path& folder, const std::function<void(double)>& show) {
  core::prepare_folder(folder / "figures");
  draw_figures(papers, data, folder / "figures", show);
  const std::vector<Change> changed = earlier ? changes(papers, *earlier) : std::vector<Change>{};
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>The papers, reproduced</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n<h1>The papers, "
      "reproduced</h1>\n"
      "<p>Every figure and table of the papers that holds a result, beside what Platen says. A row is "
      "<em>reproduced</em> where every number of the paper is met within the tolerance that "
      "stands beside it; it <em>differs</em> where one is not; it <em>cannot be compared</em> where the "
      "paper prints no number for it. Verdicts are computed from the numbers.</p>\n",
      style);
  html += summary(papers);
  html += fmt::format(
      "<p>Platen {}, engine {}. The numbers of this page: <a href=\"numbers.csv\">numbers.csv</a>.</p>\n",
      core::version, core::engine);
  html += change_words(changed, earlier) + source_table(data);
  for (const Paper& paper : papers) {
    html += fmt::format("<section>\n<h2 id=\"{}\">{}</h2>\n<p>{}</p>\n<p>{}</p>\n", paper.name,
                        escaped(paper.title), escaped(paper.notation), escaped(paper.without_row));
    html += contents(paper);
    for (const Row& row : paper.rows) html += article(row, changed);
    html += "</section>\n";
  }
  core::write_file(folder / "numbers.csv", numbers_csv(papers));
  core::write_file(folder / "index.html", html + "</main>\n</body>\n</html>\n");
}

} // namespace platen::reproduce
