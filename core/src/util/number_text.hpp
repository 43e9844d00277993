#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace meshbound {

/// Six digits, however small or large: std::to_string would make 1e-12 a zero. No stream, which would bring a sixth of the
/// WebAssembly module's size with it.
inline std::string number_text(double value) {
    std::array<char, 16> text; // "-1.23457e-308" and its end
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

} // namespace meshbound
