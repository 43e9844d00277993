#include "meshbound/reduce.hpp"

#include <new>
#include <string>

#include "check_options.hpp"
#include "focus.hpp"
#include "reduction_run.hpp"
#include "ticker.hpp"

namespace meshbound {

Status reduce(const Mesh& mesh, const Bounds& bounds, const Options& options, Reduction& reduction,
              const Progress& progress) {
    try {
        Ticker ticker(progress);
        Oddities oddities;
        if (Status status = validate(mesh, &oddities); !status.ok()) return status;
        std::vector<ResolvedBound> resolved;
        if (Status status = resolve_bounds(mesh, bounds, resolved); !status.ok()) return status;
        if (Status status = check_options(mesh, options); !status.ok()) return status;
        if (Status status = check_focus(mesh, resolved, options); !status.ok()) return status;
        ticker.ask();
        reduction = ReductionRun(mesh, options, oddities, ticker).reduce_within(resolved, {});
        ticker.finish();
        return {};
    } catch (const std::bad_alloc&) {
        return {Fault::out_of_memory,
                "There is no memory left for reducing " + std::to_string(mesh.triangles.size()) + " triangles.",
                "",
                {}};
    }
}

} // namespace meshbound
