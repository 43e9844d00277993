#include "mesh/kept_vertices.hpp"

namespace meshbound {

Status check_kept_vertices(const std::string& whose, const std::vector<std::uint32_t>& vertices, std::size_t original,
                           Fault fault) {
    const auto wrong = [&](std::size_t v, const std::string& why) -> Status {
        return {fault,
                "Vertex " + std::to_string(v) + " of " + whose + " is said to be vertex " +
                    std::to_string(vertices[v]) + " of the original, " + why,
                "", v};
    };
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (vertices[v] >= original)
            return wrong(v, "which has " + std::to_string(original) + " vertices (counted from 0).");
        if (v > 0 && vertices[v] <= vertices[v - 1])
            return wrong(v, "but the one before to be vertex " + std::to_string(vertices[v - 1]) + "; they must rise.");
    }
    return {};
}

} // namespace meshbound
