// Zip files: written without compression, read with what DecompressionStream unpacks. Names are in UTF-8.

export type Bytes = Uint8Array<ArrayBuffer>;
export type Files = Map<string, Bytes>;

const [LOCAL, CENTRAL, END] = [0x04034b50, 0x02014b50, 0x06054b50];
const UTF8 = 0x800;
const MOST_BYTES = 400e6; // unpacked

const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
  return n;
});

function crc32(bytes: Bytes): number {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 255]! ^ (crc >>> 8);
  return (crc ^ 0xffffffff) >>> 0;
}

/** What each number takes: [value, bytes]. */
function numbers(...fields: [number, number][]): Bytes {
  const bytes = new Uint8Array(fields.reduce((n, [, size]) => n + size, 0));
  let at = 0;
  for (const [value, size] of fields) for (let k = 0; k < size; k++) bytes[at++] = Math.floor(value / 256 ** k) & 255;
  return bytes;
}

/** The date is fixed: the same files give the same bytes. */
export function writeZip(files: Files): Blob {
  const parts: Bytes[] = [];
  const directory: Bytes[] = [];
  let at = 0;
  for (const [path, bytes] of files) {
    const name = new TextEncoder().encode(path);
    const common: [number, number][] = [[20, 2], [UTF8, 2], [0, 2], [0, 2], [0x5a21, 2], [crc32(bytes), 4],
      [bytes.length, 4], [bytes.length, 4], [name.length, 2], [0, 2]];
    directory.push(numbers([CENTRAL, 4], [20, 2], ...common, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]), name);
    const head = numbers([LOCAL, 4], ...common);
    parts.push(head, name, bytes);
    at += head.length + name.length + bytes.length;
  }
  const size = directory.reduce((n, part) => n + part.length, 0);
  const end = numbers([END, 4], [0, 2], [0, 2], [files.size, 2], [files.size, 2], [size, 4], [at, 4], [0, 2]);
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}

export class ZipError extends Error {}

async function inflate(packed: Bytes, size: number): Promise<Bytes> {
  const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const bytes = new Uint8Array(size);
  for (let at = 0; ;) {
    const { done, value } = await reader.read();
    if (done) return at === size ? bytes : Promise.reject(new ZipError("damaged"));
    if (at + value.length > size) return Promise.reject(new ZipError("damaged")); // more than it says: a bomb
    bytes.set(value, at);
    at += value.length;
  }
}

/** Throws ZipError: "damaged", or "large" where it unpacks to more than a page should hold. */
export async function readZip(zip: Bytes): Promise<Files> {
  const view = new DataView(zip.buffer, zip.byteOffset, zip.byteLength);
  const files: Files = new Map();
  try {
    let end = zip.length - 22;
    while (view.getUint32(end, true) !== END) end--;
    let at = view.getUint32(end + 16, true);
    let total = 0;
    for (let n = view.getUint16(end + 10, true); n > 0; n--) {
      if (view.getUint32(at, true) !== CENTRAL) throw new ZipError("damaged");
      const [method, packed, size] = [view.getUint16(at + 10, true), view.getUint32(at + 20, true), view.getUint32(at + 24, true)];
      const length = view.getUint16(at + 28, true);
      const local = view.getUint32(at + 42, true);
      const name = new TextDecoder().decode(zip.subarray(at + 46, at + 46 + length));
      const crc = view.getUint32(at + 16, true);
      at += 46 + length + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
      if (name.endsWith("/")) continue;
      if ((total += size) > MOST_BYTES) throw new ZipError("large");
      const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
      const data = zip.slice(start, start + packed);
      const bytes = method === 0 ? data : method === 8 ? await inflate(data, size) : null;
      if (!bytes || bytes.length !== size || crc32(bytes) !== crc) throw new ZipError("damaged");
      if (!name.split(/[/\\]/).includes("..") && !name.startsWith("/")) files.set(name, bytes);
    }
  } catch (error) {
    throw error instanceof ZipError ? error : new ZipError("damaged");
  }
  return files;
}
