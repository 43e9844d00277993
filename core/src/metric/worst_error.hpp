#pragma once

#include "errors/accounting.hpp"
#include "metric/measured_rows.hpp"

namespace meshbound {

/// The worst of the errors of a removal, as they are met.
class WorstError {
public:
    /// `content_with`: see Tracking.
    WorstError(const MeasuredRows& rows, double squared_limit, double content_with)
        : rows_(rows), squared_limit_(squared_limit), squared_content_(content_with * content_with * squared_limit) {}

    /// What has no larger error stays where the layout puts it.
    double squared_content() const { return squared_content_; }
    const Measured& measured() const { return measured_; }

    /// Takes an error into account; false when it is above the limit. `find_difference()` gives the difference of rows that it
    /// belongs to, which few are asked for.
    template <class FindDifference>
    bool take(double squared_error, const FindDifference& find_difference) {
        if (squared_error <= measured_.squared_ratio) return true;
        measured_.squared_ratio = squared_error;
        if (squared_error <= squared_limit_) return true;
        measured_.variable = rows_.worst_variable(find_difference());
        return false;
    }

private:
    const MeasuredRows& rows_;
    double squared_limit_, squared_content_;
    Measured measured_;
};

} // namespace meshbound
