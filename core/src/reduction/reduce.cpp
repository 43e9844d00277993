#include "meshbound/reduce.hpp"

#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "meshbound/validate.hpp"
#include "metric/bound_multiplier.hpp"
#include "reduction/check_options.hpp"
#include "reduction/feature_limit.hpp"
#include "reduction/reduction_run.hpp"
#include "util/out_of_memory.hpp"
#include "util/progress_reporter.hpp"

namespace meshbound {
namespace {

Status check_checkpoint_is_passed(const Options& options, const Checkpoint* checkpoint) {
    if (!checkpoint || options.sweeps.size() > 1) return {};
    return {Fault::bad_option, "One sweep passes no checkpoint; there must be two at least.", "", {}};
}

} // namespace

Status reduce(const Mesh& mesh, const Bounds& bounds, const Options& options, Reduction& reduction,
              const Progress& progress, Checkpoint* checkpoint) {
    try {
        ProgressReporter reporter(progress);
        MeshDefects defects;
        if (Status status = validate(mesh, &defects); !status.ok()) return status;
        std::vector<std::vector<ResolvedBound>> resolved(1);
        if (Status status = resolve_bounds(mesh, bounds, resolved[0]); !status.ok()) return status;
        if (Status status = check_options(mesh, options); !status.ok()) return status;
        if (Status status = check_feature_limit(resolved[0], options); !status.ok()) return status;
        if (Status status = check_small_parts(resolved[0], options); !status.ok()) return status;
        if (Status status = check_checkpoint_is_passed(options, checkpoint); !status.ok()) return status;
        if (Status status = check_focus(mesh, resolved[0], options); !status.ok()) return status;
        reporter.poll();
        std::optional<double> feature;
        if (Status status = limit_to_feature_size(mesh, options, resolved, feature, reporter); !status.ok())
            return status;
        Checkpoint passed;
        reduction =
            ReductionRun(mesh, options, defects, reporter).finish_within(resolved[0], checkpoint ? &passed : nullptr);
        reduction.report.feature_size = feature;
        if (!passed.vertices.empty()) {
            passed.report.feature_size = feature;
            *checkpoint = std::move(passed);
        }
        reporter.finish();
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("reducing", mesh.triangles.size());
    }
}

} // namespace meshbound
