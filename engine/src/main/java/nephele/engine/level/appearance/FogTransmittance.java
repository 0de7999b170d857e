package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.level.Environment;
import nephele.engine.level.Fog;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * What homogeneous fog does to a view: of what lies behind it the share exp(−extinction · metres) passes (Beer and
 * Lambert), and the fog's own radiance fills up the rest. It lies on the way from a surface to the eye only: light
 * reaches surfaces undimmed. The twin of {@code fog.glsl}.
 *
 * @param radiance of infinitely much fog: that of the sky seen through it
 */
public record FogTransmittance(double extinctionPerMetre, Vec3 radiance) {
    /** Empty where there is no fog, or none that dims. */
    public static Optional<FogTransmittance> of(Environment environment) {
        Fog fog = environment.fog();
        return fog == null || fog.extinctionPerMetre() == 0
                ? Optional.empty()
                : Optional.of(new FogTransmittance(fog.extinctionPerMetre(), fog.radiance()));
    }

    /** @param metres from the eye to what sends {@code behind}; may be infinite */
    public Vector3d over(Vector3d behind, double metres) {
        return radiance.toVector().lerp(behind, StrictMath.exp(-extinctionPerMetre * metres));
    }
}
