#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshbound/verify.hpp"
#include "util/progress_reporter.hpp"
#include "verify/joint_distance.hpp"
#include "verify/joint_surface.hpp"
#include "verify/joint_tree.hpp"
#include "verify/sampling.hpp"

namespace meshbound::verification {

/// Which part of the whole work a search is, for its progress.
struct ShareOfWork {
    double from, to; ///< 0…1
};

/// Looks from samples of one surface for the nearest point of another. Both have triangles and must outlive it.
class FarthestSample {
public:
    FarthestSample(const JointSurface& from, const JointSurface& to, const JointSpace& space);

    /// The sample that is farthest, of about `samples`; of those looked at so far where `reporter` cancels.
    const Deviation& find(std::size_t samples, ShareOfWork share, ProgressReporter& reporter);

private:
    void look_at(const Sample& sample);
    std::size_t farthest_variable(const Foot& foot);

    const JointSurface &from_, &to_;
    const JointSpace& space_;
    JointTree tree_;
    JointDistance metric_;
    std::vector<double> point_, foot_point_;
    Deviation worst_;
    std::uint32_t last_ = 0; ///< neighbouring samples mostly end on the same triangle
};

} // namespace meshbound::verification
