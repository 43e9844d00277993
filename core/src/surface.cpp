#include "surface.hpp"

#include <algorithm>
#include <numeric>

#include "half_edge_runs.hpp"
#include "hole.hpp"

namespace meshbound {
Surface::Surface(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                 const std::vector<std::int32_t>& regions)
    : outgoing_(vertices, no_index), kind_(vertices, VertexKind::absent) {
    origin_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const glm::uvec3& triangle = triangles[t];
        if (triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x) continue;
        for (int corner = 0; corner < 3; ++corner) origin_.push_back(triangle[corner]);
        if (!regions.empty()) regions_.push_back(regions[t]);
    }
    pair_half_edges();
    std::size_t split = non_manifold_vertices_ = classify();
    if (!regions_.empty()) {
        cut_borders();
        split = classify();
    }
    if (split > 0) split_vertices();
}

void Surface::pair_half_edges() {
    twin_.assign(origin_.size(), no_index);
    edge_.assign(origin_.size(), no_index);
    HalfEdgeRuns(origin_, kind_.size()).for_each_edge([&](const std::uint32_t* run, std::size_t count) {
        if (count == 2 && origin(run[0]) != origin(run[1])) {
            pair(run[0], run[1]);
            return;
        }
        if (count == 2) ++discordant_edges_;
        for (std::size_t i = 0; i < count; ++i) edge_[run[i]] = static_cast<std::uint32_t>(edge_count_++);
    });
}

void Surface::pair(std::uint32_t h, std::uint32_t g) {
    twin_[h] = g;
    twin_[g] = h;
    edge_[h] = edge_[g] = static_cast<std::uint32_t>(edge_count_++);
}

/// Where labels differ, each side has an edge of its own.
void Surface::cut_borders() {
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
        const std::uint32_t g = twin_[h];
        if (g == no_index || regions_[triangle_of(g)] == regions_[triangle_of(h)]) continue;
        twin_[h] = twin_[g] = no_index;
        edge_[g] = static_cast<std::uint32_t>(edge_count_++);
    }
}

/// A vertex is interior or boundary when one walk around it meets all its triangles; a boundary walk starts where there is
/// no twin. Returns how many vertices have several fans.
std::size_t Surface::classify() {
    std::vector<std::uint32_t> valence(kind_.size(), 0);
    std::fill(outgoing_.begin(), outgoing_.end(), no_index);
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
        const std::uint32_t vertex = origin_[h];
        ++valence[vertex];
        if (outgoing_[vertex] == no_index || twin_[h] == no_index) outgoing_[vertex] = h;
    }
    std::size_t split = 0;
    for (std::uint32_t vertex = 0; vertex < kind_.size(); ++vertex) {
        if (valence[vertex] == 0) continue;
        const std::uint32_t start = outgoing_[vertex];
        split += fan_length(start) != valence[vertex];
        kind_[vertex] = twin_[start] == no_index ? VertexKind::boundary : VertexKind::interior;
    }
    return split;
}

std::uint32_t Surface::fan_length(std::uint32_t start) const {
    std::uint32_t length = 0, spoke = start;
    do {
        ++length;
        spoke = next_spoke(spoke);
    } while (spoke != no_index && spoke != start);
    return length;
}

