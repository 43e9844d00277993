#include "mesh/orientation.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "mesh/half_edge_runs.hpp"
#include "mesh/repeats_vertex.hpp"

namespace meshbound {
namespace {

constexpr std::uint32_t no_neighbour = 0xffffffff;

struct Neighbour {
    std::uint32_t triangle = no_neighbour;
    bool discordant = false; // both run along the edge in the same direction
};

/// The neighbours across edges of just two triangles, by half-edge. A triangle with a vertex twice is no surface, and has
/// none.
std::vector<Neighbour> find_neighbours(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                                       const std::vector<char>& two_sided) {
    std::vector<std::uint32_t> origin, proper; // the proper triangles among all
    origin.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const glm::uvec3& triangle = triangles[t];
        if (repeats_vertex(triangle)) continue;
        origin.insert(origin.end(), {triangle.x, triangle.y, triangle.z});
        proper.push_back(t);
    }
    std::vector<Neighbour> neighbours(3 * triangles.size());
    HalfEdgeRuns(origin, vertices).for_each_edge([&](const std::uint32_t* run, std::size_t count) {
        if (count != 2) return;
        if (!two_sided.empty() && two_sided[proper[run[0] / 3]] != two_sided[proper[run[1] / 3]]) return;
        const bool discordant = origin[run[0]] == origin[run[1]];
        for (const int i : {0, 1})
            neighbours[3 * std::size_t{proper[run[i] / 3]} + run[i] % 3] = {proper[run[1 - i] / 3], discordant};
    });
    return neighbours;
}

/// Walks over one part after another, each from its first triangle.
class Walk {
public:
    explicit Walk(std::vector<Neighbour> neighbours)
        : neighbours_(std::move(neighbours)), sides_(neighbours_.size() / 3, unknown) {}

    /// The triangles of the part of `first`; what it returns is overwritten by the next call.
    const std::vector<std::uint32_t>& part_of(std::uint32_t first) {
        part_.assign(1, first);
        sides_[first] = 0;
        orientable_ = true;
        for (std::size_t n = 0; n < part_.size(); ++n)
            for (std::uint32_t h = 3 * part_[n]; h < 3 * part_[n] + 3; ++h) step(part_[n], neighbours_[h]);
        return part_;
    }

    bool seen(std::uint32_t triangle) const { return sides_[triangle] != unknown; }
    /// Whether the part walked over last has a consistent orientation.
    bool orientable() const { return orientable_; }
    /// Whether a triangle is turned away from the first one of its part.
    bool away(std::uint32_t triangle) const { return sides_[triangle] == 1; }

    /// Of the edges of the part walked over last, twice each: between how many of its triangles the sides change as given, and
    /// once those are turned that are turned away.
    struct Discord {
        std::size_t given = 0, left = 0;
    };
    Discord discord() const {
        Discord discord;
        for (const std::uint32_t triangle : part_)
            for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
                const Neighbour& to = neighbours_[h];
                if (to.triangle == no_neighbour) continue;
                discord.given += to.discordant;
                discord.left += to.discordant != (sides_[triangle] != sides_[to.triangle]);
            }
        return discord;
    }

private:
    static constexpr char unknown = 2;

    void step(std::uint32_t from, const Neighbour& to) {
        if (to.triangle == no_neighbour) return;
        const char side = to.discordant ? static_cast<char>(1 - sides_[from]) : sides_[from];
        if (sides_[to.triangle] == unknown) {
            sides_[to.triangle] = side;
            part_.push_back(to.triangle);
        } else if (sides_[to.triangle] != side) {
            orientable_ = false;
        }
    }

    std::vector<Neighbour> neighbours_;
    std::vector<char> sides_; // by triangle: that of the part's first one (0) or the other (1)
    std::vector<std::uint32_t> part_;
    bool orientable_ = true;
};

} // namespace

Orientation orient(const std::vector<glm::uvec3>& triangles, std::size_t vertices, const std::vector<char>& two_sided) {
    Orientation result{triangles};
    Walk walk(find_neighbours(triangles, vertices, two_sided));
    for (std::uint32_t first = 0; first < triangles.size(); ++first) {
        if (walk.seen(first)) continue;
        const std::vector<std::uint32_t>& part = walk.part_of(first);
        const bool counts = two_sided.empty() || !two_sided[first];
        if (!walk.orientable()) {
            if (counts && result.unorientable_parts++ == 0) result.unorientable_triangle = first;
            if (const Walk::Discord discord = walk.discord(); discord.left >= discord.given) continue;
        }
        std::size_t away = 0;
        for (const std::uint32_t triangle : part) away += walk.away(triangle);
        const bool turn_away = 2 * away <= part.size();
        for (const std::uint32_t triangle : part) {
            if (walk.away(triangle) != turn_away) continue;
            std::swap(result.triangles[triangle].y, result.triangles[triangle].z);
            result.turned += counts;
        }
    }
    return result;
}

void note_turned(const Orientation& orientation, Oddities& oddities) {
    oddities.turned_triangles = orientation.turned;
    oddities.unorientable_parts = orientation.unorientable_parts;
    if (orientation.unorientable_parts > 0) oddities.unorientable_triangle = orientation.unorientable_triangle;
}

} // namespace meshbound
