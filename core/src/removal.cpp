#include "removal.hpp"

namespace meshbound {

Removal::Removal(Surface& surface, const Rows& rows, Accounting& accounting)
    : surface_(surface), rows_(rows), accounting_(accounting.removals()), legality_(accounting_->minds_turns()) {}

Verdict Removal::attempt(std::uint32_t candidate, double squared_limit, Effort effort) {
    gather_star(surface_, candidate, hole_);
    lay_out(rows_, hole_);
    if (!legality_.enter(surface_, rows_, hole_)) return {Refusal::topology};
    accounting_->enter(hole_);
    if (!retriangulator_.triangulate(hole_, legality_, accounting_->cost(), retriangulation_)) return {Refusal::fold};
    Measured measured = accounting_->measure(retriangulation_, squared_limit);
    if (measured.squared_ratio > squared_limit && effort == Effort::thorough)
        measured = try_fans(squared_limit, measured);
    if (measured.squared_ratio > squared_limit) return {Refusal::bound, measured.squared_ratio, measured.variable};
    surface_.retriangulate(hole_, retriangulation_);
    accounting_->commit(retriangulation_);
    return {};
}

/// The cheapest retriangulation is the best guess, not the only one within the bounds: the fans (what collapsing a spoke would
/// give) are few, and leave 2 % fewer triangles. Returns the first that stays within the limit, else what was refused.
Measured Removal::try_fans(double squared_limit, Measured refused) {
    for (int hub = 0; hub < hole_.size(); ++hub) {
        if (!retriangulator_.fan(hole_, legality_, hub, retriangulation_)) continue;
        const Measured measured = accounting_->measure(retriangulation_, squared_limit);
        if (measured.squared_ratio <= squared_limit) return measured;
        if (measured.squared_ratio < refused.squared_ratio) refused = measured;
    }
    return refused;
}

} // namespace meshbound