/// Gives each fan a vertex of its own, in the order of the input's vertices and of the half-edges that they begin with.
void Surface::split_vertices() {
    struct Fan {
        std::uint32_t input, start;
    };
    std::vector<Fan> fans;
    std::vector<char> seen(origin_.size(), 0);
    const auto walk = [&](std::uint32_t start, const auto& visit) {
        std::uint32_t spoke = start;
        do {
            visit(spoke);
            spoke = next_spoke(spoke);
        } while (spoke != no_index && spoke != start);
    };
    for (const bool open : {true, false})
        for (std::uint32_t h = 0; h < origin_.size(); ++h) {
            if (seen[h] || (open && twin_[h] != no_index)) continue;
            fans.push_back({origin_[h], h});
            walk(h, [&](std::uint32_t spoke) { seen[spoke] = 1; });
        }
    for (std::uint32_t vertex = 0; vertex < kind_.size(); ++vertex)
        if (kind_[vertex] == VertexKind::absent) fans.push_back({vertex, no_index});
    std::sort(fans.begin(), fans.end(),
              [](const Fan& a, const Fan& b) { return a.input != b.input ? a.input < b.input : a.start < b.start; });
    first_copy_.assign(kind_.size(), no_index);
    kind_.assign(fans.size(), VertexKind::absent);
    outgoing_.assign(fans.size(), no_index);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> copies;
    for (std::uint32_t vertex = 0; vertex < fans.size(); ++vertex) {
        const auto [input, start] = fans[vertex];
        inputs_.push_back(input);
        if (first_copy_[input] == no_index) first_copy_[input] = vertex;
        else copies.emplace_back(first_copy_[input], vertex);
        if (start == no_index) continue;
        outgoing_[vertex] = start;
        kind_[vertex] = twin_[start] == no_index ? VertexKind::boundary : VertexKind::interior;
    }
    for (std::uint32_t vertex = 0; vertex < fans.size(); ++vertex)
        if (fans[vertex].start != no_index)
            walk(fans[vertex].start, [&](std::uint32_t spoke) { origin_[spoke] = vertex; });
    join_sites(copies);
}

void Surface::join_sites(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    if (pairs.empty()) return;
    if (sites_.empty()) {
        sites_.resize(kind_.size());
        std::iota(sites_.begin(), sites_.end(), 0U);
    }
    const auto name = [&](std::uint32_t vertex) {
        while (sites_[vertex] != vertex) vertex = sites_[vertex] = sites_[sites_[vertex]];
        return vertex;
    };
    for (const auto& [a, b] : pairs) {
        const std::uint32_t one = name(a), other = name(b);
        sites_[std::max(one, other)] = std::min(one, other);
    }
    next_in_site_.assign(kind_.size(), no_index);
    std::vector<std::uint32_t> last(kind_.size(), no_index);
    for (std::uint32_t vertex = 0; vertex < sites_.size(); ++vertex) {
        const std::uint32_t site = sites_[vertex] = name(vertex);
        if (last[site] != no_index) next_in_site_[last[site]] = vertex;
        last[site] = vertex;
    }
}

/// The spoke of a boundary vertex's last triangle, behind which its fan ends.
std::uint32_t Surface::last_in_fan(std::uint32_t vertex) const {
    std::uint32_t last = outgoing_[vertex];
    while (next_spoke(last) != no_index) last = next_spoke(last);
    return last;
}

bool Surface::is_closed() const { return std::find(kind_.begin(), kind_.end(), VertexKind::boundary) == kind_.end(); }

bool Surface::is_free(std::uint32_t vertex) const {
    if (kind_[vertex] == VertexKind::absent) return false;
    if (sites_.empty()) return true;
    std::uint32_t copies = 0, lower = no_index, upper = no_index; // the two neighbours on the curve
    bool alike = true, interior = false;
    for_each_in_site(vertex, [&](std::uint32_t copy) {
        ++copies;
        if (kind_[copy] != VertexKind::boundary) {
            interior = true;
            return;
        }
        const std::uint32_t one = site(target(outgoing_[copy])), other = site(origin(previous(last_in_fan(copy))));
        if (lower == no_index) lower = std::min(one, other), upper = std::max(one, other);
        alike = alike && one != other && lower == std::min(one, other) && upper == std::max(one, other);
    });
    return interior ? copies == 1 : alike;
}

bool Surface::triangle_exists(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    bool found = false;
    for_each_in_site(a, [&](std::uint32_t copy) {
        const std::uint32_t first = outgoing_[copy];
        std::uint32_t spoke = first;
        do {
            const std::uint32_t one = site(target(spoke)), other = site(origin(previous(spoke)));
            found = found || (one == site(b) && other == site(c)) || (one == site(c) && other == site(b));
            spoke = next_spoke(spoke);
        } while (spoke != no_index && spoke != first);
    });
    return found;
}

