// A film of pictures, made by ffmpeg where that is installed.
#pragma once

#include <string>

namespace mrsim::cli {

/// By its ending.
bool is_film(const std::string& path);

/// Throws Error "ffmpeg-missing" where no folder of PATH holds ffmpeg.
void require_ffmpeg();

/// Makes a .webm of the pictures `folder`/0001.png and on, twelve a second. Its name, in that
/// folder. Throws Error "film" where ffmpeg fails; its own words go to the standard error.
std::string make_film(const std::string& folder);

}  // namespace mrsim::cli
