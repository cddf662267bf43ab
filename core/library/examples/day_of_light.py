"""Light over a day: the sun on a surface that faces it, and sun and sky on level ground, in lux.

    python3 day_of_light.py [DATE LATITUDE LONGITUDE [HOURS [PICTURE.png]]]

Prints a line every so many HOURS (1) by UTC; with a picture's name also draws it, by matplotlib.
"""

import sys

import airlight

given = sys.argv[1:]
date, latitude, longitude, step = given[:4] + ["2026-06-21", "48.85", "2.35", "1"][len(given):]
session = airlight.Session()
rows = []
for hour in range(0, 24, int(step)):
    time = f"{hour:02}:00"
    light = session.irradiance("earth-physical", date=date, time=time, lat=float(latitude), lon=float(longitude))
    if light.sun.elevation_deg < -12:
        continue

    def lux(rgb):
        """Luminance of linear Rec.709; earth-physical's sun is in lux."""
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]

    direct = lux(light.sun.irradiance)
    sky = lux(light.map[0].mean(axis=0))  # normals 2.8 degrees from straight up
    level = sky + direct * max(0.0, light.sun.direction[1])
    rows.append((hour, light.sun.elevation_deg, direct, sky, level))
    print(f"{time}  sun {light.sun.elevation_deg:6.2f}  direct {direct:8.0f}  sky {sky:8.0f}  level {level:8.0f} lux")

if len(given) > 4:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    hours = [row[0] for row in rows]
    for name, at in (("sun, on a surface that faces it", 2), ("sky, on level ground", 3), ("both, on level ground", 4)):
        pyplot.plot(hours, [row[at] / 1000 for row in rows], label=name)
    pyplot.xlabel(f"hour (UTC), {date} at {latitude}, {longitude}")
    pyplot.ylabel("kilolux")
    pyplot.legend()
    pyplot.savefig(given[4], dpi=100)
