# SPDX-FileCopyrightText: 2026 The Repose developers
# SPDX-License-Identifier: BSD-3-Clause
"""Write src/colour-maps.ts: matplotlib's colour maps as hexadecimal stops.

    python3 scripts/colour_maps.py > src/colour-maps.ts
"""

import matplotlib

STOPS = 48


def stops(name):
    colours = matplotlib.colormaps[name]
    return "".join("".join(f"{round(255 * part):02x}" for part in colours(i / (STOPS - 1))[:3]) for i in range(STOPS))


def wrapped(text, width=114):
    return " +\n".join(f'    "{text[i:i + width]}"' for i in range(0, len(text), width))


print("// SPDX-FileCopyrightText: 2026 The Repose developers")
print("// SPDX-License-Identifier: BSD-3-Clause")
print("// Written by scripts/colour_maps.py from matplotlib's maps (CC0). Do not edit.")
print(f"\n/** {STOPS} stops each at equal distances, six hexadecimal digits a stop. */")
print("export const stopsOfMaps: Record<string, string> = {")
for name in ("viridis", "magma", "cividis", "coolwarm"):
    print(f"  {name}:\n{wrapped(stops(name))},")
print("};")
