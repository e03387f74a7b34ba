#!/usr/bin/env python3
"""Makes the page of demos/report.sh out of the CSV files that it measured: figures, tables, and sentences from numbers.

Usage: page.py FOLDER    reads FOLDER/data, writes FOLDER/index.html, report.md and a figure a file.
"""
import base64
import csv
import html
import io
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

# Okabe and Ito's colours, told apart by everybody; one a method, the same in all figures.
COLOURS = {
    "growth": "#0072B2",
    "signed_distance": "#0072B2",
    "plain": "#000000",
    "ie": "#E69F00",
    "inc": "#009E73",
    "dcf": "#CC79A7",
    "dcol": "#D55E00",
    "bullet_gjk_epa": "#D55E00",
    "bullet_mpr": "#E69F00",
    "fcl": "#009E73",
}
SHORT = {
    "growth": "ours",
    "plain": "paper, as printed",
    "ie": "IE",
    "inc": "Inc",
    "dcf": "DCF",
    "dcol": "DCol",
}
WORKS = {
    "curved": "curved primitives",
    "meshes": "meshes, 241 to 4516 vertices",
    "rounded-hulls": "hulls of 8-20 vertices, margin 4 cm",
    "sharp-hulls": "hulls of 8-20 vertices, no margin",
    "dsf": "differentiable support functions",
    "2d": "2D sets",
}
SHARES = {"p50": "half of the pairs", "p99": "99 % of the pairs", "max": "all pairs"}
TABLE_METHODS = ("ie", "dcf", "inc", "dcol", "plain", "growth")
LEAST = 1e-17  # What a gap of 0 is drawn as.


def numbers(row):
    """A CSV row with its numbers as such; empty fields are None."""

    def convert(text):
        try:
            return float(text)
        except ValueError:
            return text or None

    return {key: convert(value) for key, value in row.items()}


