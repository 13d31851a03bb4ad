// Zoom and pan: which part of the world a view shows. One camera serves all views, so that they stay linked.

export interface Camera {
  x: number; // world place in the middle of the view [m]
  y: number;
  scale: number; // CSS pixels per metre
}

export interface Size {
  width: number;
  height: number;
}

export type Box = [number, number, number, number]; // xmin, ymin, xmax, ymax [m]

export interface Padding {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export function fit(box: Box, size: Size, pad: Padding): Camera {
  const width = Math.max(1, size.width - pad.left - pad.right);
  const height = Math.max(1, size.height - pad.top - pad.bottom);
  const scale = Math.min(width / Math.max(1e-9, box[2] - box[0]), height / Math.max(1e-9, box[3] - box[1]));
  return {
    x: (box[0] + box[2]) / 2 - (pad.left - pad.right) / (2 * scale),
    y: (box[1] + box[3]) / 2 + (pad.top - pad.bottom) / (2 * scale),
    scale,
  };
}

export function toScreen(camera: Camera, size: Size, x: number, y: number): [number, number] {
  return [size.width / 2 + (x - camera.x) * camera.scale, size.height / 2 - (y - camera.y) * camera.scale];
}

export function toWorld(camera: Camera, size: Size, px: number, py: number): [number, number] {
  return [camera.x + (px - size.width / 2) / camera.scale, camera.y - (py - size.height / 2) / camera.scale];
}

/** Zooms so that the world place under (px, py) stays there. */
export function zoomAt(camera: Camera, size: Size, px: number, py: number, factor: number): Camera {
  const [x, y] = toWorld(camera, size, px, py);
  const scale = Math.min(1e6, Math.max(1e-3, camera.scale * factor));
  return { x: x - (px - size.width / 2) / scale, y: y + (py - size.height / 2) / scale, scale };
}

export function pan(camera: Camera, dx: number, dy: number): Camera {
  return { ...camera, x: camera.x - dx / camera.scale, y: camera.y + dy / camera.scale };
}

export function union(boxes: Box[]): Box {
  return [
    Math.min(...boxes.map((b) => b[0])),
    Math.min(...boxes.map((b) => b[1])),
    Math.max(...boxes.map((b) => b[2])),
    Math.max(...boxes.map((b) => b[3])),
  ];
}

/** Columns in which n views of that shape show most: the one of 1...n with the largest scale. */
export function bestColumns(n: number, box: Box, area: Size, pad: Padding): number {
  let best = 1;
  let most = 0;
  for (let columns = 1; columns <= n; columns++) {
    const size = { width: area.width / columns, height: area.height / Math.ceil(n / columns) };
    const { scale } = fit(box, size, pad);
    if (scale > most * 1.02) [best, most] = [columns, scale];
  }
  return best;
}
