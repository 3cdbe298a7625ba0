// A film of pictures, made by ffmpeg where that is installed.
#pragma once

#include <string>

namespace mrsim::cli {

/// By its ending.
bool is_film(const std::string& path);

/// Throws Error "ffmpeg-missing" where no folder of PATH holds ffmpeg.
void require_ffmpeg();

/// Writes a .webm of the pictures `folder`/0001.png and on, twelve a second, by way of a file in
/// that folder. Throws Error "film" where ffmpeg fails; its own words go to the standard error.
void write_film(const std::string& folder, const std::string& path);

}  // namespace mrsim::cli