def read_csv(path):
    """Rows of a file of ours: comment lines left out."""
    with open(path, encoding="utf-8") as file:
        return [numbers(row) for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def base_of(method):
    """The method without its start."""
    return method.removesuffix("_warm")


class Page:
    """Collects sections, and writes them as HTML and as Markdown."""

    def __init__(self, folder):
        self.folder = folder
        self.html = []
        self.markdown = []

    def heading(self, text):
        self.html.append(f"<h2>{html.escape(text)}</h2>")
        self.markdown.append(f"## {text}\n")

    def prose(self, text):
        self.html.append(f"<p>{html.escape(text)}</p>")
        self.markdown.append(text + "\n")

    def bullets(self, lines):
        self.html.append("<ul>" + "".join(f"<li>{html.escape(line)}</li>" for line in lines) + "</ul>")
        self.markdown.append("".join(f"- {line}\n" for line in lines))

    def table(self, head, rows):
        cells = "".join(f"<th>{html.escape(cell)}</th>" for cell in head)
        body = "".join("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
        self.html.append(f"<table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table>")
        lines = [head, ["---"] * len(head), *rows]
        self.markdown.append("".join("| " + " | ".join(line) + " |\n" for line in lines))

    def figure(self, figure, name, caption):
        figure.savefig(self.folder / f"{name}.svg")
        buffer = io.StringIO()
        figure.savefig(buffer, format="svg")
        plt.close(figure)
        text = buffer.getvalue()
        self.html.append(f'<figure id="{name}">{text[text.index("<svg"):]}<figcaption>{html.escape(caption)}'
                         "</figcaption></figure>")
        self.markdown.append(f"![{caption}]({name}.svg)\n\n{caption}\n")

    def picture(self, path, caption):
        data = base64.b64encode(path.read_bytes()).decode()
        self.html.append(f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
                         f"<figcaption>{html.escape(caption)}</figcaption></figure>")
        self.markdown.append(f"![{caption}]({path.relative_to(self.folder)})\n\n{caption}\n")

    def write(self, title):
        style = ("body{font:16px/1.5 serif;max-width:70em;margin:2em auto;padding:0 1em;color:#111}"
                 "figure{margin:1.5em 0}figure svg,figure img{max-width:100%;height:auto}"
                 "figcaption{color:#444;font-size:.9em}table{border-collapse:collapse;font-size:.9em}"
                 "td,th{padding:.2em .7em;border-bottom:1px solid #ccc;text-align:right}"
                 "td:first-child,th:first-child{text-align:left}")
        (self.folder / "index.html").write_text(
            f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>{style}</style>'
            f"</head><body><h1>{title}</h1>{''.join(self.html)}</body></html>", encoding="utf-8")
        (self.folder / "report.md").write_text(f"# {title}\n\n" + "\n".join(self.markdown), encoding="utf-8")


def shape_work(work):
    """Kind with margin, and class, of what shape_pairs calls hulls_nearly_touching_0.04."""
    kind, rest = work.split("_", 1)
    distance_class, margin = rest.rsplit("_", 1)
    return f"{kind}, margin {margin} m", distance_class.replace("_", " ")


def of_work(rows, work, start="cold", tolerance=0):
    """Method -> row, of those that take the work."""
    return {
        base_of(row["method"]): row
        for row in rows
        if row["work"] == work and row["start"] == start and row["tolerance"] == tolerance and row["pairs"] > 0
    }


def losses_of_distance(pairs, rows, name, times, errors):
    """Where Bullet's GJK/EPA, called so, is ahead of our signed distance on the same pairs."""
    lines = []
    methods = {row["method"]: row for row in rows if row["pairs"] > 0}
    bullet = methods.get("bullet_gjk_epa")
    if bullet is None:
        return lines
    for method, start in (("signed_distance", "cold"), ("signed_distance_warm", "warm")):
        ours = methods[method]
        for key in times:
            if ours[key] > bullet[key]:
                lines.append(f"{pairs}, {start}: {name} has answered {key[1:-3]} % of them within {bullet[key]:.3g} us "
                             f"each, our signed distance within {ours[key]:.3g} us.")
        for key in errors:
            theirs, own = bullet[f"normal_error_m_{key}"], ours[f"normal_error_m_{key}"]
            if own > max(theirs, 1e-12):
                lines.append(f"{pairs}, {start}: the normals of {name} are within {theirs:.1e} m of the least "
                             f"translation for {SHARES[key]}, ours within {own:.1e} m.")
    return lines


def losses(times, replays, shapes):
    """Where a peer is ahead of ours in p50 or p99.99, or in error: the first thing to read."""
    lines = []
    for work, title in WORKS.items():
        for start in ("cold", "warm"):
            methods = of_work(times, work, start)
            if "growth" not in methods:
                continue
            ours = methods["growth"]
            for method in ("plain", "ie", "inc", "dcf", "dcol"):
                if method not in methods:
                    continue
                for key, name in (("p50_us", "half"), ("p99.99_us", "99.99 %")):
                    ratio = ours[key] / methods[method][key]
                    if ratio > 1:
                        lines.append(f"{title}, {start}: {SHORT[method]} has answered {name} of the queries within "
                                     f"{methods[method][key]:.3g} us each, ours within {ours[key]:.3g} us.")
    every_time = ("p0.01_us", "p25_us", "p50_us", "p75_us", "p99_us", "p99.99_us")
    for precision, rows in replays.items():
        lines += losses_of_distance("recorded pairs", rows, f"Bullet's GJK/EPA in {precision}", every_time,
                                    ("p50", "p99", "max"))
    for precision, rows in shapes.items():
        for work in dict.fromkeys(row["work"] for row in rows):
            kind, distance_class = shape_work(work)
            lines += losses_of_distance(f"{kind}, {distance_class}", [row for row in rows if row["work"] == work],
                                        f"Bullet's GJK/EPA in {precision}", ("p50_us", "p99_us"), ("max",))
    return lines


def winners(times):
    """A sentence a work: how far ours is from the next best."""
    lines = []
    for work, title in WORKS.items():
        methods = of_work(times, work)
        others = {key: row for key, row in methods.items() if key in ("plain", "ie", "inc", "dcf", "dcol")}
        if "growth" not in methods or not others:
            continue
        best = min(others, key=lambda key: others[key]["p50_us"])
        ratio = methods["growth"]["p50_us"] / others[best]["p50_us"]
        lines.append(f"{title}, cold: ours takes {methods['growth']['p50_us']:.3g} us, {ratio:.2f} of the best other "
                     f"method's ({SHORT[best]}, {others[best]['p50_us']:.3g} us); worst relative gap "
                     f"{methods['growth']['relative_gap_max']:.1e} against {others[best]['relative_gap_max']:.1e}.")
    return lines


def plot_error(times):
    """Time against achieved error: one curve a method, a point a tolerance."""
    works = [work for work in WORKS if any(row["work"] == work for row in times)]
    figure, axes = plt.subplots(2, math.ceil(len(works) / 2), figsize=(13, 8), squeeze=False, layout="constrained")
    for axis, work in zip(axes.flat, works):
        for method in ("growth", "plain", "ie", "inc", "dcf", "dcol"):
            points = sorted((row["p50_us"], max(row["relative_gap_p99"], LEAST)) for row in times
                            if row["work"] == work and row["method"] == method and row["pairs"] > 0)
            if points:
                axis.plot(*zip(*points), "o-", color=COLOURS[method], label=SHORT[method], markersize=4)
        axis.set(xscale="log", yscale="log", title=WORKS[work], xlabel="time of a query, median (us)",
                 ylabel="achieved relative gap, 99 %")
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    for axis in axes.flat[len(works):]:
        axis.set_visible(False)
    return figure


def plot_bars(times, start):
    """Solution times as in the paper's bar figure."""
    works = [work for work in WORKS if of_work(times, work, start)]
    methods = [m for m in ("ie", "dcf", "inc", "dcol", "plain", "growth") if any(m in of_work(times, w, start) for w in works)]
    figure, axis = plt.subplots(figsize=(13, 4.5), layout="constrained")
    width = 0.8 / len(methods)
    for m, method in enumerate(methods):
        for w, work in enumerate(works):
            row = of_work(times, work, start).get(method)
            if row is None:
                continue
            x = w + (m - (len(methods) - 1) / 2) * width
            axis.bar(x, row["p75_us"] - row["p25_us"], width * 0.9, bottom=row["p25_us"], color=COLOURS[method],
                     alpha=0.6, label=SHORT[method] if w == [i for i, v in enumerate(works)
                                                             if method in of_work(times, v, start)][0] else None)
            axis.plot([x - width * 0.45, x + width * 0.45], [row["p50_us"]] * 2, color=COLOURS[method], linewidth=2)
            axis.vlines(x, row["p0.01_us"], row["p99.99_us"], color=COLOURS[method], linewidth=0.8)
    axis.set(yscale="log", ylabel="time of a query (us)", title=f"{start} starts")
    axis.set_xticks(range(len(works)), [WORKS[work].replace(", ", ",\n") for work in works], fontsize=8)
    axis.grid(axis="y", alpha=0.3)
    axis.legend(ncols=len(methods), fontsize=8)
    return figure


def plot_vertices(rows):
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained", sharey=True)
    for axis, start in zip(axes, ("cold", "warm")):
        for method in ("growth", "plain", "ie", "inc", "dcol"):
            points = sorted((row["vertices"], row["p50_us"]) for row in rows
                            if base_of(row["method"]) == method and row["start"] == start and row["pairs"] > 0)
            if points:
                axis.plot(*zip(*points), "o-", color=COLOURS[method], label=SHORT[method], markersize=4)
        axis.set(xscale="log", yscale="log", xlabel="vertices of each set", title=start)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[0].set_ylabel("time of a query, median (us)")
    return figure


def plot_convergence(rows):
    classes = list(dict.fromkeys(row["class"] for row in rows))
    figure, axes = plt.subplots(1, len(classes), figsize=(5.5 * len(classes), 4.5), squeeze=False, layout="constrained")
    for axis, name in zip(axes[0], classes):
        for method in ("growth", "plain"):
            points = [row for row in rows if row["class"] == name and row["method"] == method]
            for key, line in (("gap_p50", "-"), ("gap_p99", ":")):
                axis.plot([row["iteration"] for row in points],
                          [row[key] if math.isfinite(row[key]) else None for row in points], line,
                          color=COLOURS[method], label=SHORT[method] if key == "gap_p50" else None)
        axis.set(yscale="log", ylim=(1e-17, 1e3), xlim=(1, 40), xlabel="iteration", title=WORKS.get(name, name))
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    axes[0][0].set_ylabel("relative gap of the bounds: median, dotted 99 %")
    return figure


def plot_replay(replays):
    """Time against the error of the normal, on the pairs that a simulation asks about."""
    figure, axes = plt.subplots(1, len(replays), figsize=(5.5 * len(replays), 4.5), squeeze=False, layout="constrained")
    for axis, (precision, rows) in zip(axes[0], replays.items()):
        for row in rows:
            method = base_of(row["method"])
            if row["normal_error_m_max"] is None or method not in COLOURS:
                continue
            times = [row["p50_us"], row["p99_us"]]
            errors = [max(row[key], LEAST) for key in ("normal_error_m_p50", "normal_error_m_max")]
            axis.plot(times, errors, "o-" if row["start"] == "cold" else "s--", color=COLOURS[method],
                      label=row["title"], markersize=5)
        axis.set(xscale="log", yscale="log", xlabel="time of a query: median to 99 % (us)",
                 title=f"Bullet in {precision}", ylim=(LEAST / 3, 1e3))
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7, loc="center left")
    axes[0][0].set_ylabel("error of the normal: median to worst (m)")
    return figure


def read_runs(folder):
    """precision -> narrowphase -> a list of runs, a seed each."""
    runs = {}
    for path in sorted(folder.glob("drop/*/seed_*/*.csv")):
        if path.stem in ("builtin", "dgd"):
            precision = {"float": "float", "float64": "double"}[path.parents[1].name]
            runs.setdefault(precision, {}).setdefault(path.stem, []).append(read_csv(path))
    return runs


def plot_drop(runs):
    figure, axes = plt.subplots(2, len(runs), figsize=(6 * len(runs), 7), squeeze=False, layout="constrained", sharex=True)
    names = {"builtin": ("Bullet's GJK/EPA", "#D55E00"), "dgd": ("ours", "#0072B2")}
    for column, (precision, by_name) in enumerate(runs.items()):
        for name, (label, colour) in names.items():
            for i, run in enumerate(by_name.get(name, [])):
                deep = [row for row in run if row["deepest_true_penetration_m"] is not None]
                axes[0][column].plot([row["time_s"] for row in deep],
                                     [1e3 * row["deepest_true_penetration_m"] for row in deep], color=colour,
                                     linewidth=0.6, alpha=0.7, label=label if i == 0 else None)
                axes[1][column].plot([row["time_s"] for row in run], [row["kinetic_energy_j"] for row in run],
                                     color=colour, linewidth=0.6, alpha=0.7, label=label if i == 0 else None)
        axes[0][column].set(title=f"Bullet in {precision}", ylabel="deepest true penetration (mm)")
        axes[1][column].set(yscale="log", xlabel="time (s)", ylabel="kinetic energy (J)")
        for axis in (axes[0][column], axes[1][column]):
            axis.grid(alpha=0.3)
            axis.legend(fontsize=8)
    return figure


def drop_sentence(precision, by_name):
    def median(values):
        return sorted(values)[len(values) // 2]

    def deepest(run):
        return max(row["deepest_true_penetration_m"] or 0 for row in run)

    def per_query(run):
        return sum(row["narrowphase_us"] for row in run) / max(1, sum(row["queries"] for row in run))

    bullet, ours = by_name["builtin"], by_name["dgd"]
    return (f"Bullet in {precision}, median of {len(ours)} seeds: the deepest true penetration is "
            f"{1e3 * median([deepest(run) for run in ours]):.1f} mm with ours and "
            f"{1e3 * median([deepest(run) for run in bullet]):.1f} mm with Bullet's GJK/EPA; a queried pair takes "
            f"{median([per_query(run) for run in ours]):.2f} us and {median([per_query(run) for run in bullet]):.2f} us.")


def solution_table(times, start):
    rows = []
    for work, title in WORKS.items():
        methods = of_work(times, work, start)
        if not methods:
            continue
        cells = [f"{methods[m]['p50_us']:.3g}" if m in methods else "unsupported" for m in TABLE_METHODS]
        ours = methods.get("growth")
        rows.append([title, *cells, f"{ours['primal_infeasibility_m_max']:.1e}" if ours else "",
                     f"{ours['exact_error_max']:.1e}" if ours and ours["exact_error_max"] is not None else "",
                     f"{ours['failures']:.0f}" if ours else ""])
    return rows


def shape_table(rows):
    """Columns, and a row a kind and method."""
    cells = {}
    for row in rows:
        if row["pairs"] == 0:
            continue
        kind, distance_class = shape_work(row["work"])
        error, bad = row["normal_error_m_max"], row["wrong"] + row["missing"]
        cells.setdefault((kind, row["title"]), {})[distance_class] = (
            f"{row['p50_us']:.3g} / {row['p99_us']:.3g}" + (f"; {error:.1e}" if error is not None else "") +
            (f"; {bad:.0f} wrong or missing" if bad > 0 else ""))
    classes = list(next(iter(cells.values())))
    return ["Bullet in float", "", *classes], [[*key, *(row[name] for name in classes)] for key, row in cells.items()]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    data = folder / "data"
    plt.rcParams.update({"font.family": "serif", "font.size": 10, "svg.fonttype": "path", "svg.hashsalt": "dgd"})
    times = read_csv(data / "solution_times.csv")
    vertices = read_csv(data / "vertex_count.csv")
    precisions = {"float": "float", "double": "float64"}
    replays = {name: read_csv(data / f"replay_{key}.csv") for name, key in precisions.items()}
    shapes = {name: read_csv(data / f"shape_pairs_{key}.csv") for name, key in precisions.items()}
    runs = read_runs(data)

    page = Page(folder)
    page.heading("Where a peer is ahead")
    lost = losses(times, replays, shapes)
    page.bullets(lost or ["Nowhere in what was measured."])
    page.heading("In short")
    page.bullets(winners(times) + [drop_sentence(precision, by_name) for precision, by_name in runs.items()])

    page.heading("1. Time against achieved error")
    page.figure(plot_error(times), "error", "Growth distance: the relative gap that answers have by their certificate, "
                "against the time of a query. A point a tolerance, 1e-3 to 1e-12; cold. Gaps of 0 are drawn at 1e-17.")
    page.heading("2. Solution times")
    for start in ("cold", "warm"):
        page.figure(plot_bars(times, start), f"times_{start}", f"Time of a query, {start}: 25 % to 75 % as bars, the median "
                    "as a line, 0.01 % and 99.99 % as whiskers.")
        page.prose(f"Median time of a query in us, {start}; of ours, the worst primal infeasibility in m, how far the "
                   "bounds are, relative, from what a linear program in extended precision says of sharp polytopes "
                   "(itself within 1e-13), and the answers that are not optimal:")
        page.table(["sets", *(SHORT[m] for m in TABLE_METHODS), "primal infeasibility", "off the exact answer",
                    "not optimal"],
                   solution_table(times, start))
    page.heading("3. Time against vertex count")
    page.figure(plot_vertices(vertices), "vertices", "Hulls of points on a sphere 1 m across. The paper's algorithm, as "
                "printed here, walks and scans hulls by our code.")
    page.heading("4. Convergence")
    page.figure(plot_convergence(read_csv(data / "convergence.csv")), "convergence", "Relative gap of the bounds after "
                "each iteration, an evaluation of both support functions; queries that have ended stay where they ended.")
    page.heading("5. Falling polytopes")
    page.figure(plot_replay(replays), "replay", "The pairs that fifty falling polytopes asked Bullet's narrowphase "
                "about, replayed on each method: error of the normal (the way to part the sets along it, over the "
                "least one), median and worst, against time, median and 99 %. Warm is from the step before. MPR answers "
                "overlaps alone.")
    page.table(["Bullet in float", "p50 (us)", "p99 (us)", "normal, worst (m)", "depth, worst (m)", "gap, worst", "wrong",
                "no answer"],
               [[str(row["title"]), f"{row['p50_us']:.3g}", f"{row['p99_us']:.3g}",
                 *(f"{row[key]:.1e}" if row[key] is not None else ""
                   for key in ("normal_error_m_max", "depth_error_m_max", "relative_gap_max")),
                 f"{row['wrong']:.0f}", f"{row['missing']:.0f}"] for row in replays["float"] if row["pairs"] > 0])
    page.figure(plot_drop(runs), "drop", "Fifty polytopes fall onto each other; a line a seed. The penetration is the true "
                "one, by an exact oracle.")
    for picture in sorted((data / "drop").glob("*/seed_1/end_state.png")):
        page.picture(picture, f"The end, Bullet in {picture.parents[1].name}: Bullet's GJK/EPA and ours.")
    page.heading("6. Pairs of shapes")
    page.prose("Random pairs by their signed distance: separated by 2 to 30 cm; 0.1 to 10 mm apart; touching within "
               "1 um; 0.1 to 10 mm deep; 5 to 15 cm deep. Median / 99 % of a query's time in us; the worst error of the "
               "normal in m, of which the growth distance has none:")
    page.table(*shape_table(shapes["float"]))
    page.heading("7. The machine")
    page.bullets((data / "machine.txt").read_text(encoding="utf-8").splitlines())
    page.write("dgd-bullet: speed against error")
    print(f"{folder / 'index.html'}: {len(lost)} places where a peer is ahead")


if __name__ == "__main__":
    main()
