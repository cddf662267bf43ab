// Loops of all kinds, whose turns depend on `n`: the same text in GLSL and C++. The includer defines FUNCTION, `inline`
// in C++.

const uint kKinds = 10u;

FUNCTION bool below(uint i, uint n) {
  return i * i < n;
}

FUNCTION uint counted(uint n) {
  uint sum = 0u;
  for (uint i = 0u; i < n; i++) {
    sum += i * i + 1u;
  }
  return sum;
}

// Two conditions, of which the second one is asked for only where the first holds.
FUNCTION uint halved(uint n) {
  uint turns = 0u;
  uint rest = n;
  while (rest > 0u && 100u / rest > 2u) {
    rest /= 2u;
    turns++;
  }
  return 16u * turns + rest;
}

FUNCTION uint skipping(uint n) {
  uint sum = 0u;
  for (uint i = 0u; i < n; i++) {
    if (i % 3u == 1u) {
      continue;
    }
    if (i > 20u) {
      break;
    }
    sum += i;
  }
  return sum;
}

FUNCTION uint nested(uint n) {
  uint sum = 1u;
  for (uint i = 0u; i < n % 7u; i++) {
    uint left = i;
    while (left > 0u) {
      for (uint k = left; k < n; k += 5u) {
        sum = 3u * sum + k;
      }
      left--;
    }
  }
  return sum;
}

FUNCTION uint first_square(uint n) {
  for (uint i = 0u; i < 40u; i++) {
    if (i * i >= n) {
      return i;
    }
  }
  return 99u;
}

FUNCTION uint root(uint n) {
  uint i = 0u;
  while (below(i, n)) {
    i++;
  }
  return i;
}

FUNCTION uint once_at_least(uint n) {
  uint turns = 0u;
  do {
    turns++;
  } while (turns < n);
  return turns;
}

FUNCTION uint until(uint n) {
  uint i = n;
  while (true) {
    if (i % 5u == 0u) {
      break;
    }
    i++;
  }
  return i;
}

// Loops that follow one another, the second one in a branch.
FUNCTION uint in_turn(uint n) {
  uint sum = 0u;
  for (uint i = n; i < 9u; i++) {
    sum += i;
  }
  if (n > 4u) {
    for (uint i = 4u; i < n; i++) {
      sum += 2u;
    }
  } else {
    sum += 1u;
  }
  for (uint i = 0u; i < sum % 4u; i++) {
    sum += 3u * n;
  }
  return sum;
}

FUNCTION uint chosen(uint n) {
  uint sum = 0u;
  for (uint i = 0u; i < n; i++) {
    switch (i % 3u) {
      case 0u:
        sum += 1u;
        break;
      case 1u:
        sum += 10u;
        continue;
      default:
        sum += 100u;
    }
    sum += 1000u;
  }
  return sum;
}

FUNCTION uint turned(uint kind, uint n) {
  switch (kind) {
    case 0u:
      return counted(n);
    case 1u:
      return halved(n);
    case 2u:
      return skipping(n);
    case 3u:
      return nested(n);
    case 4u:
      return first_square(n);
    case 5u:
      return root(n);
    case 6u:
      return once_at_least(n);
    case 7u:
      return until(n);
    case 8u:
      return in_turn(n);
    default:
      return chosen(n);
  }
}
