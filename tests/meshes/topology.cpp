#include "meshes/topology.hpp"

#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "meshes/shapes.hpp"

namespace meshes {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

std::vector<glm::uvec3> proper_triangles(const meshbound::Mesh& mesh) {
    std::vector<glm::uvec3> proper;
    for (const glm::uvec3& t : mesh.triangles)
        if (t.x != t.y && t.y != t.z && t.z != t.x) proper.push_back(t);
    return proper;
}

/// How often triangles run along each directed edge.
std::map<Edge, std::size_t> directed_edges(const std::vector<glm::uvec3>& triangles) {
    std::map<Edge, std::size_t> edges;
    for (const glm::uvec3& t : triangles)
        for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    return edges;
}

class Groups {
public:
    void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }
    std::size_t count() {
        std::set<std::uint32_t> roots;
        for (const auto& [vertex, up] : std::map(parent_)) roots.insert(root(vertex));
        return roots.size();
    }

private:
    std::uint32_t root(std::uint32_t v) {
        while (parent_.try_emplace(v, v).first->second != v) v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    std::map<std::uint32_t, std::uint32_t> parent_;
};

} // namespace

std::ostream& operator<<(std::ostream& out, const Topology& t) {
    return out << "Euler number " << t.euler << ", " << t.components << " components, " << t.boundary_loops
               << " boundary loops, " << t.non_manifold_edges << " non-manifold and " << t.discordant_edges
               << " discordant edges";
}

Topology topology(const meshbound::Mesh& mesh) {
    const auto triangles = proper_triangles(mesh);
    const auto directed = directed_edges(triangles);
    Topology result;
    Groups surface, boundary;
    std::set<std::uint32_t> vertices;
    std::size_t edges = 0;
    for (const auto& [edge, forward] : directed) {
        const auto [a, b] = edge;
        vertices.insert(a);
        surface.join(a, b);
        const auto opposite = directed.find({b, a});
        const std::size_t backward = opposite == directed.end() ? 0 : opposite->second;
        if (forward + backward == 1) boundary.join(a, b);
        if (backward > 0 && a > b) continue; // counted the other way
        ++edges;
        if (forward + backward > 2) ++result.non_manifold_edges;
        if (forward + backward == 2 && forward != backward) ++result.discordant_edges;
    }
    result.euler = static_cast<long>(vertices.size()) - static_cast<long>(edges) + static_cast<long>(triangles.size());
    result.components = surface.count();
    result.boundary_loops = boundary.count();
    return result;
}

std::vector<std::vector<std::uint32_t>> boundary_loops(const meshbound::Mesh& mesh) {
    const auto directed = directed_edges(proper_triangles(mesh));
    std::map<std::uint32_t, std::uint32_t> next;
    for (const auto& [edge, count] : directed)
        if (!directed.count({edge.second, edge.first})) next[edge.first] = edge.second;
    std::vector<std::vector<std::uint32_t>> loops;
    while (!next.empty()) {
        std::vector<std::uint32_t> loop;
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            if (loop.empty()) loop.push_back(at->first);
            loop.push_back(at->second);
            next.erase(at);
        }
        loop.pop_back(); // the first again
        loops.push_back(std::move(loop));
    }
    return loops;
}

double enclosed_volume(const meshbound::Mesh& mesh) {
    double volume = 0;
    for (const glm::uvec3& t : mesh.triangles)
        volume += glm::dot(point(mesh, t.x), glm::cross(point(mesh, t.y), point(mesh, t.z))) / 6;
    return volume;
}

glm::dvec3 area_vector(const meshbound::Mesh& mesh) {
    glm::dvec3 sum(0);
    for (const glm::uvec3& t : mesh.triangles)
        sum += 0.5 * glm::cross(point(mesh, t.y) - point(mesh, t.x), point(mesh, t.z) - point(mesh, t.x));
    return sum;
}

} // namespace meshes
