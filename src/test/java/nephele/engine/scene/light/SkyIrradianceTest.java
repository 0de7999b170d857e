package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Sky;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class SkyIrradianceTest {
    private static final double[][] NORMALS = {
        {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, {0.6, 0.8, 0}, {0, -0.6, 0.8}, {0.48, 0.6, 0.64}
    };

    @Test
    void constantSkyGivesItsOwnRadianceEverywhere() {
        SkyIrradiance sky = of(new Sky.Constant(new Vec3(0.2, 0.3, 0.5)));
        for (double[] n : NORMALS) {
            assertEquals(0, sky.ambient(n[0], n[1], n[2]).distance(0.2, 0.3, 0.5), 1e-5);
        }
    }

    /** Nine coefficients match the integral: Ramamoorthi and Hanrahan state 3 % at worst, 1 % on average. */
    @Test
    void gradientSkyAgreesWithTheIntegralWithinThreePercent() {
        Sky gradient = new Sky.Gradient(new Vec3(0.2, 0.5, 1), new Vec3(1, 0.9, 0.8), new Vec3(0.1, 0.1, 0.05));
        SkyRadiance radiance =
                SkyRadiance.of(gradient, id -> null, ColourDecoding.SRGB).orElseThrow();
        SkyIrradiance sky = SkyIrradiance.of(radiance);
        for (double[] n : NORMALS) {
            Vector3d normal = new Vector3d(n[0], n[1], n[2]);
            double error = sky.ambient(n[0], n[1], n[2]).distance(integral(radiance, normal));
            assertEquals(0, error, 0.03, "normal " + normal);
        }
    }

    private static SkyIrradiance of(Sky sky) {
        return SkyIrradiance.of(
                SkyRadiance.of(sky, id -> null, ColourDecoding.SRGB).orElseThrow());
    }

    private static Vector3d integral(SkyRadiance radiance, Vector3d normal) {
        Vector3d sum = new Vector3d();
        double weights = 0;
        int n = 120;
        for (int i = 0; i < n; i++) {
            double y = 2 * (i + 0.5) / n - 1;
            double r = Math.sqrt(1 - y * y);
            for (int j = 0; j < n; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / n;
                Vector3d d = new Vector3d(r * Math.cos(angle), y, r * Math.sin(angle));
                double cosine = Math.max(0, d.dot(normal));
                weights += cosine;
                sum.add(radiance.from(d.x, d.y, d.z).mul(cosine));
            }
        }
        return sum.div(weights);
    }
}
