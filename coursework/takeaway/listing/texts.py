"""Functions of a listing's own in five languages: elimination, sign, breaks of the drive, tabulated laws.

Enters: nothing.  Leaves: texts with places `{name}` to be filled; braces of a language stand as they are.  Used by `tables.py`.
"""

ELIMINATION = {
    "python": """def {gauss}(a):
    size, determinant = len(a), 1.0
    for j in range(size):
        p = max(range(j, size), key=lambda r: abs(a[r][j]))
        if p != j:
            a[j], a[p], determinant = a[p], a[j], -determinant
        determinant *= a[j][j]
        for r in range(size):
            if r != j:
                f = a[r][j]/a[j][j]
                a[r] = [x - f*y for x, y in zip(a[r], a[j])]
    return [a[j][size]/a[j][j] for j in range(size)] + [determinant]
""",
    "javascript": """function {gauss}(a) {
    const size = a.length;
    let determinant = 1.0;
    for (let j = 0; j < size; j++) {
        let p = j;
        for (let r = j; r < size; r++) if (Math.abs(a[r][j]) > Math.abs(a[p][j])) p = r;
        if (p !== j) { [a[j], a[p]] = [a[p], a[j]]; determinant = -determinant; }
        determinant *= a[j][j];
        for (let r = 0; r < size; r++) if (r !== j) {
            const f = a[r][j]/a[j][j];
            a[r] = a[r].map((x, c) => x - f*a[j][c]);
        }
    }
    return [...a.map((row, j) => row[size]/row[j]), determinant];
}
""",
    "c": """static double {gauss}(int size) {
    double determinant = 1.0, f;
    for (int j = 0; j < size; j++) {
        int p = j;
        for (int r = j; r < size; r++) if (fabs({work}[r][j]) > fabs({work}[p][j])) p = r;
        if (p != j) determinant = -determinant;
        for (int c = 0; c <= size; c++) { f = {work}[j][c]; {work}[j][c] = {work}[p][c]; {work}[p][c] = f; }
        determinant *= {work}[j][j];
        for (int r = 0; r < size; r++) if (r != j) {
            f = {work}[r][j]/{work}[j][j];
            for (int c = j; c <= size; c++) {work}[r][c] -= f*{work}[j][c];
        }
    }
    for (int j = 0; j < size; j++) {work}[j][size] /= {work}[j][j];
    return determinant;
}
""",
    "pascal": """function {gauss}(size: integer): double;
var a, b, c, p: integer; f, d: double;
begin
  d := 1.0;
  for a := 0 to size - 1 do begin
    p := a;
    for b := a to size - 1 do if abs({work}[b][a]) > abs({work}[p][a]) then p := b;
    if p <> a then d := -d;
    for c := 0 to size do begin f := {work}[a][c]; {work}[a][c] := {work}[p][c]; {work}[p][c] := f end;
    d := d*{work}[a][a];
    for b := 0 to size - 1 do if b <> a then begin
      f := {work}[b][a]/{work}[a][a];
      for c := a to size do {work}[b][c] := {work}[b][c] - f*{work}[a][c];
    end;
  end;
  for a := 0 to size - 1 do {work}[a][size] := {work}[a][size]/{work}[a][a];
  {gauss} := d;
end;
""",
}

