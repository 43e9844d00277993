#pragma once

#include "errors/error_model.hpp"
#include "metric/bounded_rows.hpp"

namespace meshbound {

/// The running maximum of the errors of a removal.
class WorstError {
public:
    /// `relocation_threshold`: see Tracking.
    WorstError(const BoundedRows& rows, double squared_limit, double relocation_threshold)
        : rows_(rows), squared_limit_(squared_limit),
          squared_threshold_(relocation_threshold * relocation_threshold * squared_limit) {}

    /// Vertex images and crossings with no larger error stay where the layout puts them.
    double squared_threshold() const { return squared_threshold_; }
    const RemovalError& measured() const { return measured_; }

    /// Includes an error; false when it is above the limit. `find_difference()` gives its difference of rows; it is
    /// called for few.
    template <class FindDifference>
    bool include(double squared_error, const FindDifference& find_difference) {
        if (squared_error <= measured_.squared_ratio) return true;
        measured_.squared_ratio = squared_error;
        if (squared_error <= squared_limit_) return true;
        measured_.variable = rows_.worst_variable(find_difference());
        return false;
    }

private:
    const BoundedRows& rows_;
    double squared_limit_, squared_threshold_;
    RemovalError measured_;
};

} // namespace meshbound
