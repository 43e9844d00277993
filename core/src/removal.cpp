#include "removal.hpp"

namespace meshbound {

Removal::Removal(Surface& surface, const Rows& rows, Accounting& accounting, const Guards& guards)
    : surface_(surface), rows_(rows), accounting_(accounting.removals()), piercing_(guards.piercing),
      legality_(guards.normals, accounting_->minds_turns()) {}

Verdict Removal::attempt(std::uint32_t candidate, double squared_limit, Effort effort) {
    gather_star(surface_, candidate, hole_);
    lay_out(rows_, hole_);
    if (!legality_.enter(surface_, rows_, hole_)) return {Refusal::topology};
    accounting_->enter(hole_);
    if (!retriangulator_.triangulate(hole_, legality_, accounting_->cost(), retriangulation_)) return {Refusal::fold};
    Trial trial = try_out(squared_limit);
    if (!trial.accepted(squared_limit) && effort == Effort::thorough) trial = try_fans(squared_limit, trial);
    if (trial.accepted(squared_limit)) {
        take();
        return {};
    }
    if (trial.pierces) return {Refusal::piercing};
    return {Refusal::bound, trial.measured.squared_ratio, trial.measured.variable};
}

Removal::Trial Removal::try_out(double squared_limit) {
    Trial trial{accounting_->measure(retriangulation_, squared_limit)};
    trial.pierces = piercing_ && trial.accepted(squared_limit) && piercing_->pierces(hole_, retriangulation_);
    return trial;
}

/// The cheapest retriangulation is the best guess, not the only one within the bounds: the fans (what collapsing a spoke would
/// give) are few, and leave 2 % fewer triangles. Returns the first that is accepted, else what was refused.
Removal::Trial Removal::try_fans(double squared_limit, Trial refused) {
    for (int hub = 0; hub < hole_.size(); ++hub) {
        if (!retriangulator_.fan(hole_, legality_, hub, retriangulation_)) continue;
        const Trial trial = try_out(squared_limit);
        if (trial.accepted(squared_limit)) return trial;
        if (trial.measured.squared_ratio < refused.measured.squared_ratio) refused = trial;
    }
    return refused;
}

/// Takes what was tried out last.
void Removal::take() {
    surface_.retriangulate(hole_, retriangulation_);
    accounting_->commit(retriangulation_);
    if (piercing_) piercing_->change(hole_, retriangulation_);
}

} // namespace meshbound
