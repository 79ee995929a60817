#pragma once
// gnuplot as a child process.

#include <filesystem>
#include <string>
#include <string_view>

namespace platen::plot {

enum class Format { svg, png };

/// By file ending; throws InvalidInput for any other than .svg and .png.
Format format_of(const std::filesystem::path& file);

/// `set terminal` for the format of the file: white ground, a sans-serif face.
std::string terminal(const std::filesystem::path& file, int width, int height, int font_size = 14);

/// A string in gnuplot's double quotes, its special characters kept as they are.
std::string gnuplot_string(std::string_view words);

/// Runs the script, which draws on one page; `set terminal` is the script's, `set output` ours. The file
/// appears whole or not at all. Throws IoError when gnuplot is missing or complains.
void run_gnuplot(const std::string& script, const std::filesystem::path& file);

} // namespace platen::plot
