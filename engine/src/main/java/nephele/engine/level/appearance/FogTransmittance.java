package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The effect of homogeneous fog on a view: the share exp(−extinction · metres) of the radiance behind passes (Beer and
 * Lambert), and the fog's own radiance replaces the rest. It applies between surface and eye only: light reaches
 * surfaces unattenuated. The twin of {@code fog.glsl}.
 *
 * @param radiance radiance of an infinite depth of fog, which is that of the sky seen through it
 */
public record FogTransmittance(double extinctionPerMetre, Vec3 radiance) {
    /** Returns the fog of an environment; empty if there is none or it attenuates nothing. */
    public static Optional<FogTransmittance> of(Environment environment) {
        Environment.Fog fog = environment.fog();
        return fog == null || fog.extinctionPerMetre() == 0
                ? Optional.empty()
                : Optional.of(new FogTransmittance(fog.extinctionPerMetre(), fog.radiance()));
    }

    /**
     * Returns radiance seen through the fog.
     *
     * @param metres distance from the eye to the source of {@code behind}; may be infinite
     */
    public Vector3d over(Vector3d behind, double metres) {
        return radiance.toVector().lerp(behind, transmittance(metres));
    }

    /** Returns the share of radiance that passes the fog. */
    public double transmittance(double metres) {
        return StrictMath.exp(-extinctionPerMetre * metres);
    }
}
