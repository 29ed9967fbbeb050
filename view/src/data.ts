// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The arrays of a run apart from its frames: series, base and fields, as far as they are there.

import type { App } from "./app";
import { fieldGrid } from "./field-grid";
import { AnswerError } from "./source";

export async function loadData(app: App): Promise<void> {
  const { has } = app.run;
  const read = async (there: boolean, name: "series" | "base" | "fields"): Promise<void> => {
    if (!there) return;
    try {
      const answer = await app.source.arrays(app.prefix + name);
      if (app.signal.aborted) return;
      if (name === "fields") app.fields = fieldGrid(answer);
      else app[name] = answer;
      app.notices.clear(name);
    } catch (error) {
      // 404 says that it is not there, which is no trouble: a packing without forces has no fields.
      if (!(error instanceof AnswerError && error.status === 404)) app.notices.problem(name, error);
    }
  };
  await Promise.all([read(has.series, "series"), read(has.base, "base"), read(has.fields, "fields")]);
  if (!app.signal.aborted) app.emit("data");
}
