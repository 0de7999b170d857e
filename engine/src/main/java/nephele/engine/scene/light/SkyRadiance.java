package nephele.engine.scene.light;

import java.util.Optional;
import java.util.function.Function;
import nephele.engine.asset.Picture;
import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** What a sky sends from a direction that meets nothing. */
@FunctionalInterface
public interface SkyRadiance {
    /** @return linear RGB for a unit direction, y up */
    Vector3d from(double x, double y, double z);

    /**
     * @param pictureOf decodes an asset; asked for skyboxes only
     * @return empty for a sky that is not described by its level alone
     */
    static Optional<SkyRadiance> of(Sky sky, Function<String, Picture> pictureOf) {
        if (sky instanceof Sky.Constant constant) {
            return Optional.of((x, y, z) -> constant.radiance().toVector());
        } else if (sky instanceof Sky.Gradient gradient) {
            return Optional.of((x, y, z) -> {
                Vec3 end = y < 0 ? gradient.ground() : gradient.zenith();
                return gradient.horizon().toVector().lerp(end.toVector(), Math.min(Math.abs(y), 1));
            });
        } else if (sky instanceof Sky.Skybox box) {
            return Optional.of(SkyboxFaces.of(box, pictureOf)::radiance);
        }
        return Optional.empty();
    }
}
