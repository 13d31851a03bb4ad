// Material points and mesh with WebGL 2. One context off the page serves all views: each copies its picture from here,
// so that exports and print need nothing else, and any number of runs fits (browsers allow about 16 contexts).

import * as twgl from "twgl.js";
import type { Run } from "../data/run";
import type { Quantised } from "../data/quantised";
import type { Camera, Size } from "../logic/camera";
import type { Range } from "../logic/colour";
import { FULL } from "../data/quantised";
import { say } from "../logic/texts";

const POINTS_VERTEX = `#version 300 es
precision highp float;
in uint qx;
in uint qy;
in uint qv;
in uint qm;                         // material
uniform vec2 x_range, y_range;      // lo, hi [m]
uniform vec2 v_range;               // lo, hi of the field
uniform bool v_log, bar_log;
uniform vec2 bar;                   // lo, hi of the colour bar
uniform vec2 centre, per_metre;     // camera: [m], clip units per metre
uniform float size;                 // pixels
uniform int categories;             // number of colours in use for categories; 0: a scale
uniform sampler2D colours, soils;
uniform vec2 m_range;               // lo, hi of the material; lo = hi: not decoded yet
uniform vec3 no_value, paper;       // paper: what soil without a value is made paler with
flat out vec3 colour;

void main() {
  vec2 part = vec2(float(qx), float(qy)) / ${FULL}.0;
  vec2 place = vec2(mix(x_range.x, x_range.y, part.x), mix(y_range.x, y_range.y, part.y));
  bool absent = qx == ${FULL}u && qy == ${FULL}u;
  gl_Position = absent ? vec4(9.0, 9.0, 9.0, 1.0) : vec4((place - centre) * per_metre, 0.0, 1.0);
  gl_PointSize = size;
  if (qv == ${FULL}u) {
    float m = mix(m_range.x, m_range.y, float(qm) / ${FULL}.0);
    vec3 soil = texelFetch(soils, ivec2(int(round(m)) & 255, 0), 0).rgb;
    colour = m_range.x < m_range.y ? mix(soil, paper, 0.35) : no_value;
    return;
  }
  float w = float(qv) / ${FULL}.0;
  float value = v_log ? v_range.x * pow(v_range.y / v_range.x, w) : mix(v_range.x, v_range.y, w);
  if (categories > 0) {
    colour = texelFetch(colours, ivec2(int(round(value)) & 255, 0), 0).rgb;
  } else {
    float t = bar_log ? log(max(value, 1e-30) / bar.x) / log(bar.y / bar.x) : (value - bar.x) / (bar.y - bar.x);
    colour = texelFetch(colours, ivec2(int(round(clamp(t, 0.0, 1.0) * 255.0)), 0), 0).rgb;
  }
}`;

const POINTS_FRAGMENT = `#version 300 es
precision mediump float;
flat in vec3 colour;
uniform bool discs;
out vec4 result;
void main() {
  vec2 d = gl_PointCoord - 0.5;
  if (discs && dot(d, d) > 0.25) discard;
  result = vec4(colour, 1.0);
}`;

const LINES_VERTEX = `#version 300 es
precision highp float;
in vec2 place;
uniform vec2 centre, per_metre;
void main() { gl_Position = vec4((place - centre) * per_metre, 0.0, 1.0); }`;

const LINES_FRAGMENT = `#version 300 es
precision mediump float;
uniform vec4 line_colour;
out vec4 result;
void main() { result = line_colour; }`;

export interface Picture {
  camera: Camera;
  size: Size; // CSS pixels
  ratio: number; // device pixels per CSS pixel
  frame: number;
  field: Quantised | null;
  range: Range;
  colours: Uint8Array;
  categories: number;
  material: Quantised | null; // colours the points that have no value
  soils: Uint8Array; // by material
  paper: [number, number, number];
  pointScale: number;
  mesh: boolean;
  meshColour: [number, number, number, number];
}

interface Buffers {
  x: WebGLBuffer;
  y: WebGLBuffer;
  v: WebGLBuffer;
  m: WebGLBuffer;
  vao: WebGLVertexArrayObject;
  frame: number;
  field: Quantised | null;
  valueFrame: number;
  material: Quantised | null;
  edges: WebGLBuffer | null;
  edgesVao: WebGLVertexArrayObject | null;
}

export class PointRenderer {
  readonly canvas = document.createElement("canvas");
  private readonly gl: WebGL2RenderingContext;
  private readonly points: twgl.ProgramInfo;
  private readonly lines: twgl.ProgramInfo;
  private readonly textures: { texture: WebGLTexture; colours: Uint8Array | null }[]; // of the field, of the soils
  private readonly buffers = new Map<Run, Buffers>();
  lost = false;

