#include "meshbound/verify.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "util/out_of_memory.hpp"
#include "util/progress_reporter.hpp"
#include "verify/check_comparable.hpp"
#include "verify/farthest_sample.hpp"
#include "verify/joint_surface.hpp"

namespace meshbound {
namespace {

using namespace verification;

class Comparison {
public:
    Comparison(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
               const VerifyOptions& options, const Progress& progress)
        : original_(original), reduced_(reduced), options_(options), space_(joint_space(original, bounds)),
          reporter_(progress) {}

    Verdict run() {
        compare_surfaces();
        if (reporter_.poll()) compare_boundaries();
        verdict_.cancelled = reporter_.cancelled();
        reporter_.finish();
        return verdict_;
    }

private:
    void compare_surfaces() {
        JointSurface one = joint_surface(original_, space_);
        const JointSurface other = joint_surface(reduced_, space_);
        one.multipliers = options_.multipliers;
        verdict_.surface = judge(one, other, options_.samples, {0, share_of_surfaces});
    }

    void compare_boundaries() {
        JointSurface one = joint_boundary(original_, space_);
        const JointSurface other = joint_boundary(reduced_, space_);
        one.multipliers = options_.multipliers;
        if (one.triangles.empty() && other.triangles.empty()) return;
        if (one.triangles.empty() || other.triangles.empty())
            verdict_.boundary.from_original.ratio = std::numeric_limits<double>::infinity();
        else verdict_.boundary = judge(one, other, options_.boundary_samples, {share_of_surfaces, 1});
    }

    Judgement judge(const JointSurface& one, const JointSurface& other, std::size_t samples, ShareOfWork share) {
        const double middle = (share.from + share.to) / 2;
        Judgement judgement;
        judgement.from_original = farthest(original_, one, other, samples, {share.from, middle});
        if (reporter_.poll()) judgement.from_reduced = farthest(reduced_, other, one, samples, {middle, share.to});
        return judgement;
    }

    Deviation farthest(const Mesh& mesh, const JointSurface& from, const JointSurface& to, std::size_t samples,
                       ShareOfWork share) {
        FarthestSample search(from, to, space_);
        Deviation deviation = search.find(samples, share, reporter_);
        const auto& triangle = from.triangles[deviation.triangle];
        for (int c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < 3; ++i)
                deviation.position[static_cast<std::size_t>(c)] +=
                    deviation.barycentric[i] * value_at(mesh.position, triangle[i], c);
        return deviation;
    }

    /// Of the work; boundaries mostly are short.
    static constexpr double share_of_surfaces = 0.9;

    const Mesh &original_, &reduced_;
    const VerifyOptions& options_;
    JointSpace space_;
    ProgressReporter reporter_;
    Verdict verdict_;
};

bool all_free(const std::vector<double>& bounds) {
    return std::all_of(bounds.begin(), bounds.end(),
                       [](double bound) { return bound > std::numeric_limits<double>::max(); });
}

} // namespace

Status verify(const Mesh& original, const Mesh& reduced, const std::vector<double>& bounds,
              const VerifyOptions& options, Verdict& verdict, const Progress& progress) {
    try {
        if (Status status = check_comparable(original, reduced, bounds, options); !status.ok()) return status;
        if (all_free(bounds)) verdict = {};
        else verdict = Comparison(original, reduced, bounds, options, progress).run();
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("verifying", original.triangles.size());
    }
}

} // namespace meshbound
