// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Where answers come from: the server of `repose view`, or the page itself if it was exported.

import type { Change } from "./api";
import { decodeArrays, type Arrays } from "./arrays";

export interface Listener {
  change(change: Change): void;
  gone(): void;
  /** The connection: false while it is lost and tried again. */
  connected(there: boolean): void;
  /** The server has no events at this address: ask again from time to time instead. */
  absent(): void;
}

export interface Source {
  /** `address` as in view.md: "api/run". */
  json<T>(address: string): Promise<T>;
  arrays(address: string): Promise<Arrays>;
  /** Calls the listener on each change; returns what ends it. Null where nothing can change. */
  listen(address: string, listener: Listener): (() => void) | null;
}

/** An answer with a status other than 200: 404 is "not there". */
export class AnswerError extends Error {
  constructor(readonly status: number, text: string) {
    super(text);
  }
}

export class HttpSource implements Source {
  async json<T>(address: string): Promise<T> {
    return (await (await this.get(address)).json()) as T;
  }

  async arrays(address: string): Promise<Arrays> {
    return decodeArrays(await (await this.get(address)).arrayBuffer());
  }

  listen(address: string, listener: Listener): () => void {
    const events = new EventSource(address);
    let opened = false;
    events.addEventListener("open", () => {
      opened = true;
      listener.connected(true);
    });
    events.addEventListener("change", (event) => listener.change(JSON.parse((event as MessageEvent<string>).data) as Change));
    events.addEventListener("gone", () => {
      events.close();
      listener.gone();
    });
    let again = 0;
    events.addEventListener("error", () => {
      const closed = events.readyState === EventSource.CLOSED;
      if (closed && !opened) return listener.absent();
      listener.connected(false);
      // The browser itself reconnects unless the server answered with an error.
      if (closed) {
        again = window.setTimeout(() => {
          stop = this.listen(address, listener);
        }, 3000);
      }
    });
    let stop = (): void => events.close();
    return () => {
      window.clearTimeout(again);
      events.close();
      stop();
    };
  }

  private async get(address: string): Promise<Response> {
    let response: Response;
    try {
      response = await fetch(address, { cache: "no-store" });
    } catch {
      throw new AnswerError(0, `${address}: no answer from the server`);
    }
    if (response.ok) return response;
    const text = (await response.text().catch(() => "")).trim().slice(0, 300);
    throw new AnswerError(response.status, text || `${address}: status ${response.status}`);
  }
}

/** The answers of an exported page: JSON as objects, arrays as base64 of deflated bytes. */
export class EmbeddedSource implements Source {
  constructor(private readonly answers: Record<string, unknown>) {}

  async json<T>(address: string): Promise<T> {
    return this.answer(address) as T;
  }

  async arrays(address: string): Promise<Arrays> {
    const text = this.answer(address);
    if (typeof text !== "string") throw new Error(`${address}: not an array answer`);
    return decodeArrays(await inflate(text));
  }

  listen(): null {
    return null;
  }

  private answer(address: string): unknown {
    const answer = this.answers[address];
    if (answer === undefined) throw new AnswerError(404, `${address} is not in this page`);
    return answer;
  }
}

export async function inflate(base64: string): Promise<ArrayBuffer> {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();
}

export function pageSource(): Source {
  const text = document.getElementById("repose-data")?.textContent;
  return text ? new EmbeddedSource(JSON.parse(text) as Record<string, unknown>) : new HttpSource();
}
