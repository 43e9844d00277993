#pragma once

#include <glm/vec2.hpp>

#include "metric/bounded_rows.hpp"

namespace meshbound {

/// Dot products of u, v and w: they give the squared length of w − x u − y v, a quadratic in x and y.
template <class Number>
struct Products {
    Number uu{}, uv{}, vv{}, uw{}, vw{}, ww{};
};

struct PlaneProducts : Products<double> {
    double squared_at(const glm::dvec2& parameters) const {
        return ww + parameters.x * (parameters.x * uu + 2 * (parameters.y * uv - uw)) +
               parameters.y * (parameters.y * vv - 2 * vw);
    }

    /// Adds the products of another variable, `weight` times.
    void add(const PlaneProducts& other, double weight) {
        uu += weight * other.uu;
        uv += weight * other.uv;
        vv += weight * other.vv;
        uw += weight * other.uw;
        vw += weight * other.vw;
        ww += weight * other.ww;
    }
};

/// One lane of each of the three rows.
struct PlaneLanes {
    Lane u, v, w;
};

/// Products of rows, summed up lane by lane.
struct LaneProducts : Products<Lane> {
    void add(const PlaneLanes& lanes) {
        const auto& [u, v, w] = lanes;
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
        ww += w * w;
    }

    /// Of the components in one half of the lanes.
    PlaneProducts half(int i) const { return {{uu[i], uv[i], vv[i], uw[i], vw[i], ww[i]}}; }

    PlaneProducts total() const {
        PlaneProducts both = half(0);
        both.add(half(1), 1);
        return both;
    }
};

} // namespace meshbound
