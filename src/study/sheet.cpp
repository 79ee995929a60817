#include "study/sheet.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <cstring>
#include <memory>

namespace platen::study {
namespace {

std::string text_of(const Cell& cell) {
  if (const auto* i = std::get_if<std::int64_t>(&cell)) return std::to_string(*i);
  if (const auto* x = std::get_if<double>(&cell)) return core::number_text(*x);
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  return {};
}

/// A name in SQL: factors have dots in theirs.
std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

struct Close {
  void operator()(sqlite3* base) const { sqlite3_close(base); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

class Database {
 public:
  explicit Database(const std::filesystem::path& path) : path_(path) {
    sqlite3* base = nullptr;
    const int status = sqlite3_open(path.c_str(), &base);
    base_.reset(base);
    check(status);
    run("PRAGMA journal_mode = OFF"); // nobody else sees the file before it is whole
    run("BEGIN");
  }
  void run(const std::string& sql) {
    check(sqlite3_exec(base_.get(), sql.c_str(), nullptr, nullptr, nullptr));
  }
  void insert(const std::string& table, std::size_t columns, const std::vector<std::vector<Cell>>& rows) {
    const std::vector<std::string> marks(columns, "?");
    sqlite3_stmt* made = nullptr;
    const std::string sql = fmt::format("INSERT INTO {} VALUES ({})", quoted(table), fmt::join(marks, ","));
    check(sqlite3_prepare_v2(base_.get(), sql.c_str(), -1, &made, nullptr));
    const std::unique_ptr<sqlite3_stmt, Close> statement(made);
    for (const auto& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) check(bind(made, static_cast<int>(i + 1), row[i]));
      if (sqlite3_step(made) != SQLITE_DONE) check(sqlite3_errcode(base_.get()));
      check(sqlite3_reset(made));
    }
  }

 private:
  static int bind(sqlite3_stmt* statement, int place, const Cell& cell) {
    if (const auto* i = std::get_if<std::int64_t>(&cell)) return sqlite3_bind_int64(statement, place, *i);
    if (const auto* x = std::get_if<double>(&cell)) return sqlite3_bind_double(statement, place, *x);
    if (const auto* word = std::get_if<std::string>(&cell))
      return sqlite3_bind_text(statement, place, word->data(), static_cast<int>(word->size()),
                               SQLITE_TRANSIENT);
    return sqlite3_bind_null(statement, place);
  }
  void check(int status) const {
    if (status == SQLITE_OK) return;
    const int error = sqlite3_system_errno(base_.get());
    throw core::IoError(fmt::format("{}: cannot be written: {}{}", path_.string(),
                                    sqlite3_errmsg(base_.get()),
                                    error ? fmt::format(" ({})", std::strerror(error)) : ""));
  }

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Close> base_;
};

void write_all(const std::filesystem::path& path, const std::vector<Sheet>& sheets) {
  Database base(path);
  std::vector<std::vector<Cell>> notes;
  for (const auto& sheet : sheets) {
    std::vector<std::string> names; // without types: each cell keeps its own
    for (const auto& column : sheet.columns) names.push_back(quoted(column));
    base.run(fmt::format("CREATE TABLE {} ({})", quoted(sheet.name), fmt::join(names, ",")));
    base.insert(sheet.name, names.size(), sheet.rows);
    for (const auto& [key, value] : sheet.notes) notes.push_back({sheet.name, key, value});
  }
  base.run("CREATE TABLE notes (sheet, key, value)");
  base.insert("notes", 3, notes);
  base.run("COMMIT");
}

} // namespace

std::string csv_text(const Sheet& sheet) {
  std::string text;
  for (const auto& [key, value] : sheet.notes) text += fmt::format("# {} = {}\n", key, value);
  text += fmt::format("{}\n", fmt::join(sheet.columns, ","));
  for (const auto& row : sheet.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i) text += ',';
      text += text_of(row[i]);
    }
    text += '\n';
  }
  return text;
}

bool is_sqlite(std::string_view file) { return file.ends_with(".sqlite") || file.ends_with(".db"); }

void write_sqlite(const std::filesystem::path& path, const std::vector<Sheet>& sheets) {
  const auto temporary = core::temporary_name(path);
  std::error_code error;
  std::filesystem::remove(temporary, error);
  try {
    write_all(temporary, sheets);
  } catch (...) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  core::put_in_place(temporary, path);
}

} // namespace platen::study
