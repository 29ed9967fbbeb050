// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
#if defined(__AVX512F__)
#include "repose/methods/soft/fused_laws.hpp"
#include "repose/methods/soft/rows/row_kernel.hpp"

namespace repose::soft {

template <int D, class Law>
void sweep_rows_avx512(RowSweep<D, Law>& sweep) {
  sweep_member(sweep);
}

#define REPOSE_INSTANTIATE(D, Law) template void sweep_rows_avx512(RowSweep<D, Law>&);
REPOSE_FOR_FUSED_LAWS(REPOSE_INSTANTIATE)

}  // namespace repose::soft
#endif