# The quartic of Lagrange through five nodes, a function of all such laws; `y` are the numbers at the nodes.
FIVE = {
    "python": """def {five}(x, y, first, step):
    u = (x - first)/step
    s = min(max(min(max(int(u), 0), len(y) - 2) - 1, 0), len(y) - 5)
    total = 0.0
    for a in range(5):
        part = y[s + a]
        for b in range(5):
            if b != a:
                part = part*(u - s - b)/(a - b)
        total = total + part
    return total
""",
    "javascript": """function {five}(x, y, first, step) {
    const u = (x - first)/step;
    const s = Math.min(Math.max(Math.min(Math.max(Math.trunc(u), 0), y.length - 2) - 1, 0), y.length - 5);
    let total = 0.0;
    for (let a = 0; a < 5; a++) {
        let part = y[s + a];
        for (let b = 0; b < 5; b++) if (b !== a) part = part*(u - s - b)/(a - b);
        total += part;
    }
    return total;
}
""",
    "c": """static double {five}(double x, const double y[], int nodes, double first, double step) {
    double u = (x - first)/step, total = 0.0;
    int s = (int) u;
    s = (s < 0 ? 0 : s > nodes - 2 ? nodes - 2 : s) - 1;
    s = s < 0 ? 0 : s > nodes - 5 ? nodes - 5 : s;
    for (int a = 0; a < 5; a++) {
        double part = y[s + a];
        for (int b = 0; b < 5; b++) if (b != a) part = part*(u - s - b)/(a - b);
        total += part;
    }
    return total;
}
""",
    "octave": """function total = {five}(x, y, first, step)
    u = (x - first)/step;
    s = min(max(min(max(fix(u), 0), numel(y) - 2) - 1, 0), numel(y) - 5);
    total = 0.0;
    for a = 0:4
        part = y(s + a + 1);
        for b = [0:a-1, a+1:4]
            part = part*(u - s - b)/(a - b);
        end
        total = total + part;
    end
end
""",
    "pascal": """function {five}(x: double; const y: array of double; first, step: double): double;
var u, part: double; a, b, s: integer;
begin
  u := (x - first)/step; result := 0.0;
  s := min(max(min(max(trunc(u), 0), high(y) - 1) - 1, 0), high(y) - 4);
  for a := 0 to 4 do begin
    part := y[s + a];
    for b := 0 to 4 do if b <> a then part := part*(u - s - b)/(a - b);
    result := result + part;
  end;
end;
""",
}
LAW = {
    "python": """def {name}(x):
    y = {values}
    return {five}(x, y, {first}, {step})
""",
    "javascript": """function {name}(x) {
    const y = {values};
    return {five}(x, y, {first}, {step});
}
""",
    "c": """static double {name}(double x) {
    static const double y[] = {values};
    return {five}(x, y, {nodes}, {first}, {step});
}
""",
    "octave": """function value = {name}(x)
    y = {values};
    value = {five}(x, y, {first}, {step});
end
""",
    "pascal": """function {name}(x: double): double;
const y: array[0..{top}] of double = {values};
begin {name} := {five}(x, y, {first}, {step}) end;
""",
}
# The cubic of a spline, `form` in u from the two values and the two slopes at the ends of an interval.
SPLINE = {
    "python": """def {name}(x):
    y = {values}
    m = {slopes}
    u = (x - {first})/{step}
    s = min(max(int(u), 0), {last})
    u = u - s
    a, b = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1]
    return {form}
""",
    "javascript": """function {name}(x) {
    const y = {values};
    const m = {slopes};
    const s = Math.min(Math.max(Math.trunc((x - {first})/{step}), 0), {last}), u = (x - {first})/{step} - s;
    const a = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], b = -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
    return {form};
}
""",
    "c": """static double {name}(double x) {
    static const double y[] = {values};
    static const double m[] = {slopes};
    double u = (x - {first})/{step};
    int s = (int) u;
    s = s < 0 ? 0 : s > {last} ? {last} : s;
    u = u - s;
    double a = 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1], b = -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
    return {form};
}
""",
    "octave": """function value = {name}(x)
    y = {values};
    m = {slopes};
    u = (x - {first})/{step};
    s = min(max(fix(u), 0), {last});
    u = u - s;
    s = s + 1;
    a = 2*y(s) - 2*y(s + 1) + m(s) + m(s + 1);
    b = -3*y(s) + 3*y(s + 1) - 2*m(s) - m(s + 1);
    value = {form};
end
""",
    "pascal": """function {name}(x: double): double;
const y: array[0..{top}] of double = {values};
const m: array[0..{top}] of double = {slopes};
var u, a, b: double; s: integer;
begin
  u := (x - {first})/{step};
  s := min(max(trunc(u), 0), {last});
  u := u - s;
  a := 2*y[s] - 2*y[s + 1] + m[s] + m[s + 1]; b := -3*y[s] + 3*y[s + 1] - 2*m[s] - m[s + 1];
  {name} := {form};
end;
""",
}
SIGN = {
    "python": """def sign(x):
    return (x > 0) - (x < 0)
""",
    "c": """static double sign(double x) { return (x > 0) - (x < 0); }
""",
}
# The last time before a break of the drive: where a slope at the end of a step still sees the old formula.
LOOK = {
    "python": """def {look}(t, after):
    for b in ({breaks},):
        if abs(after - b) <= 1e-13*b:
            t = min(t, after*(1 - 1e-13))
    return t
""",
    "javascript": """function {look}(t, after) {
    for (const b of [{breaks}])
        if (Math.abs(after - b) <= 1e-13*b) t = Math.min(t, after*(1 - 1e-13));
    return t;
}
""",
    "c": """static double {look}(double t, double after) {
    const double b[] = {{breaks}};
    for (int j = 0; j < {count}; j++)
        if (fabs(after - b[j]) <= 1e-13*b[j]) t = fmin(t, after*(1 - 1e-13));
    return t;
}
""",
    "octave": """function t = {look}(t, after)
    for b = [{breaks}]
        if abs(after - b) <= 1e-13*b
            t = min(t, after*(1 - 1e-13));
        end
    end
end
""",
    "pascal": """function {look}(t, after: double): double;
const b: array[1..{count}] of double = ({breaks});
var j: integer;
begin
  for j := 1 to {count} do
    if abs(after - b[j]) <= 1e-13*b[j] then t := min(t, after*(1 - 1e-13));
  {look} := t;
end;
""",
}
