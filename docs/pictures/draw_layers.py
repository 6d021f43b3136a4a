#!/usr/bin/env python3
"""Draws docs/pictures/layers.svg: the folders below ganglion/ and who includes whom, as the sources have it.

The order of the layers is read from GANGLION_LAYERS in cmake/GanglionTargets.cmake, the arrows from the #include lines.
An arrow that others already imply is left out. With --check nothing is written: the exit code is 1 if the picture on the
disk is another, or if an include points up.
"""
import pathlib
import re
import sys
from html import escape

from layered import arrange

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs/pictures/layers.svg"

ROLES = {  # fill, border, English, Spanish
    "ground": ("#eef1f4", "#5b6b7b", "values and words", "valores y palabras"),
    "contract": ("#e3f1ec", "#118568", "contracts and tools of kinds", "contratos y herramientas de los tipos"),
    "kind": ("#fbeedd", "#ac6212", "one folder for each kind", "una carpeta por tipo"),
    "joint": ("#e4eaf5", "#1c437e", "what joins and carries them", "lo que los une y transporta"),
    "shown": ("#f3e4fb", "#8a1fc4", "runs and what is left of them", "ejecuciones y lo que queda de ellas"),
}
FOLDERS = {  # role, English, Spanish
    "base": ("ground", "results, located errors", "resultados, errores con lugar"),
    "math": ("ground", "the same bits everywhere", "los mismos bits en todas partes"),
    "units": ("ground", "angles, speed of sound", "ángulos, velocidad del sonido"),
    "geometry": ("ground", "vectors and poses", "vectores y poses"),
    "random": ("ground", "draws by seed and tick", "sorteos por semilla y ciclo"),
    "exhibit": ("ground", "what is shown, by form", "lo que se muestra, por forma"),
    "descriptor": ("ground", "what kinds say of themselves", "lo que los tipos dicen de sí"),
    "config": ("ground", "TOML with places", "TOML con lugares"),
    "application": ("ground", "frames, self-description", "tramas, autodescripción"),
    "module": ("contract", "what every component is", "lo que es cada componente"),
    "fuzzy": ("contract", "fuzzy engine and its files", "motor difuso y sus archivos"),
    "grid": ("contract", "maps with risk, routes", "mapas con riesgo, rutas"),
    "goal": ("kind", "global goals", "objetivos globales"),
    "sensing": ("kind", "sensing modules", "módulos de detección"),
    "acting": ("kind", "acting modules", "módulos de actuación"),
    "coordination": ("kind", "coordinators", "coordinadores"),
    "task": ("kind", "tasks of an application", "tareas de una aplicación"),
    "measure": ("kind", "figures of a run", "medidas de una ejecución"),
    "sim": ("kind", "simulated worlds and robots", "mundos y robots simulados"),
    "plant": ("kind", "simulated plants", "plantas simuladas"),
    "graph": ("joint", "file to schedule; the tick", "de archivo a plan; el ciclo"),
    "kinds": ("joint", "the one list of kinds", "la única lista de tipos"),
    "link": ("joint", "robots elsewhere", "robots en otra parte"),
    "record": ("shown", "run files, catalogue", "archivos de ejecución, catálogo"),
    "experience": ("shown", "what was learned", "lo aprendido"),
    "run": ("shown", "experiment to run", "de experimento a ejecución"),
    "plot": ("shown", "pictures", "imágenes"),
    "report": ("shown", "the page of a run", "la página de una ejecución"),
    "lab": ("shown", "jobs and outcomes", "encargos y resultados"),
    "firmware": ("shown", "export to C", "exportación a C"),
    "studio": ("shown", "server of the studio", "servidor del estudio"),
}
WIDTH, HEIGHT, GAP_X, GAP_Y, MARGIN, LANE = 216, 62, 22, 58, 24, 14


def ranks():
    """Place of each folder in GANGLION_LAYERS; folders that stand beside each other have the same."""
    text = (ROOT / "cmake/GanglionTargets.cmake").read_text()
    layers = re.findall(r'"([^"]+)"', re.search(r"set\(GANGLION_LAYERS(.*?)\)", text, re.S)[1])
    return {folder: rank for rank, layer in enumerate(layers, 1) for folder in layer.split("|")}


def is_test(path):
    return "testing" in path.parts or re.search(r"(^|_)test", path.stem) is not None


def edges(folders):
    """{folder: folders its sources include}, tests aside; and the folders whose kinds the build lists."""
    uses, listed = {folder: set() for folder in folders}, set()
    for folder in folders:
        for path in sorted((ROOT / "ganglion" / folder).rglob("*")):
            if path.name == "CMakeLists.txt" and "ganglion_kind_folders(" in path.read_text():
                listed.add(folder)
            if path.suffix in (".h", ".cpp", ".in") and not is_test(path.relative_to(ROOT)):
                uses[folder].update(re.findall(r'#include "ganglion/(\w+)/', path.read_text()))
        uses[folder] &= set(folders) - {folder}
    return uses, listed


def reduced(uses):
    """Without the edges that longer ways imply."""
    below = {}

    def reach(folder):
        if folder not in below:
            below[folder] = set(uses[folder]).union(*[reach(other) for other in uses[folder]])
        return below[folder]

    return {folder: {one for one in direct if not any(one in reach(other) for other in direct if other != one)}
            for folder, direct in uses.items()}


