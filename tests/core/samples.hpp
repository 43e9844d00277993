#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "meshbound/mesh.hpp"
#include "meshes/ply.hpp"

/// Skips a test that finds no sample. In continuous integration (CI in the environment) it fails: the build has made them.
inline void miss_samples() {
    if (std::getenv("CI")) FAIL() << "no samples: npm run build makes them";
    GTEST_SKIP() << "no samples: npm run build makes some, MESHBOUND_DATA names more";
}

/// Calls `visit(mesh)` for each sample surface of at most so many triangles; misses them where there is none.
template <class Visit>
void for_each_sample(std::size_t most_triangles, const Visit& visit) {
    std::size_t visited = 0;
    for (const std::string& file : meshes::sample_files()) {
        const meshbound::Mesh mesh = meshes::read_ply(file);
        if (mesh.triangles.size() > most_triangles) continue;
        SCOPED_TRACE(file);
        ++visited;
        visit(mesh);
    }
    if (visited == 0) miss_samples();
}
