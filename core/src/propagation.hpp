#pragma once

#include <vector>

#include "accounting.hpp"
#include "mapping.hpp"
#include "meshbound/options.hpp"

namespace meshbound {

/// The paper's accounting (§3.3.3, figure 6). Each triangle carries, for each component of the row and for the signed
/// distance, an interval [lowest, highest] that contains the signed error of every point that was ever mapped into it. A new
/// triangle gets, over all pieces that reach it, the old triangle's interval plus what the piece's corners introduce.
///
/// Beyond the paper: the displacement is propagated by components and bounded by the corner of its box, since a sum of
/// distances along normals that differ from step to step bounds nothing. The signed distance is kept as a diagnostic.
class Propagation final : public Accounting, private HoleCost {
public:
    Propagation(const Rows& rows, std::size_t slots, Cost cost);

    void enter(const Hole& hole) override;
    HoleCost& cost() override { return *this; }
    Measured measure(const Retriangulation& retriangulation, double squared_limit) override;
    void commit(const Retriangulation& retriangulation) override;
    std::size_t work() const override { return 1; }
    void measure_in(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

private:
    double diagonal(int i, int j) override;
    double triangle(int a, int m, int b) override;

    struct Interval {
        double lowest = 0, highest = 0;
        void include(const Interval& other);
        double magnitude() const;
    };

    void propagate(int a, int m, int b, Interval* fresh);
    void add_piece(int a, int m, int b, int sector, const double* candidate, Interval* fresh);
    Measured worst(const Interval* intervals) const;
    std::size_t width() const { return static_cast<std::size_t>(rows_->width()) + 1; }

    const Rows* rows_;
    Cost charged_;
    const Hole* hole_ = nullptr;
    StarMap map_;
    std::vector<Interval> intervals_; // [slot * width + component]
    std::vector<Interval> fresh_;     // the same for the new triangles of the removal measured last
    std::vector<Interval> introduced_;
};

} // namespace meshbound
