package nephele.engine.atmosphere;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Vec3;

/** A row of the tables of a clear sky's radiance by another program; degrees and metres, radiance per irradiance. */
public record AtmosphereRow(
        String text,
        double eyeHeight,
        double sunElevation,
        double viewElevation,
        double azimuth,
        double[] radiance,
        double[] standardError) {

    public static List<AtmosphereRow> read(String name) {
        try (BufferedReader lines = new BufferedReader(
                new InputStreamReader(AtmosphereRow.class.getResourceAsStream(name), StandardCharsets.UTF_8))) {
            return lines.lines().skip(1).map(AtmosphereRow::of).toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static AtmosphereRow of(String line) {
        double[] n =
                Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
        double[] error = n.length > 7 ? Arrays.copyOfRange(n, 7, 10) : new double[3];
        return new AtmosphereRow(line, n[0], n[1], n[2], n[3], Arrays.copyOfRange(n, 4, 7), error);
    }

    /** Returns the direction of the view; the sun is in the direction of −z. */
    public Vec3 direction() {
        double view = Math.toRadians(viewElevation);
        double around = Math.toRadians(azimuth);
        return new Vec3(Math.cos(view) * Math.sin(around), Math.sin(view), -Math.cos(view) * Math.cos(around));
    }

    /** Returns true within a relative error, four sigma and a share of the brightest channel. */
    public boolean isMetBy(Vec3 computed, double relative, double ofBrightest) {
        double[] rgb = {computed.x(), computed.y(), computed.z()};
        double brightest = Math.max(radiance[0], Math.max(radiance[1], radiance[2]));
        for (int c = 0; c < 3; c++) {
            double most = relative * radiance[c] + 4 * standardError[c] + ofBrightest * brightest;
            if (!(Math.abs(rgb[c] - radiance[c]) <= most)) {
                return false;
            }
        }
        return true;
    }

    /** Points a ray as the row says. */
    void aim(AirRay ray) {
        double sun = Math.toRadians(sunElevation);
        double view = Math.toRadians(viewElevation);
        double between =
                Math.sin(sun) * Math.sin(view) + Math.cos(sun) * Math.cos(view) * Math.cos(Math.toRadians(azimuth));
        ray.set(eyeHeight, Math.sin(view), Math.sin(sun), between);
    }
}
