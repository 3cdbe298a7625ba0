// The lines that cut, by what the page calls a key: one for each line and tool, and one for the stock.

/// `keys` are those of the part; with a run come those whose faces are all gone at the end, too.
export class Keys {
  constructor({ keys, programs }, play) {
    this.list = keys;
    this.ofMoment = play ? this.addRun(play, programs) : null;
    this.tools = [...new Set(keys.filter((k) => !k.stock).map((k) => k.tool))];
    this.rankAll(play);
    this.byLine = new Map();
    keys.forEach((k, i) => {
      const id = `${k.file}:${k.line}`;
      if (!k.stock) this.byLine.set(id, [...(this.byLine.get(id) ?? []), i]);
    });
  }
  // The key of each moment.
  addRun(play, programs) {
    const keys = this.list, id = (file, line, tool) => `${file}:${line}:${tool}`, of = new Map(), { motions } = play;
    const stock = keys.findIndex((k) => k.stock);
    keys.forEach((k, i) => of.set(id(k.file, k.line, k.toolName), i));
    const byMotion = Array.from({ length: motions.count }, (_, i) => {
      const file = motions.file[i], line = motions.line[i], toolName = play.tools[motions.tool[i]]?.id ?? "", key = id(file, line, toolName);
      if (motions.kind[i] === 0 && play.stock) return -1;
      if (!of.has(key)) {
        of.set(key, keys.length);
        keys.push({ file, line, tool: keys.find((k) => !k.stock && k.toolName === toolName)?.tool ?? 1e6 + motions.tool[i], name: programs[file]?.file.split("/").pop() ?? "", stock: false, toolName });
      }
      return of.get(key);
    });
    const stockKey = stock >= 0 ? stock : keys.push({ file: -1, line: 0, tool: -1, name: "", stock: true, toolName: "" }) - 1;
    const out = new Int32Array(play.moments + 2).fill(stockKey);
    for (let m = 1; m <= play.moments; ++m) out[m] = byMotion[play.motionOf[m]] ?? stockKey;
    return out;
  }
  // `rank`: the place of each key among the lines that cut, in the order of the program.
  rankAll(play) {
    const { list } = this, first = new Map(), order = list.map((_, i) => i).filter((i) => !list[i].stock);
    if (play) for (let m = play.moments; m > 0; --m) first.set(this.ofMoment[m], m);
    const begin = (i) => first.get(i) ?? 0;
    order.sort((a, b) => begin(a) - begin(b) || list[a].file - list[b].file || list[a].line - list[b].line);
    this.rank = new Int32Array(list.length);
    order.forEach((key, at) => { this.rank[key] = at; });
    this.rankCount = order.length;
  }
  /// What a line cut, as places in the list.
  of(file, line) { return this.byLine.get(`${file}:${line}`) ?? []; }
}
