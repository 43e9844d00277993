#include "meshbound/feature_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/places.hpp"
#include "mesh/scaled_points.hpp"
#include "util/ticker.hpp"
#include "geometry/triangle_contact.hpp"
#include "geometry/triangle_distance.hpp"
#include "geometry/triangle_tree.hpp"

namespace meshbound {
namespace {

/// Distances that agree to this fraction are the same: rounding must not part the walls of an even sheet.
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
    void gather_around();
    void build_tree();
    BoundingBox box(std::uint32_t triangle, double margin) const;
    bool share_place(std::uint32_t one, std::uint32_t other) const;
    void look_at(std::uint32_t one, std::uint32_t other);
    std::vector<std::uint32_t> holding(std::uint32_t triangle, unsigned part) const;
    bool local_minimum(std::uint32_t one, std::uint32_t other, const NearestPoints& nearest) const;

    std::vector<glm::dvec3> points_; // by vertex, scaled
    int exponent_ = 0;               // they are 2^exponent_ as large as the mesh's
    std::vector<PlacedTriangle> triangles_;
    std::vector<std::uint32_t> first_, around_; // triangles around place v: around_[first_[v] … first_[v + 1])
    TriangleTree tree_;
    double least_ = 0; // so far
    bool found_ = false;
};

LobeSearch::LobeSearch(const Mesh& mesh) {
    ScaledPoints scaled = scaled_points(mesh, scaled_exponent);
    points_ = std::move(scaled.points);
    exponent_ = scaled.exponent;
    gather_triangles(mesh);
    gather_around();
    build_tree();
}

/// Triangles with two corners in one place are left out: they are no more than an edge of their neighbours.
void LobeSearch::gather_triangles(const Mesh& mesh) {
    const std::vector<std::uint32_t> places = number_places(points_);
    for (const glm::uvec3& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> at = {places[t.x], places[t.y], places[t.z]};
        if (at[0] != at[1] && at[1] != at[2] && at[2] != at[0])
            triangles_.push_back({at, {points_[t.x], points_[t.y], points_[t.z]}});
    }
}

void LobeSearch::gather_around() {
    first_.assign(points_.size() + 1, 0);
    for (const PlacedTriangle& triangle : triangles_)
        for (const std::uint32_t place : triangle.places) ++first_[place + 1];
    for (std::size_t place = 0; place < points_.size(); ++place) first_[place + 1] += first_[place];
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    around_.resize(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (const std::uint32_t place : triangles_[t].places) around_[fill[place]++] = t;
}

void LobeSearch::build_tree() {
    std::vector<TriangleTree::Item> items;
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

bool LobeSearch::share_place(std::uint32_t one, std::uint32_t other) const {
    const auto& places = triangles_[other].places;
    return std::any_of(triangles_[one].places.begin(), triangles_[one].places.end(), [&](std::uint32_t place) {
        return std::find(places.begin(), places.end(), place) != places.end();
    });
}

std::optional<double> LobeSearch::smallest(double within, const Progress& progress) {
    Ticker ticker(progress);
    least_ = std::min(std::ldexp(within, exponent_), std::ldexp(1.0, farthest_exponent));
    for (std::uint32_t one = 0; one < triangles_.size() && !ticker.cancelled(); ++one)
        tree_.any(box(one, least_), [&](std::uint32_t other) {
            if (other > one && !share_place(one, other)) look_at(one, other);
            return !ticker.tick(1, double(one) / double(triangles_.size()));
        });
    if (!found_ || ticker.cancelled()) return std::nullopt;
    return std::ldexp(least_, -exponent_);
}

void LobeSearch::look_at(std::uint32_t one, std::uint32_t other) {
    const NearestPoints nearest = nearest_points(triangles_[one].points, triangles_[other].points);
    if (!(nearest.squared_distance > 0) || nearest.squared_distance >= least_ * least_) return;
    if (!local_minimum(one, other, nearest)) return;
    least_ = std::sqrt(nearest.squared_distance);
    found_ = true;
}

/// The triangles that have all the corners of a part of this one.
std::vector<std::uint32_t> LobeSearch::holding(std::uint32_t triangle, unsigned part) const {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < 3; ++i)
        if (part >> i & 1) corners.push_back(triangles_[triangle].places[i]);
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = first_[corners[0]]; n < first_[corners[0] + 1]; ++n) {
        const auto& places = triangles_[around_[n]].places;
        const bool has_all = std::all_of(corners.begin(), corners.end(), [&](std::uint32_t corner) {
            return std::find(places.begin(), places.end(), corner) != places.end();
        });
        if (has_all) found.push_back(around_[n]);
    }
    return found;
}

/// On two triangles, which are convex, a local minimum of the distance is the smallest distance. So the nearest points are a
/// local minimum on the surface where no two of the triangles that hold them come nearer.
bool LobeSearch::local_minimum(std::uint32_t one, std::uint32_t other, const NearestPoints& nearest) const {
    const std::vector<std::uint32_t> ones = holding(one, nearest.one), others = holding(other, nearest.other);
    const double least = nearest.squared_distance * (1 - same_distance);
    for (const std::uint32_t p : ones)
        for (const std::uint32_t q : others) {
            if (share_place(p, q) || pierce(triangles_[p], triangles_[q])) return false;
            if (nearest_points(triangles_[p].points, triangles_[q].points).squared_distance < least) return false;
        }
    return true;
}

} // namespace

std::optional<double> feature_size(const Mesh& mesh, double within, const Progress& progress) {
    return LobeSearch(mesh).smallest(within, progress);
}

} // namespace meshbound
