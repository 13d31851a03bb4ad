// Tables of numbers over time (ledger, histories): float32, column by column.

import type { ColumnMeta, TableMeta } from "./format";

export class Table {
  private readonly index: Map<string, number>;

  constructor(
    readonly columns: ColumnMeta[],
    readonly rows: number,
    private readonly values: Float32Array,
  ) {
    if (values.length !== columns.length * rows) {
      throw new Error(`A table of ${columns.length} columns and ${rows} rows has ${values.length} values.`);
    }
    this.index = new Map(columns.map((column, k) => [column.name, k]));
  }

  static of(meta: TableMeta, values: Float32Array): Table {
    return new Table(meta.columns, meta.rows, values);
  }

  has(name: string): boolean {
    return this.index.has(name);
  }

  /** Values of a column, shape [rows]; null if there is none of that name. */
  column(name: string): Float32Array | null {
    const k = this.index.get(name);
    return k === undefined ? null : this.values.subarray(k * this.rows, (k + 1) * this.rows);
  }

  /** Values of a column by its number. */
  at(k: number): Float32Array {
    return this.values.subarray(k * this.rows, (k + 1) * this.rows);
  }

  unit(name: string): string {
    const k = this.index.get(name);
    return k === undefined ? "" : this.columns[k]!.unit;
  }

  label(name: string): string {
    const k = this.index.get(name);
    return k === undefined ? name : (this.columns[k]!.label ?? name);
  }
}
