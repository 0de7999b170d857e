package nephele.engine.reference.sky;

import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.Surroundings;
import org.joml.Vector3d;

/**
 * A sky as the paths of light meet it, some times a sample. That of an atmosphere is a random number with the mean of its
 * integration: nearly always the value of a lattice, and once in {@value #MEETINGS} times that many differences of both
 * besides. For any number of threads.
 */
public final class SkyOfPaths {
    private static final int MEETINGS = 64;

    private final SkyRadiance exact;
    /** {@code null} for a sky that needs none. */
    private final Surroundings lattice;

    private SkyOfPaths(SkyRadiance exact, Surroundings lattice) {
        this.exact = exact;
        this.lattice = lattice;
    }

    /** Returns the sky of an environment whose eyes see {@code exact}. */
    public static Optional<SkyOfPaths> of(Environment environment, Optional<SkyRadiance> exact) {
        boolean isIntegrated = environment.sky() instanceof Sky.Atmosphere;
        return exact.map(sky -> new SkyOfPaths(sky, isIntegrated ? OverPlanet.of(environment, 1) : null));
    }

    /**
     * Returns RGB radiance; a channel may be negative.
     *
     * @param height y of the place that light reaches
     * @param from unit vector to where it comes from
     */
    public Vector3d radiance(double height, Vec3 from, SplittableRandom random) {
        if (lattice == null) {
            return exact.from(height, from.x(), from.y(), from.z());
        }
        Vector3d quick = lattice.skylight(new Vec3(0, height, 0), from).toVector();
        if (random.nextInt(MEETINGS) > 0) {
            return quick;
        }
        Vector3d difference = exact.from(height, from.x(), from.y(), from.z()).sub(quick);
        return quick.fma(MEETINGS, difference);
    }
}
