"""Writes a grid of plates, pinned to each other."""

SIZE = 12
cells = [(r, c) for r in range(SIZE) for c in range(SIZE)]
print("kinestat: 1\nspace: planar\nground: g")
print(f"bodies: [{', '.join(f'w{r}_{c}' for r, c in cells)}]\ncouplings:")
print("  held: {type: rigid, bodies: [g, w0_0]}")
for r, c in cells:
    if c > 0:
        at = f"[{10 * c - 5}, {10 * r + (3 * r + c) % 5 - 2}]"
        print(f"  h{r}_{c}: {{type: revolute, bodies: [w{r}_{c - 1}, w{r}_{c}], at: {at}}}")
    if r > 0:
        at = f"[{10 * c + (r + 3 * c) % 5 - 2}, {10 * r - 5}]"
        print(f"  v{r}_{c}: {{type: revolute, bodies: [w{r - 1}_{c}, w{r}_{c}], at: {at}}}")
print("cases: {only: {action: {}}}")
