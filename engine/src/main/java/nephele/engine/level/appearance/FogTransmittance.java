package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The effect of fog on a view: the share exp(−optical depth) of the radiance behind passes (Beer and Lambert), and the
 * fog's own radiance replaces the rest. It applies between surface and eye only: light reaches surfaces unattenuated.
 * The extinction is the same everywhere, or up to a base only, above which it falls by 1/e in each scale height. Behind
 * an opening the whole path counts as straight, in the space that it ends in. The twin of {@code fog.glsl}.
 *
 * @param radiance radiance of an infinite depth of fog
 * @param baseAltitudeMetres not used in fog without end
 * @param scaleHeightMetres positive; infinite for fog without end
 */
public record FogTransmittance(
        double extinctionPerMetre, Vec3 radiance, double baseAltitudeMetres, double scaleHeightMetres) {
    /** The part of a scale height below which (1 − exp(−x)) / x is its series. */
    private static final double SERIES_BELOW = 1e-2;

    /** Returns the fog of an environment; empty if there is none or it attenuates nothing. */
    public static Optional<FogTransmittance> of(Environment environment) {
        Environment.Fog fog = environment.fog();
        return fog == null || fog.extinctionPerMetre() == 0
                ? Optional.empty()
                : Optional.of(new FogTransmittance(
                        fog.extinctionPerMetre(),
                        fog.radiance(),
                        fog.baseAltitudeMetres(),
                        fog.isEndless() ? Double.POSITIVE_INFINITY : fog.scaleHeightMetres()));
    }

    /** Returns true if the fog of an environment has no end, so that nothing at an infinite distance is seen through it. */
    public static boolean hidesSky(Environment environment) {
        return of(environment).filter(FogTransmittance::isEndless).isPresent();
    }

    public boolean isEndless() {
        return Double.isInfinite(scaleHeightMetres);
    }

    /** Returns an altitude above the base in scale heights; 0 in fog without end. */
    public double scaledAltitude(double altitudeMetres) {
        return isEndless() ? 0 : (altitudeMetres - baseAltitudeMetres) / scaleHeightMetres;
    }

    /**
     * Returns radiance seen through the fog.
     *
     * @param eyeAltitudeMetres altitude of the (straight) path's beginning
     * @param rise y of the unit vector along the path
     * @param metres distance from the eye to the source of {@code behind}; may be infinite
     */
    public Vector3d over(Vector3d behind, double eyeAltitudeMetres, double rise, double metres) {
        return radiance.toVector().lerp(behind, transmittance(eyeAltitudeMetres, rise, metres));
    }

    /** Returns the share of radiance that passes the fog; parameters as in {@link #over}. */
    public double transmittance(double eyeAltitudeMetres, double rise, double metres) {
        double from = scaledAltitude(eyeAltitudeMetres);
        if (isEndless()) {
            return StrictMath.exp(-extinctionPerMetre * metres);
        }
        if (Double.isInfinite(metres)) {
            double above = from < 0 ? 1 - from : StrictMath.exp(-from);
            return rise <= 0 ? 0 : StrictMath.exp(-extinctionPerMetre * scaleHeightMetres * above / rise);
        }
        return StrictMath.exp(
                -extinctionPerMetre * metres * meanDensity(from, from + rise * metres / scaleHeightMetres));
    }

    /** Returns the mean of exp(−max(0, x)) between two scaled altitudes. */
    private static double meanDensity(double from, double to) {
        double low = Math.min(from, to);
        double high = Math.max(from, to);
        double lowAbove = Math.max(0, low);
        double above = Math.max(0, high) - lowAbove;
        double fraction = above > 0 ? above / (high - low) : low > 0 ? 1 : 0;
        double decay = above < SERIES_BELOW ? 1 - above * (0.5 - above / 6) : (1 - StrictMath.exp(-above)) / above;
        return 1 - fraction + fraction * StrictMath.exp(-lowAbove) * decay;
    }
}
