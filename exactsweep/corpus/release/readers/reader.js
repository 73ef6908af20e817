// node reader.js worked.jsonl
const lines = require("node:fs").readFileSync(process.argv[2], "utf8").trimEnd().split("\n");
// A coordinate is two integers of any size; a JSON number of JavaScript would be a double.
const rational = (text) => (text.includes("/") ? text : `${text}/1`).split("/").map(BigInt);
for (const line of lines) {
  const c = JSON.parse(line);
  const { trajectory, exact_fits } = c.expected;
  const [x, y] = trajectory[0].map(rational);
  const counts = [c.directrix.length, trajectory.length, exact_fits.length];
  console.log(c.id, counts.join(" "), x.join("/"), y.join("/"));
}
