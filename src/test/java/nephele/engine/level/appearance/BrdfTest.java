package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class BrdfTest {
    private static final Vector3d UP = new Vector3d(0, 0, 1);
    private static final Vector3d WHITE = new Vector3d(1);

    /** White metal and a white insulator of any roughness return equal light from all directions completely. */
    @Test
    void whiteFurnaceUnderAmbientLightIsExactlyWhite() {
        for (double roughness = 0; roughness <= 1; roughness += 0.1) {
            for (double nDotV = -1; nDotV <= 1; nDotV += 0.1) {
                for (int metallic = 0; metallic <= 1; metallic++) {
                    Brdf brdf = Brdf.of(WHITE, roughness, metallic, nDotV);
                    double returned =
                            brdf.diffuse().x() + brdf.ambientSpecular().x();
                    assertEquals(1, returned, 1e-12, "roughness " + roughness + ", n·v " + nDotV);
                }
            }
        }
    }

    /** White metal returns 1 within the fit's bound over all directions of light, and no material returns more. */
    @Test
    void whiteFurnaceUnderManyLightsKeepsEnergy() {
        for (double roughness : new double[] {0.4, 0.7, 1}) {
            for (double nDotV : new double[] {0.1, 0.3, 0.6, 1}) {
                String where = "roughness " + roughness + ", n·v " + nDotV;
                assertEquals(1, returned(Brdf.of(WHITE, roughness, 1, nDotV), nDotV), 0.06, "metal, " + where);
                assertEquals(1, returned(Brdf.of(WHITE, roughness, 0, nDotV), nDotV), 0.05, "insulator, " + where);
            }
        }
    }

    @Test
    void fitsStayWithinTheirStatedBound() {
        for (double roughness : new double[] {0.1, 0.3, 0.5, 0.8, 1}) {
            for (double mu : new double[] {0.05, 0.2, 0.5, 0.9}) {
                double[] integral = albedo(roughness, mu);
                assertEquals(
                        1 / integral[0],
                        Brdf.inverseDirectionalAlbedo(roughness, mu),
                        0.05,
                        "1/E at " + roughness + ", " + mu);
                assertEquals(integral[1], Brdf.grazingAlbedo(roughness, mu), 0.047, "B at " + roughness + ", " + mu);
            }
        }
    }

    /** The result is finite and not negative for any input. */
    @Test
    void randomAndDegenerateInputsStayFinite() {
        SplittableRandom random = new SplittableRandom(43);
        double[] odd = {0, -0.0, 1e-30, 1, -1, 2, 1e9, -1e9};
        for (int i = 0; i < 20_000; i++) {
            double roughness = i % 3 == 0 ? odd[random.nextInt(odd.length)] : random.nextDouble();
            double metallic = i % 5 == 0 ? odd[random.nextInt(odd.length)] : random.nextDouble();
            Vector3d n = unit(random);
            Vector3d v = i % 7 == 0 ? new Vector3d(n).negate() : unit(random);
            Vector3d l = i % 11 == 0 ? new Vector3d(v).negate() : i % 13 == 0 ? new Vector3d(n) : unit(random);
            Vector3d colour = new Vector3d(random.nextDouble(), random.nextDouble(), 0);
            Vector3d out = Brdf.of(colour, roughness, metallic, n.dot(v)).reflected(n, v, l);
            assertTrue(out.isFinite() && out.x >= 0 && out.y >= 0 && out.z >= 0, "input " + i + " gave " + out);
        }
    }

    /** Returns Σ f cos over a fine grid of directions; the lobe is smooth at these roughnesses. */
    private static double returned(Brdf brdf, double nDotV) {
        Vector3d toEye = new Vector3d(Math.sqrt(1 - nDotV * nDotV), 0, nDotV);
        int rings = 200;
        int sectors = 200;
        double sum = 0;
        for (int i = 0; i < rings; i++) {
            double z = (i + 0.5) / rings;
            double r = Math.sqrt(1 - z * z);
            for (int j = 0; j < sectors; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / sectors;
                sum += brdf.reflected(UP, toEye, new Vector3d(r * Math.cos(angle), r * Math.sin(angle), z)).x;
            }
        }
        return sum * 2 * Math.PI / (rings * sectors);
    }

    /** Returns E for f0 = 1 from importance-sampled half vectors of the lobe, and the part weighted with (1 − v·h)⁵. */
    private static double[] albedo(double roughness, double mu) {
        Brdf brdf = Brdf.of(WHITE, roughness, 1, mu);
        Vector3d toEye = new Vector3d(Math.sqrt(1 - mu * mu), 0, mu);
        int n = 4096;
        double all = 0;
        double grazing = 0;
        for (int i = 0; i < n; i++) {
            double u = (i + 0.5) / n;
            double angle = 2 * Math.PI * (Integer.toUnsignedLong(Integer.reverse(i)) * 0x1p-32);
            double cos = Math.sqrt((1 - u) / (1 + (brdf.alpha2() - 1) * u));
            double sin = Math.sqrt(Math.max(0, 1 - cos * cos));
            Vector3d h = new Vector3d(sin * Math.cos(angle), sin * Math.sin(angle), cos);
            double vDotH = toEye.dot(h);
            double nDotL = 2 * vDotH * cos - mu;
            if (vDotH > 0 && nDotL > 0) {
                double weight =
                        Reflectance.visibility(brdf.alpha2(), brdf.nDotV(), nDotL) * nDotL * 4 * vDotH / cos / n;
                all += weight;
                grazing += weight * Math.pow(1 - vDotH, 5);
            }
        }
        return new double[] {all, grazing};
    }

    private static Vector3d unit(SplittableRandom random) {
        double z = 2 * random.nextDouble() - 1;
        double angle = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(1 - z * z);
        return new Vector3d(r * Math.cos(angle), r * Math.sin(angle), z);
    }
}
