// Uses something of every public function, so that one that a shared library hides is missed.
#include <iostream>

#include <meshbound/meshbound.hpp>

namespace {

using namespace meshbound;

Mesh plate() {
    Mesh mesh;
    mesh.position.values =
        std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 0, 2, 0, 1, 2, 0, 2, 2, 0};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}};
    return mesh;
}

} // namespace

int main() {
    const Mesh mesh = plate();
    const Bounds bounds = {{"*", relative(0.01)}};
    MeshDefects defects;
    std::vector<ResolvedBound> resolved;
    if (!validate(mesh, &defects).ok() || !resolve_bounds(mesh, bounds, resolved).ok()) return 1;
    find_flipped_triangles(mesh, defects);

    Reduction reduction;
    Checkpoint checkpoint;
    if (const Status status = reduce(mesh, bounds, {}, reduction, {}, &checkpoint); !status.ok()) {
        std::cerr << fault_name(status.fault) << ": " << status.message << '\n';
        return 1;
    }
    Verdict verdict;
    if (!verify(mesh, reduction.mesh, {resolved[0].absolute}, {}, verdict).ok() || !verdict.within_bounds()) return 1;

    Reduction onward;
    if (!resume_reduction(checkpoint, {{"*", relative(0.1)}}, {}, onward).ok()) return 1;

    Levels levels;
    if (!reduce_levels(mesh, {bounds}, {}, levels).ok()) return 1;
    const MappedSurfaces surfaces{mesh, reduction};
    Segmentation segmentation;
    Morph morph;
    if (!segment(surfaces, segmentation).ok() || !make_morph(surfaces, morph).ok()) return 1;
    const SegmentationCell& cell = segmentation.cells.front();
    const std::uint32_t corner = segmentation.corners.front();
    const double sum = glm::dvec3(barycentric_in_original(surfaces, cell, corner)).x +
                       barycentric_in_reduced(surfaces, cell, corner).x;

    const bool sound = morphed(morph, 0.5).triangles.size() >= reduction.mesh.triangles.size() && sum >= 0 &&
                       !feature_size(mesh, 1).has_value() && value_count(gather(mesh.position, {0, 1})) == 6 &&
                       value_at(mesh.position, vertex_count(mesh) - 1, 0) == 2;
    std::cout << MESHBOUND_VERSION << ": " << reduction.report.triangles_before << " to "
              << reduction.report.triangles_after << (sound ? "" : ", but something is wrong") << '\n';
    return sound ? 0 : 1;
}
