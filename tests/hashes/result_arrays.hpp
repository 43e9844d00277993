#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/meshbound.hpp"

/// Everything that a result holds, as arrays with names: what comparisons of bytes go through. Whoever takes the arrays says
/// what becomes of them.
class ResultArrays {
public:
    virtual ~ResultArrays() = default;

    void mesh(const meshbound::Mesh& mesh);
    void reduction(const meshbound::Reduction& reduction);
    /// Of levels what a reduction has not: triangles, vertices, and the ends of the morphs.
    void levels(const meshbound::Levels& levels);
    void segmentation(const meshbound::Segmentation& segmentation);

private:
    /// One array: `count` numbers of a type called as JavaScript calls arrays of it.
    virtual void take(const std::string& name, const char* type, std::size_t count, const void* bytes,
                      std::size_t size) = 0;

    template <class T>
    void array(const std::string& name, const std::vector<T>& values);
    void array(const std::string& name, const meshbound::Values& values);
    void array(const std::string& name, const std::vector<glm::uvec3>& triangles);
    void map(const meshbound::SurfaceMap& map);
    void report(const meshbound::Report& report);
};