std::size_t Surface::drop(const std::vector<char>& vertices) {
    std::size_t triangles = 0;
    for (std::size_t slot = 0; slot < slot_count(); ++slot) {
        if (!vertices[origin_[3 * slot]]) continue;
        origin_[3 * slot] = no_index;
        ++triangles;
    }
    for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex) {
        if (!vertices[vertex]) continue;
        kind_[vertex] = VertexKind::absent;
        outgoing_[vertex] = no_index;
    }
    return triangles;
}

void Surface::attach(std::uint32_t h, const Rim& rim) {
    twin_[h] = rim.twin;
    edge_[h] = rim.edge;
    if (rim.twin != no_index) twin_[rim.twin] = h;
}

/// Takes the star out and leaves what lies behind its rims.
std::vector<Surface::Rim> Surface::take_out(const Hole& hole) {
    std::vector<Rim> rims;
    for (const std::uint32_t h : hole.rims) rims.push_back({twin_[h], edge_[h]});
    for (const std::uint32_t slot : hole.slots) origin_[3 * std::size_t(slot)] = no_index;
    kind_[hole.candidate] = VertexKind::absent;
    outgoing_[hole.candidate] = no_index;
    return rims;
}

/// Writes a new triangle, whose slot is chosen, and joins it to the rims around it.
void Surface::put_in(const Hole& hole, const NewTriangle& triangle, const std::vector<Rim>& rims) {
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const std::uint32_t h = 3 * triangle.slot; // h: a → m, h + 1: m → b, h + 2: b → a
    origin_[h] = hole.ring[at(triangle.a)];
    origin_[h + 1] = hole.ring[at(triangle.m)];
    origin_[h + 2] = hole.ring[at(triangle.b)];
    if (triangle.left < 0) attach(h, rims[at(triangle.a)]);
    if (triangle.right < 0) attach(h + 1, rims[at(triangle.m)]);
    if (triangle.parent < 0 && !hole.open) attach(h + 2, rims[at(triangle.b)]);
}

/// Gives a new triangle's edge (a, b), the diagonal to its parent or the closing edge, an edge of its own.
void Surface::join(const NewTriangle& triangle, const NewTriangle* parent) {
    const std::uint32_t h = 3 * triangle.slot + 2; // b → a
    edge_[h] = triangle.edge;
    twin_[h] = no_index;
    if (!parent) return;
    const std::uint32_t g = 3 * parent->slot + (parent->a == triangle.a ? 0 : 1);
    twin_[h] = g;
    twin_[g] = h;
    edge_[g] = triangle.edge;
}

/// Brings what is kept of the vertices up to date with a new triangle, all of them being joined.
void Surface::refresh_vertices(const NewTriangle& triangle) {
    for (std::uint32_t h = 3 * triangle.slot; h < 3 * triangle.slot + 3; ++h) {
        const std::uint32_t vertex = origin(h);
        if (kind_[vertex] == VertexKind::interior || twin_[h] == no_index) outgoing_[vertex] = h;
    }
}

void Surface::retriangulate(const Hole& hole, Retriangulation& retriangulation) {
    const std::vector<Rim> rims = take_out(hole);
    std::vector<NewTriangle>& fresh = retriangulation.triangles;
    std::size_t spare_edge = 0;
    for (std::size_t n = 0; n < fresh.size(); ++n) {
        NewTriangle& triangle = fresh[n];
        triangle.slot = hole.slots[n];
        put_in(hole, triangle, rims);
        if (triangle.parent < 0 && !hole.open) {
            triangle.edge = edge_[3 * triangle.slot + 2];
            continue;
        }
        triangle.edge = hole.spoke_edges[spare_edge++];
        join(triangle, triangle.parent < 0 ? nullptr : &fresh[static_cast<std::size_t>(triangle.parent)]);
    }
    for (const NewTriangle& triangle : fresh) refresh_vertices(triangle);
}

} // namespace meshbound
