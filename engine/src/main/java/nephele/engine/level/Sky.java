package nephele.engine.level;

import java.util.List;
import nephele.engine.math.Vec3;

/** Radiance from every direction in which a ray hits nothing, linear RGB. */
public sealed interface Sky {
    /** {@code "kind": "constant"}. */
    record Constant(@Written(required = true, min = 0, max = 1e9) Vec3 radiance) implements Sky {}

    /** {@code "kind": "gradient"}: a function of the sine of the altitude: horizon at 0, zenith at 1, ground at −1. */
    record Gradient(
            @Written(required = true, min = 0, max = 1e9) Vec3 zenith,
            @Written(required = true, min = 0, max = 1e9) Vec3 horizon,
            @Written(absent = "[0, 0, 0]", min = 0, max = 1e9) Vec3 ground)
            implements Sky {}

    /**
     * {@code "kind": "skybox"}.
     *
     * @param layout the order and orientation of the files, described in docs/skyboxes.md
     * @param files asset ids: one for {@link SkyboxLayout#CROSS}; else six of one square size in the layout's order,
     *     +x, −x, +y, −y, +z, −z for FACES and OPENGL, rt, bk, lf, ft, up, dn for QUAKE2, and front, right, back, left,
     *     up, down for TERRAGEN
     */
    record Skybox(
            @Written(absent = "\"faces\"") SkyboxLayout layout,
            @Written(required = true, text = TextKind.ASSET, most = 6) List<String> files)
            implements Sky {}

    /** {@code "kind": "atmosphere"}: computed scattering. */
    record Atmosphere() implements Sky {}
}
