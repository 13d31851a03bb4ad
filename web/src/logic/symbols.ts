// Names of quantities as the program writes them, as one reads them: eps_eq_p -> ε with the index eq,p.

const SYMBOLS: [RegExp, string, string][] = [
  [/eps_eq_p/, "ε", "eq,p"],
  [/eps_deviatoric/, "ε", "dev"],
  [/\bS_u\b/, "S", "u"],
];

export interface Part {
  text: string;
  index: string; // subscript, may be empty
}

export function symbolic(text: string): Part[] {
  for (const [pattern, symbol, index] of SYMBOLS) {
    const match = pattern.exec(text);
    if (!match) continue;
    const before = text.slice(0, match.index);
    return [...(before ? symbolic(before) : []), { text: symbol, index },
      ...symbolic(text.slice(match.index + match[0].length))];
  }
  return text ? [{ text, index: "" }] : [];
}

/** "m^2" -> "m²" */
export function unitText(unit: string): string {
  return unit === "-" ? "" : unit.replace("^2", "²").replace("^3", "³");
}