  constructor(onRestored: () => void) {
    const gl = this.canvas.getContext("webgl2",
      { antialias: false, alpha: true, premultipliedAlpha: true, preserveDrawingBuffer: false });
    if (!gl)
      throw new Error(say("no_webgl"));
    this.gl = gl;
    this.points = twgl.createProgramInfo(gl, [POINTS_VERTEX, POINTS_FRAGMENT]);
    this.lines = twgl.createProgramInfo(gl, [LINES_VERTEX, LINES_FRAGMENT]);
    this.textures = [0, 1].map(() => ({ texture: gl.createTexture()!, colours: null }));
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.lost = true;
    });
    this.canvas.addEventListener("webglcontextrestored", onRestored);
  }

  /** Draws into `canvas`, of size width x ratio, height x ratio; valid until the next call. */
  draw(run: Run, picture: Picture): void {
    const { gl, canvas } = this;
    const [width, height] =
      [Math.round(picture.size.width * picture.ratio), Math.round(picture.size.height * picture.ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const buffers = this.upload(run, picture);
    const { camera, size, ratio } = picture;
    const common = {
      centre: [camera.x, camera.y],
      per_metre: [(2 * camera.scale) / size.width, (2 * camera.scale) / size.height],
    };
    if (picture.mesh && buffers.edgesVao) {
      gl.useProgram(this.lines.program);
      gl.bindVertexArray(buffers.edgesVao);
      twgl.setUniforms(this.lines, { ...common, line_colour: picture.meshColour });
      gl.drawArrays(gl.LINES, 0, run.edges.length / 2);
    }
    if (picture.field) this.drawPoints(run, picture, picture.field, buffers, common, ratio);
    gl.bindVertexArray(null);
  }

  private drawPoints(run: Run, picture: Picture, field: Quantised, buffers: Buffers, common: object,
    ratio: number): void {
    const { gl } = this;
    const spacing = run.meta.point_size * picture.camera.scale * ratio * picture.pointScale;
    const discs = spacing > 7; // smaller ones would only show gaps
    const [x, y, v] = [run.x.meta, run.y.meta, field.meta];
    gl.useProgram(this.points.program);
    gl.bindVertexArray(buffers.vao);
    const [colours, soils] = [picture.colours, picture.soils].map((table, k) => this.textureOf(k, table));
    const materials = picture.material?.meta;
    twgl.setUniforms(this.points, {
      ...common,
      x_range: [x.lo, x.hi],
      y_range: [y.lo, y.hi],
      v_range: [v.lo, v.hi],
      v_log: v.log,
      bar_log: picture.range.log,
      bar: [picture.range.lo, picture.range.hi],
      size: Math.max(2, 1.6 * spacing), // overlap enough that sound soil has no gaps
      categories: picture.categories,
      colours,
      soils,
      m_range: materials ? [materials.lo, materials.hi] : [0, 0],
      paper: picture.paper,
      no_value: [0.6, 0.62, 0.64],
      discs,
    });
    gl.drawArrays(gl.POINTS, 0, run.points);
  }

  private textureOf(k: number, colours: Uint8Array): WebGLTexture {
    const { gl } = this;
    const kept = this.textures[k]!;
    if (colours === kept.colours) return kept.texture;
    kept.colours = colours;
    gl.bindTexture(gl.TEXTURE_2D, kept.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, colours.length / 4, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colours);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return kept.texture;
  }

  /** Brings frame and field to the GPU, as the 16-bit numbers that they are; nothing if they are there. */
  private upload(run: Run, picture: Picture): Buffers {
    const { gl } = this;
    let buffers = this.buffers.get(run);
    if (!buffers) {
      buffers = this.create(run);
      this.buffers.set(run, buffers);
    }
    if (picture.material && (buffers.material !== picture.material || buffers.frame !== picture.frame)) {
      this.fill(buffers.m, picture.material.frame(picture.frame));
      buffers.material = picture.material;
    }
    if (buffers.frame !== picture.frame) {
      this.fill(buffers.x, run.x.frame(picture.frame));
      this.fill(buffers.y, run.y.frame(picture.frame));
      buffers.frame = picture.frame;
    }
    if (picture.field && (buffers.field !== picture.field || buffers.valueFrame !== picture.frame)) {
      this.fill(buffers.v, picture.field.frame(picture.frame));
      buffers.field = picture.field;
      buffers.valueFrame = picture.frame;
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return buffers;
  }

  private fill(buffer: WebGLBuffer, values: Uint16Array): void {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, buffer);
    this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, values);
  }

  private create(run: Run): Buffers {
    const { gl } = this;
    const vao = gl.createVertexArray()!;
    gl.bindVertexArray(vao);
    const attribute = (name: string): WebGLBuffer => {
      const buffer = gl.createBuffer()!;
      const location = gl.getAttribLocation(this.points.program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, 2 * run.points, gl.DYNAMIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribIPointer(location, 1, gl.UNSIGNED_SHORT, 0, 0);
      return buffer;
    };
    const made: Buffers = {
      x: attribute("qx"), y: attribute("qy"), v: attribute("qv"), m: attribute("qm"), vao,
      frame: -1, field: null, valueFrame: -1, material: null, edges: null, edgesVao: null,
    };
    if (run.edges.length > 0) {
      made.edgesVao = gl.createVertexArray()!;
      gl.bindVertexArray(made.edgesVao);
      made.edges = gl.createBuffer()!;
      const location = gl.getAttribLocation(this.lines.program, "place");
      gl.bindBuffer(gl.ARRAY_BUFFER, made.edges);
      gl.bufferData(gl.ARRAY_BUFFER, run.edges, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 2, gl.FLOAT, false, 0, 0);
    }
    gl.bindVertexArray(null);
    return made;
  }
}
