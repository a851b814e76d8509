// SPDX-License-Identifier: MIT
#pragma once

#include <sspql/learn/q_table.hpp>
#include <sspql/learn/transition.hpp>

namespace sspql {

/// Q(s,a) += alpha [r + gamma max_a' Q(s',a') - Q(s,a)] (eq. 1), the maximum over the legal actions of s'; 0 instead of
/// the maximum if the step terminated. O(|A|).
///
/// Deviation: Algorithm 2 line 7 prints Q(s',a) on the left; s is the state before the action, as in eq. 1.
template <class LegalActions>
[[gnu::always_inline]] inline void q_update(QTable& q, const Transition& t, double alpha, double gamma,
                                            const LegalActions& legal) {
    const double future = t.terminated ? 0.0 : gamma * q.legal_max(t.next, legal);
    double& value = q(t.state, t.action);
    value += alpha * (t.reward + future - value);
}

}  // namespace sspql
