// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// A run that is still written: what has changed is read again, at most about once a second.

import type { Run } from "./api";
import type { App } from "./app";
import { loadData } from "./data";

export function followRun(app: App): void {
  let due = false;
  let reading = false;
  let last = 0;

  async function read(): Promise<void> {
    due = true;
    if (reading) return;
    reading = true;
    try {
      while (due && !app.signal.aborted) {
        const wait = last + 700 - performance.now();
        if (wait > 0) await new Promise((done) => window.setTimeout(done, wait));
        due = false;
        last = performance.now();
        await refresh(app);
      }
    } finally {
      reading = false;
    }
  }

  const stop = app.source.listen(`${app.prefix}events`, {
    change: () => void read(),
    gone: () => app.notices.say("gone", "The folder of this run has gone. What is loaded can still be viewed.", "banner"),
    connected: (there) => {
      if (there) app.notices.clear("connection");
      else app.notices.say("connection", "The connection to the program is lost; trying again.", "banner");
    },
    absent: () => {
      const timer = window.setInterval(() => app.run.status === "running" && void read(), 5000);
      app.signal.addEventListener("abort", () => window.clearInterval(timer));
    },
  });
  if (stop) app.signal.addEventListener("abort", stop);
}

async function refresh(app: App): Promise<void> {
  try {
    const before = app.run;
    app.run = await app.source.json<Run>(`${app.prefix}run`);
    if (app.signal.aborted) return;
    app.notices.clear("run");
    // Another run in the same folder, which began again.
    if (app.run.time < before.time || app.run.frames.length < before.frames.length) app.frames.clear();
    if (app.run.time !== before.time || app.run.status !== before.status || app.run.frames.length !== before.frames.length) {
      app.frames.drop(app.lastKey());
    }
    app.emit("run");
    await Promise.all([app.show(), loadData(app)]);
  } catch (error) {
    app.notices.problem("run", error);
  }
}
