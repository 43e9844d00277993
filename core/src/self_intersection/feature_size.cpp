#include "meshbound/feature_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/aabb_tree.hpp"
#include "geometry/point_ids.hpp"
#include "geometry/triangle_distance.hpp"
#include "geometry/triangle_intersection.hpp"
#include "mesh/scaled_points.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {
namespace {

/// Distances that agree to this fraction count as equal: rounding must not tell apart the walls of a sheet of even
/// thickness.
constexpr double same_distance = 1e-9;

/// The largest coordinate is brought to this power of two. The distance from a face is the root of a product of six
/// differences: it stays below the largest double, and lobes that are 1e-90 of the mesh's size apart still have one.
constexpr int scaled_exponent = 160;
/// So no two points are as far apart as this power of two: three differences below 2^(scaled_exponent + 2), squared and added.
constexpr int farthest_exponent = scaled_exponent + 3;

class LobeSearch {
public:
    explicit LobeSearch(const Mesh& mesh);

    /// Nothing where there is none, or where the caller cancels.
    std::optional<double> smallest(double within, const Progress& progress);

private:
    void gather_triangles(const Mesh& mesh);
    void gather_incident();
    void build_tree();
    BoundingBox box(std::uint32_t triangle, double margin) const;
    bool share_corner(std::uint32_t one, std::uint32_t other) const;
    void consider(std::uint32_t one, std::uint32_t other);
    std::vector<std::uint32_t> triangles_with_simplex(std::uint32_t triangle, unsigned simplex) const;
    bool local_minimum(std::uint32_t one, std::uint32_t other, const NearestPoints& nearest) const;

    std::vector<glm::dvec3> points_; // by vertex, scaled
    int exponent_ = 0;               // they are 2^exponent_ as large as the mesh's
    std::vector<SpatialTriangle> triangles_;
    std::vector<std::uint32_t> first_, incident_; // triangles at point id v: incident_[first_[v] … first_[v + 1])
    AabbTree tree_;
    double least_ = 0; // so far
    bool found_ = false;
};

LobeSearch::LobeSearch(const Mesh& mesh) {
    ScaledPoints scaled = scaled_points(mesh, scaled_exponent);
    points_ = std::move(scaled.points);
    exponent_ = scaled.exponent;
    gather_triangles(mesh);
    gather_incident();
    build_tree();
}

/// Triangles with two coincident corners are left out: they are no more than an edge of their neighbours.
void LobeSearch::gather_triangles(const Mesh& mesh) {
    const std::vector<std::uint32_t> ids = point_ids(points_);
    for (const glm::uvec3& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> corner_ids = {ids[t.x], ids[t.y], ids[t.z]};
        if (corner_ids[0] != corner_ids[1] && corner_ids[1] != corner_ids[2] && corner_ids[2] != corner_ids[0])
            triangles_.push_back({corner_ids, {points_[t.x], points_[t.y], points_[t.z]}});
    }
}

void LobeSearch::gather_incident() {
    first_.assign(points_.size() + 1, 0);
    for (const SpatialTriangle& triangle : triangles_)
        for (const std::uint32_t id : triangle.ids) ++first_[id + 1];
    for (std::size_t id = 0; id < points_.size(); ++id) first_[id + 1] += first_[id];
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    incident_.resize(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (const std::uint32_t id : triangles_[t].ids) incident_[fill[id]++] = t;
}

void LobeSearch::build_tree() {
    std::vector<AabbTree::Item> items;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) items.push_back({t, box(t, 0)});
    tree_.build(std::move(items), triangles_.size());
}

BoundingBox LobeSearch::box(std::uint32_t triangle, double margin) const {
    BoundingBox box;
    for (const glm::dvec3& point : triangles_[triangle].points) {
        box.include(point - margin);
        box.include(point + margin);
    }
    return box;
}

bool LobeSearch::share_corner(std::uint32_t one, std::uint32_t other) const {
    const auto& ids = triangles_[other].ids;
    return std::any_of(triangles_[one].ids.begin(), triangles_[one].ids.end(),
                       [&](std::uint32_t id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); });
}

std::optional<double> LobeSearch::smallest(double within, const Progress& progress) {
    ProgressReporter reporter(progress);
    least_ = std::min(std::ldexp(within, exponent_), std::ldexp(1.0, farthest_exponent));
    for (std::uint32_t one = 0; one < triangles_.size() && !reporter.cancelled(); ++one)
        tree_.any_overlapping(box(one, least_), [&](std::uint32_t other) {
            if (other > one && !share_corner(one, other)) consider(one, other);
            return !reporter.advance(1, double(one) / double(triangles_.size()));
        });
    if (!found_ || reporter.cancelled()) return std::nullopt;
    return std::ldexp(least_, -exponent_);
}

void LobeSearch::consider(std::uint32_t one, std::uint32_t other) {
    const NearestPoints nearest = nearest_points(triangles_[one].points, triangles_[other].points);
    if (!(nearest.squared_distance > 0) || nearest.squared_distance >= least_ * least_) return;
    if (!local_minimum(one, other, nearest)) return;
    least_ = std::sqrt(nearest.squared_distance);
    found_ = true;
}

/// The triangles that contain a simplex of this one.
std::vector<std::uint32_t> LobeSearch::triangles_with_simplex(std::uint32_t triangle, unsigned simplex) const {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < 3; ++i)
        if (simplex >> i & 1) corners.push_back(triangles_[triangle].ids[i]);
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = first_[corners[0]]; n < first_[corners[0] + 1]; ++n) {
        const auto& ids = triangles_[incident_[n]].ids;
        const bool has_all = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return std::find(ids.begin(), ids.end(), corner) != ids.end();
        });
        if (has_all) found.push_back(incident_[n]);
    }
    return found;
}

/// On two triangles, which are convex, a local minimum of the distance is the smallest distance. So the nearest points are a
/// local minimum on the surface where no two of the triangles that hold them come nearer.
bool LobeSearch::local_minimum(std::uint32_t one, std::uint32_t other, const NearestPoints& nearest) const {
    const std::vector<std::uint32_t> ones = triangles_with_simplex(one, nearest.one),
                                     others = triangles_with_simplex(other, nearest.other);
    const double least = nearest.squared_distance * (1 - same_distance);
    for (const std::uint32_t p : ones)
        for (const std::uint32_t q : others) {
            if (share_corner(p, q) || intersect_beyond_shared(triangles_[p], triangles_[q])) return false;
            if (nearest_points(triangles_[p].points, triangles_[q].points).squared_distance < least) return false;
        }
    return true;
}

} // namespace

std::optional<double> feature_size(const Mesh& mesh, double within, const Progress& progress) {
    return LobeSearch(mesh).smallest(within, progress);
}

} // namespace meshbound
