#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace meshbound {

/// Six significant digits, whatever the magnitude: std::to_string would print 1e-12 as zero. No stream: the iostream
/// library would add much to the WebAssembly module.
inline std::string number_text(double value) {
    std::array<char, 16> text; // "-1.23457e-308" and its end
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

} // namespace meshbound
