#pragma once
// Files that are either whole or not there: written under a temporary name, then renamed.

#include <filesystem>
#include <string>
#include <string_view>

namespace platen::core {

/// The whole file. IoError when it cannot be read.
std::string read_file(const std::filesystem::path&);

/// A name beside `file` under which it is written until it is whole; no other process uses the same.
std::filesystem::path temporary_name(const std::filesystem::path& file);

/// Renames a file written under temporary_name(file). IoError when that fails.
void put_in_place(const std::filesystem::path& temporary, const std::filesystem::path& file);

/// Writes the file whole or not at all. IoError (a full disk, say) leaves what was there before.
void write_file(const std::filesystem::path&, std::string_view content);

/// Makes the folder where it is missing and tries that a file can be written in it. IoError says what to do;
/// `option` is the one that names another folder.
void prepare_folder(const std::filesystem::path&, std::string_view option = "-o");

} // namespace platen::core
