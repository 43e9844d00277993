#pragma once

#include <sstream>
#include <string>

namespace meshbound {

/// Six digits, however small or large: std::to_string would make 1e-12 a zero.
inline std::string number_text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

} // namespace meshbound
