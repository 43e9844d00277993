#include "retriangulation/layout.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/angle.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// A sector whose angle in the projection has a sine below this counts as folded: its map would be close to singular.
constexpr double flattest_sector = 1e-3;

/// In the polar layout no spoke is shorter and no angle narrower than this fraction of their mean, so that coincident
/// vertices and needles are still told apart.
constexpr double least_share = 1e-3;

/// An open fan keeps its angles unless they sum to more than this; beyond, it would overlap itself.
constexpr double widest_open_fan = 1.9 * pi;

void find_spokes(const Rows& rows, Hole& hole) {
    const glm::dvec3 centre = rows.position(hole.candidate);
    hole.spokes.clear();
    hole.positions.clear();
    for (const std::uint32_t vertex : hole.ring) {
        hole.positions.push_back(rows.position(vertex));
        hole.spokes.push_back(hole.positions.back() - centre);
    }
}

/// Whether all sectors of a closed star turn counter-clockwise and go around just once.
bool is_star_shaped(const Hole& hole) {
    int turns = 0;
    for (int i = 0; i < hole.size(); ++i) {
        const glm::dvec2& p = hole.layout[to_index(i)];
        const glm::dvec2& q = hole.layout[to_index(hole.after(i))];
        const double turn = p.x * q.y - p.y * q.x;
        if (!(turn > 0 && turn * turn > flattest_sector * flattest_sector * glm::dot(p, p) * glm::dot(q, q)))
            return false;
        if (p.y < 0 && q.y >= 0) ++turns;
    }
    return turns == 1;
}

/// The paper's layout: projection along the average normal.
bool project(Hole& hole) {
    const glm::dvec3 normal = star_normal(hole);
    const double length = glm::length(normal);
    if (!(length > 0)) return false;
    const glm::dvec3 n = normal / length;
    const glm::dvec3 magnitude = glm::abs(n);
    glm::dvec3 axis(0);
    axis[magnitude.x <= magnitude.y && magnitude.x <= magnitude.z ? 0 : magnitude.y <= magnitude.z ? 1 : 2] = 1;
    const glm::dvec3 u = glm::normalize(glm::cross(axis, n)), v = glm::cross(n, u);
    hole.layout.clear();
    for (const glm::dvec3& spoke : hole.spokes) hole.layout.push_back({glm::dot(spoke, u), glm::dot(spoke, v)});
    return is_star_shaped(hole);
}

struct PolarStar {
    std::vector<double> lengths; // of the spokes
    std::vector<double> angles;  // of the sectors
};

void raise_to_share(std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    const double mean = sum / static_cast<double>(values.size());
    for (double& value : values) value = std::max(value, mean > 0 ? least_share * mean : 1);
}

PolarStar measure_star(const Hole& hole) {
    PolarStar star;
    for (const glm::dvec3& spoke : hole.spokes) star.lengths.push_back(glm::length(spoke));
    for (int i = 0; i < hole.sectors(); ++i) {
        const glm::dvec3 s = hole.spokes[to_index(i)], t = hole.spokes[to_index(hole.after(i))];
        star.angles.push_back(half_plane_angle(glm::dot(s, t), glm::length(glm::cross(s, t))));
    }
    raise_to_share(star.lengths);
    raise_to_share(star.angles);
    return star;
}

/// Spoke lengths kept; angles scaled to fill the circle, or, for an open fan, kept where they do not overlap.
void lay_out_polar(Hole& hole) {
    const PolarStar star = measure_star(hole);
    double sum = 0;
    for (const double angle : star.angles) sum += angle;
    const double scale = !hole.open ? 2 * pi / sum : sum > widest_open_fan ? widest_open_fan / sum : 1;
    hole.layout.clear();
    double angle = 0;
    for (int i = 0; i < hole.size(); ++i) {
        const glm::dvec2 direction = unit_vector(angle);
        hole.layout.push_back(star.lengths[to_index(i)] * direction);
        if (i < hole.sectors()) angle += scale * star.angles[to_index(i)];
    }
}

} // namespace

glm::dvec3 star_normal(const Hole& hole) {
    glm::dvec3 sum(0);
    for (int i = 0; i < hole.sectors(); ++i)
        sum += glm::cross(hole.spokes[to_index(i)], hole.spokes[to_index(hole.after(i))]);
    return sum;
}

void lay_out(const Rows& rows, Hole& hole) {
    find_spokes(rows, hole);
    if (hole.open || !project(hole)) lay_out_polar(hole);
}

} // namespace meshbound
