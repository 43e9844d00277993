#include "tracking.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "layout.hpp"

namespace meshbound {
namespace {

/// Places whose error is below this fraction of the limit are left where the layout puts them: looking further costs time and
/// makes folds in the map for nothing.
constexpr double content_with = 0.3;

/// Neighbouring crossings stay apart on their original edge by at least this share of the room that is left there: at one place
/// Φ would open it into a segment, and be a map only in the limit.
constexpr double least_gap = 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double cross(const glm::dvec2& p, const glm::dvec2& q) { return p.x * q.y - p.y * q.x; }

/// Clamped to [low, high]; NaN, from a degenerate crossing, becomes low.
double clamped(double x, double low, double high) { return x > low ? std::min(x, high) : low; }

} // namespace

Tracking::Tracking(const Rows& rows, const Surface& surface, const Options& options)
    : rows_(&rows), measured_rows_(rows, surface.vertex_count()), surface_(&surface), options_(options),
      edges_(surface), crossings_(surface.edge_count()), residents_(surface), content_(surface), cost_(measured_rows_) {
}

void Tracking::enter(const Hole& hole) {
    hole_ = &hole;
    content_.enter(*rows_, *surface_, residents_, hole);
    cost_.enter(hole, content_);
}

std::size_t Tracking::work() const { return 1 + content_.vertices().size() / 8; }

/// Places are places, whatever errors are measured in.
void Tracking::measure_in(const Rows& rows) {
    rows_ = &rows;
    measured_rows_ = MeasuredRows(rows, surface_->vertex_count());
}

const double* Tracking::ring_row(int i) const { return measured_rows_[hole_->ring[at(i)]]; }

void Tracking::index_tree(const Retriangulation& retriangulation) {
    depth_.clear();
    at_rim_.assign(at(hole_->size()), 0); // the last one, of the closing edge of an open hole, is the root's too
    joints_.clear();
    for (const NewTriangle& triangle : retriangulation.triangles) {
        const int n = static_cast<int>(depth_.size());
        depth_.push_back(triangle.parent < 0 ? 0 : depth_[at(triangle.parent)] + 1);
        if (triangle.left < 0) at_rim_[at(triangle.a)] = n;
        if (triangle.right < 0) at_rim_[at(triangle.m)] = n;
        joints_.emplace_back(measured_rows_, ring_row(triangle.a), ring_row(triangle.m), ring_row(triangle.b));
    }
}

Measured Tracking::measure(const Retriangulation& retriangulation, double squared_limit) {
    measured_ = {};
    index_tree(retriangulation);
    if (!settle_vertices(retriangulation, squared_limit)) return measured_;
    content_.find_pieces(edges_, crossings_, *hole_);
    lay_pieces(retriangulation, squared_limit);
    return measured_;
}

/// Takes an error into account; false when it is above the limit.
template <class Difference>
bool Tracking::record(double squared_error, const Difference& difference, double squared_limit) {
    if (squared_error <= measured_.squared_ratio) return true;
    measured_.squared_ratio = squared_error;
    if (squared_error <= squared_limit) return true;
    measured_.variable = measured_rows_.worst_variable(difference);
    return false;
}

bool Tracking::settle_vertices(const Retriangulation& retriangulation, double squared_limit) {
    settlements_.clear();
    places_.clear();
    for (const InnerVertex& inner : content_.vertices()) {
        Settlement settlement = locate(retriangulation, inner);
        if (inner.host != InnerVertex::Host::rim) {
            const double* row = measured_rows_[inner.vertex];
            double error = joints_[at(settlement.triangle)].squared_ratio(measured_rows_, row, settlement.weight);
            if (options_.choose_places && error > content_with * content_with * squared_limit) {
                if (inner.host == InnerVertex::Host::triangle) choose_place(row, settlement, error);
                else choose_share(row, settlement, error);
            }
            const JointTriangle& joint = joints_[at(settlement.triangle)];
            const glm::dvec3& w = settlement.weight;
            if (!record(error, MeasuredRows::blend_difference(row, joint.a(), joint.b(), joint.c(), w.x, w.y, w.z),
                        squared_limit))
                return false;
        }
        const NewTriangle* triangle = &retriangulation.triangles[at(settlement.triangle)];
        settlements_.push_back(settlement);
        places_.push_back(settlement.weight.x * hole_->places[at(triangle->a)] +
                          settlement.weight.y * hole_->places[at(triangle->m)] +
                          settlement.weight.z * hole_->places[at(triangle->b)]);
    }
    return true;
}

/// The new triangle in which an inner vertex lies, down the tree from the root; clamped where it lies in none.
Tracking::Settlement Tracking::locate(const Retriangulation& retriangulation, const InnerVertex& inner) const {
    const std::vector<glm::dvec2>& ring = hole_->places;
    if (inner.host == InnerVertex::Host::closing) return {0, {1 - inner.share, 0, inner.share}};
    int n = inner.host == InnerVertex::Host::rim ? at_rim_[at(inner.rim)] : 0;
    while (inner.host == InnerVertex::Host::triangle) {
        const NewTriangle& triangle = retriangulation.triangles[at(n)];
        const glm::dvec2 &a = ring[at(triangle.a)], &m = ring[at(triangle.m)], &b = ring[at(triangle.b)];
        if (triangle.left >= 0 && orientation(a, m, inner.place) < 0) n = triangle.left;
        else if (triangle.right >= 0 && orientation(m, b, inner.place) < 0) n = triangle.right;
        else break;
    }
    const NewTriangle& triangle = retriangulation.triangles[at(n)];
    return {n, clamped_barycentric(inner.place, ring[at(triangle.a)], ring[at(triangle.m)], ring[at(triangle.b)])};
}

/// The freedom of Φ: any place in any triangle of the hole is valid, so the one with the smallest error is taken.
void Tracking::choose_place(const double* row, Settlement& settlement, double& error) const {
    for (std::size_t n = 0; n < joints_.size(); ++n) {
        const glm::dvec3 weight = joints_[n].nearest(measured_rows_, row);
        const double here = joints_[n].squared_ratio(measured_rows_, row, weight);
        if (!(here < error)) continue;
        error = here;
        settlement = {static_cast<int>(n), weight};
    }
}

/// The same on the closing edge, which is the root's edge from a to c.
void Tracking::choose_share(const double* row, Settlement& settlement, double& error) const {
    const JointTriangle& root = joints_.front();
    const double share = nearest_parameters(measured_rows_, {row, row}, 0, 0, {root.a(), root.c()}).y;
    const glm::dvec3 weight(1 - share, 0, share);
    const double here = root.squared_ratio(measured_rows_, row, weight);
    if (!(here < error)) return;
    error = here;
    settlement.weight = weight;
}

bool Tracking::lay_pieces(const Retriangulation& retriangulation, double squared_limit) {
    new_crossings_.clear();
    piece_start_.clear();
    for (const Piece& piece : content_.pieces()) {
        piece_start_.push_back(new_crossings_.size());
        if (!lay_piece(retriangulation, piece, squared_limit)) return false;
    }
    piece_start_.push_back(new_crossings_.size());
    return true;
}

/// The triangle at which the path of a piece may begin or end. Of a ring vertex any of its triangles serves.
int Tracking::triangle_at(const PieceEnd& end) const {
    if (end.rim >= 0) return at_rim_[at(end.rim)];
    if (end.inner >= 0) return settlements_[at(end.inner)].triangle;
    return at_rim_[at(end.ring)];
}

glm::dvec2 Tracking::place_of(const PieceEnd& end) const {
    if (end.inner >= 0) return places_[at(end.inner)];
    if (end.ring >= 0) return hole_->places[at(end.ring)];
    const int i = end.rim, j = hole_->after(end.rim);
    const double t = crossings_[end.crossing].t;
    const double along = hole_->ring[at(i)] < hole_->ring[at(j)] ? t : 1 - t;
    return hole_->places[at(i)] + along * (hole_->places[at(j)] - hole_->places[at(i)]);
}

/// The diagonals between the triangles of the piece's two ends: the new triangles form a tree, so the path is unique.
/// Diagonals at a ring vertex where the piece begins or ends are not crossed.
void Tracking::find_path(const Retriangulation& retriangulation, const Piece& piece) {
    path_.clear();
    path_down_.clear();
    int from = triangle_at(piece.start), to = triangle_at(piece.end);
    while (from != to) {
        if (depth_[at(from)] >= depth_[at(to)]) {
            path_.push_back({from, 0, 0, false});
            from = retriangulation.triangles[at(from)].parent;
        } else {
            path_down_.push_back({to, 0, 0, true});
            to = retriangulation.triangles[at(to)].parent;
        }
    }
    path_.insert(path_.end(), path_down_.rbegin(), path_down_.rend());
    const auto touches = [&](const NewCrossing& crossing, int ring) {
        const NewTriangle& triangle = retriangulation.triangles[at(crossing.triangle)];
        return ring >= 0 && (triangle.a == ring || triangle.b == ring);
    };
    while (!path_.empty() && touches(path_.back(), piece.end.ring)) path_.pop_back();
    std::size_t leading = 0;
    while (leading < path_.size() && touches(path_[leading], piece.start.ring)) ++leading;
    path_.erase(path_.begin(), path_.begin() + static_cast<std::ptrdiff_t>(leading));
}

/// Crossings of the straight segment between the piece's ends with the diagonals on its path, each clamped into its
/// diagonal, in order along the piece: the order is all that the proof needs. A diagonal along the segment is crossed
/// wherever the two meet.
void Tracking::cross_straight(const Retriangulation& retriangulation, const Piece& piece, std::size_t first) {
    const glm::dvec2 start = place_of(piece.start), direction = place_of(piece.end) - start;
    double reached = 0;
    for (std::size_t n = first; n < new_crossings_.size(); ++n) {
        NewCrossing& crossing = new_crossings_[n];
        const NewTriangle& triangle = retriangulation.triangles[at(crossing.triangle)];
        const glm::dvec2 a = hole_->places[at(triangle.a)], along = hole_->places[at(triangle.b)] - a;
        const double denominator = cross(direction, along);
        const double meeting = denominator != 0 ? cross(a - start, along) / denominator
                                                : glm::dot(a - start, direction) / glm::dot(direction, direction);
        const double low = reached + least_gap * (1 - reached), high = 1 - least_gap * (1 - low);
        reached = clamped(meeting, low, high);
        crossing.t = clamped(glm::dot(start + reached * direction - a, along) / glm::dot(along, along), 0, 1);
        crossing.s = piece.start.s + reached * (piece.end.s - piece.start.s);
    }
}

auto Tracking::difference_at(const Piece& piece, const NewCrossing& crossing) const {
    const JointTriangle& joint = joints_[at(crossing.triangle)];
    return MeasuredRows::segment_difference(measured_rows_[edges_.lower(piece.original)],
                                            measured_rows_[edges_.upper(piece.original)], crossing.s, joint.a(),
                                            joint.c(), crossing.t);
}

double Tracking::error_at(const Piece& piece, const NewCrossing& crossing) const {
    return measured_rows_.squared_ratio(difference_at(piece, crossing));
}

/// The freedom of Φ: s may be anywhere between its neighbours on the original edge, t anywhere on the diagonal.
void Tracking::choose_crossings(const Piece& piece, std::size_t first, double threshold) {
    const JointSegment original{measured_rows_[edges_.lower(piece.original)],
                                measured_rows_[edges_.upper(piece.original)]};
    for (std::size_t n = first; n < new_crossings_.size(); ++n) {
        NewCrossing& crossing = new_crossings_[n];
        const double error = error_at(piece, crossing);
        if (error <= threshold) continue;
        const double before = n == first ? piece.start.s : new_crossings_[n - 1].s;
        const double behind = n + 1 == new_crossings_.size() ? piece.end.s : new_crossings_[n + 1].s;
        const double low = std::min(crossing.s, before + least_gap * (behind - before));
        const double high = std::max(crossing.s, behind - least_gap * (behind - before));
        const JointTriangle& joint = joints_[at(crossing.triangle)]; // the diagonal is its edge from a to c
        const glm::dvec2 nearest = nearest_parameters(measured_rows_, original, low, high, {joint.a(), joint.c()});
        NewCrossing chosen = crossing;
        chosen.s = nearest.x;
        chosen.t = nearest.y;
        if (error_at(piece, chosen) < error) crossing = chosen;
    }
}

bool Tracking::lay_piece(const Retriangulation& retriangulation, const Piece& piece, double squared_limit) {
    find_path(retriangulation, piece);
    const std::size_t first = new_crossings_.size();
    new_crossings_.insert(new_crossings_.end(), path_.begin(), path_.end());
    cross_straight(retriangulation, piece, first);
    if (options_.choose_crossings) choose_crossings(piece, first, content_with * content_with * squared_limit);
    for (std::size_t n = first; n < new_crossings_.size(); ++n)
        if (!record(error_at(piece, new_crossings_[n]), difference_at(piece, new_crossings_[n]), squared_limit))
            return false;
    return true;
}

void Tracking::commit(const Retriangulation& retriangulation) {
    for (const std::uint32_t slot : hole_->slots) residents_.clear_triangle(slot);
    for (const std::uint32_t edge : hole_->spoke_edges) {
        crossings_.clear(edge);
        residents_.clear_edge(edge);
    }
    for (std::size_t i = 0; i < settlements_.size(); ++i) {
        const InnerVertex& inner = content_.vertices()[i];
        const NewTriangle& triangle = retriangulation.triangles[at(settlements_[i].triangle)];
        if (inner.host == InnerVertex::Host::triangle) {
            residents_.settle_in_triangle(inner.vertex, triangle.slot, settlements_[i].weight);
        } else if (inner.host == InnerVertex::Host::closing) {
            const bool canonical = hole_->ring.front() < hole_->ring.back();
            residents_.settle_on_edge(inner.vertex, triangle.edge,
                                      canonical ? settlements_[i].weight.z : 1 - settlements_[i].weight.z);
        }
    }
    for (std::size_t p = 0; p < content_.pieces().size(); ++p) {
        const Piece& piece = content_.pieces()[p];
        std::uint32_t before = piece.start.crossing;
        for (std::size_t n = piece_start_[p]; n < piece_start_[p + 1]; ++n) {
            const NewCrossing& fresh = new_crossings_[n];
            const NewTriangle& triangle = retriangulation.triangles[at(fresh.triangle)];
            const bool canonical = hole_->ring[at(triangle.a)] < hole_->ring[at(triangle.b)];
            Crossing crossing;
            crossing.s = fresh.s;
            crossing.t = canonical ? fresh.t : 1 - fresh.t;
            crossing.original = piece.original;
            crossing.current = triangle.edge;
            crossing.rightward = fresh.into == canonical; // the triangle lies on the right of its diagonal a → b
            const std::uint32_t id = crossings_.add(crossing);
            crossings_.link(piece.original, before, id);
            before = id;
        }
        crossings_.link(piece.original, before, piece.end.crossing);
    }
}

/// Visits, as rows (original, reduced), every corner of the map that lies in a triangle: its residents and the crossings and
/// residents of its edges.
template <class Visit>
void Tracking::for_each_corner(std::uint32_t slot, const Visit& visit) const {
    std::vector<double> original(at(rows_->width())), reduced(at(rows_->width()));
    const double* corner[3];
    for (std::uint32_t i = 0; i < 3; ++i) corner[i] = (*rows_)[surface_->origin(3 * slot + i)];
    const auto mix = [&](std::vector<double>& out, const double* p, const double* q, double share) {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = p[i] + share * (q[i] - p[i]);
    };
    for (std::uint32_t v = residents_.in_triangle(slot); v != no_index; v = residents_.next(v)) {
        const glm::dvec3 w = residents_.barycentric(v);
        for (std::size_t i = 0; i < reduced.size(); ++i)
            reduced[i] = w.x * corner[0][i] + w.y * corner[1][i] + w.z * corner[2][i];
        visit((*rows_)[v], reduced.data());
    }
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) {
        const double* lower = (*rows_)[std::min(surface_->origin(h), surface_->target(h))];
        const double* upper = (*rows_)[std::max(surface_->origin(h), surface_->target(h))];
        for (std::uint32_t v = residents_.on_edge(surface_->edge(h)); v != no_index; v = residents_.next(v)) {
            mix(reduced, lower, upper, residents_.share(v));
            visit((*rows_)[v], reduced.data());
        }
        for (std::uint32_t id = crossings_.on(surface_->edge(h)); id != no_index; id = crossings_[id].sibling) {
            const Crossing& crossing = crossings_[id];
            mix(original, (*rows_)[edges_.lower(crossing.original)], (*rows_)[edges_.upper(crossing.original)],
                crossing.s);
            mix(reduced, lower, upper, crossing.t);
            visit(original.data(), reduced.data());
        }
    }
}

void Tracking::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    ranges.assign(rows_->groups().size(), {});
    const auto position = [&](std::uint32_t i) { return rows_->position(surface_->origin(3 * slot + i)); };
    const glm::dvec3 area = glm::cross(position(1) - position(0), position(2) - position(0));
    const glm::dvec3 normal = glm::length(area) > 0 ? glm::normalize(area) : area;
    for_each_corner(slot, [&](const double* original, const double* reduced) {
        for (const RowGroup& group : rows_->groups()) {
            double square = 0, sign = 0;
            for (int i = group.first; i < group.first + group.count; ++i) {
                const double difference = original[i] - reduced[i];
                square += difference * difference;
                sign += group.variable == 0 ? -difference * normal[i] : difference;
            }
            ErrorRange& range = ranges[group.variable];
            range.largest = std::max(range.largest, std::sqrt(square));
            range.lowest = std::min(range.lowest, sign);
            range.highest = std::max(range.highest, sign);
        }
    });
}

} // namespace meshbound