def box(folder, rank, left, top):
    role, english, spanish = FOLDERS[folder]
    fill, border = ROLES[role][:2]
    return (f'<rect x="{left}" y="{top}" width="{WIDTH}" height="{HEIGHT}" rx="6" fill="{fill}" stroke="{border}"/>\n'
            f'<text x="{left + 10}" y="{top + 21}" class="name">{escape(folder)}</text>\n'
            f'<text x="{left + WIDTH - 10}" y="{top + 21}" class="rank">{rank}</text>\n'
            f'<text x="{left + 10}" y="{top + 38}">{escape(english)}</text>\n'
            f'<text x="{left + 10}" y="{top + 53}" class="spanish">{escape(spanish)}</text>\n')


def arrow(points, listed):
    """From the user's lower edge through the lanes between boxes to the upper edge of what is used."""
    path = f"M{points[0][0]} {points[0][1]}"
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        bend = (y1 - y0) / 2
        path += f" C{x0} {y0 + bend:g} {x1} {y1 - bend:g} {x1} {y1}"
    kind = "listed" if listed else "uses"
    return f'<path d="{path}" class="{kind}" marker-end="url(#{kind})"/>\n'


def legend(top):
    out, left = "", MARGIN
    for fill, border, english, spanish in ROLES.values():
        out += (f'<rect x="{left}" y="{top}" width="16" height="16" rx="3" fill="{fill}" stroke="{border}"/>\n'
                f'<text x="{left + 24}" y="{top + 12}">{english}</text>\n'
                f'<text x="{left + 24}" y="{top + 27}" class="spanish">{spanish}</text>\n')
        left += 276
    lines = (("uses", "includes; arrows that others imply are left out",
              "incluye; se omiten las flechas que otras implican"),
             ("listed", "lists its kinds, by the build", "enumera sus tipos, al compilar"))
    left, top = MARGIN, top + 44
    for kind, english, spanish in lines:
        out += (f'<path d="M{left} {top + 8} H{left + 40}" class="{kind}" marker-end="url(#{kind})"/>\n'
                f'<text x="{left + 54}" y="{top + 12}">{english}</text>\n'
                f'<text x="{left + 54}" y="{top + 27}" class="spanish">{spanish}</text>\n')
        left += 420
    return out + (f'<text x="{left}" y="{top + 12}">number: place in the order of the layers</text>\n'
                  f'<text x="{left}" y="{top + 27}" class="spanish">número: lugar en el orden de las capas</text>\n')


HEAD = """<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}">
<title>The layers of ganglion/ and their includes</title>
<style>
text {{ font: 12px "DejaVu Sans", Verdana, sans-serif; fill: #20262c; }}
.name {{ font-weight: bold; font-size: 14px; }}
.rank {{ text-anchor: end; fill: #5b6b7b; }}
.spanish {{ fill: #55606b; font-style: italic; }}
path {{ fill: none; stroke-width: 1.4; }}
.uses {{ stroke: #41505e; }}
.listed {{ stroke: #ac6212; stroke-dasharray: 5 4; }}
</style>
<defs>
<marker id="uses" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto">
<path d="M0 0 L8 4 L0 8 z" style="fill: #41505e; stroke: none"/></marker>
<marker id="listed" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto">
<path d="M0 0 L8 4 L0 8 z" style="fill: #ac6212; stroke: none"/></marker>
</defs>
<rect width="100%" height="100%" fill="#ffffff"/>
"""


def draw():
    rank = ranks()
    folders = sorted(path.name for path in (ROOT / "ganglion").iterdir() if path.is_dir())
    for folder in folders:
        if folder not in rank or folder not in FOLDERS:
            sys.exit(f"ganglion/{folder} is not in GANGLION_LAYERS, or has no words in {pathlib.Path(__file__).name}")
    uses, listed = edges(folders)
    for folder, others in uses.items():
        for other in others:
            if rank[other] >= rank[folder]:
                sys.exit(f"ganglion/{folder} includes ganglion/{other}, which is not below it")
    if "kinds" in uses:
        uses["kinds"] |= listed
    shown = reduced(uses)
    if "kinds" in shown:
        shown["kinds"] |= listed  # drawn whether implied or not
    places, ways, width, rows = arrange(shown, WIDTH, GAP_X, LANE)
    top = {row: MARGIN + (rows - 1 - row) * (HEIGHT + GAP_Y) for row in range(rows)}
    width = max(width + 2 * MARGIN, 5 * 276 + 2 * MARGIN)
    foot = MARGIN + rows * (HEIGHT + GAP_Y)
    picture = HEAD.format(width=width, height=foot + 44 + 32 + MARGIN)
    for (user, used), lanes in sorted(ways.items()):
        points = [(MARGIN + lanes[0][0], top[lanes[0][1]] + HEIGHT)]
        for x, row in lanes[1:-1]:
            points += [(MARGIN + x, top[row]), (MARGIN + x, top[row] + HEIGHT)]
        points.append((MARGIN + lanes[-1][0], top[lanes[-1][1]]))
        picture += arrow(points, user == "kinds" and used in listed)
    for folder, (x, row) in sorted(places.items()):
        picture += box(folder, rank[folder], MARGIN + x - WIDTH // 2, top[row])
    return picture + legend(foot) + "</svg>\n"


def main():
    picture = draw()
    if "--check" not in sys.argv[1:]:
        PICTURE.write_text(picture)
    elif not PICTURE.exists() or PICTURE.read_text() != picture:
        sys.exit("docs/pictures/layers.svg does not show the sources as they are; run docs/pictures/draw_layers.py")


if __name__ == "__main__":
    main()
