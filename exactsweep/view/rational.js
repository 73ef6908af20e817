// Exact rational numbers as pairs of BigInt, [numerator, positive denominator], in lowest terms.
const rational = {
  parse(text) {
    const [n, d = "1"] = text.split("/");
    return [BigInt(n), BigInt(d)];
  },
  text([n, d]) {
    return d === 1n ? String(n) : `${n}/${d}`;
  },
  // Shorten a long number and append its number of characters.
  brief(text) {
    if (text.length <= 64) return text;
    return `${text.slice(0, 28)}\u2026${text.slice(-16)} (${text.length} characters)`;
  },
  isLess([a, b], [c, d]) {
    return a * d < c * b;
  },
  areEqual([[a, b], [c, d]], [[e, f], [g, h]]) {
    return a === e && b === f && c === g && d === h;
  },
  vector(from, to) {
    return [0, 1].map((axis) => rational.minus(to[axis], from[axis]));
  },
  scalar([a, b], [c, d]) {
    return rational.plus(rational.times(a, c), rational.times(b, d));
  },
  // The numerator of the scalar product, which has its sign.
  dot(u, v) {
    return rational.scalar(u, v)[0];
  },
  cross([a, b], v) {
    return rational.dot([[-b[0], b[1]], a], v);
  },
  // The first six digits of a long number or fraction; "" for short ones.
  about([n, d]) {
    if (rational.text([n, d]).length <= (d === 1n ? 20 : 7)) return "";
    const size = n < 0n ? -n : n;
    // The exponent of the first digit, or one more.
    let exponent = String(size).length - String(d).length;
    const digits = (e) => {
      const shift = 10n ** BigInt(Math.abs(5 - e));
      const [a, b] = e < 5 ? [size * shift, d] : [size, d * shift];
      return Number((2n * a + b) / (2n * b));
    };
    if (digits(exponent) < 100_000) exponent -= 1;
    const shown = exponent > -5 && exponent < 10
      ? String(Number(`${digits(exponent)}e${exponent - 5}`))
      : `${digits(exponent) / 1e5}e${exponent}`;
    return (n < 0n ? "-" : "") + shown;
  },
  plus([a, b], [c, d]) {
    return rational.reduced(a * d + c * b, b * d);
  },
  minus(p, [c, d]) {
    return rational.plus(p, [-c, d]);
  },
  times([a, b], [c, d]) {
    return rational.reduced(a * c, b * d);
  },
  reduced(n, d) {
    let [a, b] = [n < 0n ? -n : n, d];
    while (b) [a, b] = [b, a % b];
    return [n / a, d / a];
  },
};
