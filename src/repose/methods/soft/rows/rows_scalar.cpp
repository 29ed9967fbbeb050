// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#define REPOSE_SCALAR_ROWS
#include "repose/methods/soft/fused_laws.hpp"
#include "repose/methods/soft/rows/row_kernel.hpp"

namespace repose::soft {

template <int D, class Law>
void sweep_rows_scalar(RowSweep<D, Law>& sweep) {
  sweep_member(sweep);
}

template <int D, class Law>
void compute_edges(RowSweep<D, Law>& sweep) {
  RowSweep<D, Law> one = sweep;
  for (std::size_t e = 0; e < sweep.edge_count; ++e) {
    auto& edge = sweep.edges[e];
    edge.slip = sweep.slip[edge.pair];
    one.first = &edge.first;
    one.second = &edge.second;
    one.slip = &edge.slip;
    push_packs(one, 0, 1, &edge.push);
  }
}

#define REPOSE_INSTANTIATE(D, Law)                    \
  template void sweep_rows_scalar(RowSweep<D, Law>&); \
  template void compute_edges(RowSweep<D, Law>&);
REPOSE_FOR_FUSED_LAWS(REPOSE_INSTANTIATE)

}  // namespace repose::soft
