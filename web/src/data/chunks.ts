// From the page to bytes: base64 of a gzip stream in <script data-chunk="K">. Nothing here knows what the bytes mean.

/** Where the text of a chunk comes from: the page, or a test. */
export type ChunkText = (chunk: number) => string | null;

export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

export async function gunzip(packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Bytes of a chunk. The caller keeps what it decodes, as the text of a chunk is dropped once it was read. */
export class Chunks {
  constructor(private readonly text: ChunkText) {}

  async bytes(chunk: number): Promise<Uint8Array<ArrayBuffer>> {
    const text = this.text(chunk);
    if (text === null)
      throw new Error(`Part ${chunk} of the data is missing: the file was cut short. Write the report anew.`);
    return gunzip(bytesOfBase64(text));
  }

  async floats(chunk: number): Promise<Float32Array<ArrayBuffer>> {
    return new Float32Array((await this.numbers(chunk)).buffer);
  }

  async numbers(chunk: number): Promise<Uint32Array<ArrayBuffer>> {
    const bytes = await this.bytes(chunk); // differences of their bits: all low bytes first, all high ones last
    const n = bytes.length / 4;
    const words = new Uint32Array(n);
    for (let k = 0; k < n; k++) {
      const change = bytes[k]! | (bytes[n + k]! << 8) | (bytes[2 * n + k]! << 16) | (bytes[3 * n + k]! << 24);
      words[k] = (k === 0 ? 0 : words[k - 1]!) + change;
    }
    return words;
  }
}

/** Reads the chunks of this page. An element is removed once its text was taken, to free the memory. */
export function textInPage(chunk: number): string | null {
  const element = document.querySelector(`script[data-chunk="${chunk}"]`);
  const text = element?.textContent ?? null;
  element?.remove();
  return text;
}
