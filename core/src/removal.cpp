#include "removal.hpp"

namespace meshbound {

Removal::Removal(Surface& surface, const Rows& rows, Accounting& accounting)
    : surface_(surface), rows_(rows), accounting_(accounting), legality_(surface) {}

Verdict Removal::attempt(std::uint32_t candidate, double squared_limit) {
    gather_star(surface_, candidate, hole_);
    lay_out(rows_, hole_);
    if (!legality_.enter(surface_, rows_, hole_)) return {Refusal::topology};
    accounting_.enter(hole_);
    if (!retriangulator_.triangulate(rows_, hole_, legality_, accounting_.cost(), retriangulation_)) return {Refusal::fold};
    const Measured measured = accounting_.measure(retriangulation_, squared_limit);
    if (measured.squared_ratio > squared_limit) return {Refusal::bound, measured.squared_ratio, measured.variable};
    surface_.retriangulate(hole_, retriangulation_);
    accounting_.commit(retriangulation_);
    return {};
}

} // namespace meshbound
