// Exact rational numbers as pairs of BigInt, [numerator, positive denominator], in lowest terms.
const rational = {
  parse(text) {
    const [n, d = "1"] = text.split("/");
    return [BigInt(n), BigInt(d)];
  },
  text([n, d]) {
    return d === 1n ? String(n) : `${n}/${d}`;
  },
  // Six digits of one that is long; "" for one that is not.
  about([n, d]) {
    if (rational.text([n, d]).length <= 20) return "";
    const size = n < 0n ? -n : n;
    // The power of ten of the first digit, or one more.
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
