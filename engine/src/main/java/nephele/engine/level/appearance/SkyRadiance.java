package nephele.engine.level.appearance;

import java.util.Optional;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** The radiance of a sky in every direction. */
@FunctionalInterface
public interface SkyRadiance {
    /** Replaces computed scattering: a clear day, linear radiance. */
    Sky.Gradient ATMOSPHERE_STAND_IN =
            new Sky.Gradient(new Vec3(0.12, 0.28, 0.65), new Vec3(0.62, 0.74, 0.88), new Vec3(0.16, 0.15, 0.14));

    /** @return linear RGB for a unit direction, y up */
    Vector3d from(double x, double y, double z);

    /**
     * Returns the radiance of a sky.
     *
     * @param pictureOf decodes an asset; called for skyboxes only
     * @return empty without a sky
     */
    static Optional<SkyRadiance> of(Sky sky, Function<String, Picture> pictureOf, ColourDecoding decoding) {
        if (sky instanceof Sky.Constant constant) {
            return Optional.of((x, y, z) -> constant.radiance().toVector());
        } else if (sky instanceof Sky.Gradient gradient) {
            return Optional.of(of(gradient));
        } else if (sky instanceof Sky.Atmosphere) {
            return Optional.of(of(ATMOSPHERE_STAND_IN));
        } else if (sky instanceof Sky.Skybox box) {
            return Optional.of(SkyboxFaces.of(box, pictureOf, decoding)::radiance);
        }
        return Optional.empty();
    }

    private static SkyRadiance of(Sky.Gradient gradient) {
        return (x, y, z) -> {
            Vec3 end = y < 0 ? gradient.ground() : gradient.zenith();
            return gradient.horizon().toVector().lerp(end.toVector(), Math.min(Math.abs(y), 1));
        };
    }
}
