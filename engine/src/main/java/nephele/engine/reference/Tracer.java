package nephele.engine.reference;

import nephele.engine.math.Vec3;
import nephele.engine.reference.SampleSequence.PixelSample;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Traces radiance for one thread. */
final class Tracer {
    private final TracedLevel level;
    private final Pinhole eye;
    private final Vector3dc from;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;
    /** {@code null} for direct light alone. */
    private final PathIntegrator bounced;

    Tracer(TracedLevel level, Pinhole eye, EyePath path, Shafts.ShadowRays shadows, PathIntegrator bounced) {
        this.level = level;
        this.eye = eye;
        this.path = path;
        this.shadows = shadows;
        this.bounced = bounced;
        clouds = level.cloudSight().orElse(null);
        from = eye.eye().toVector();
    }

    /** Returns the radiance that reaches the eye along a ray, see {@link Pinhole#direction}. */
    Vector3d radiance(Vector3d direction, PixelSample sample) {
        boolean isMet = path.trace(from, direction, eye.nearMetres(), eye.farMetres());
        CloudSight.Met cloud = clouds == null ? null : clouds.first(path, sample.random());
        if (cloud != null) {
            Vector3d radiance = level.fromCloud(cloud, clouds, path, sample.random());
            level.exits().addTo(radiance, path, cloud.metres(), level);
            return radiance;
        }
        Vector3d radiance = isMet ? fromSurface(sample) : fromSky(sample);
        level.exits().addTo(radiance, path, Double.POSITIVE_INFINITY, level);
        return radiance;
    }

    private Vector3d fromSky(PixelSample sample) {
        Vector3d sky = level.fromSky(path, sample.random());
        return bounced == null ? sky : sky.add(level.fromDiscs(path));
    }

    private Vector3d fromSurface(PixelSample sample) {
        Vec3 place = path.ray().at(path.end());
        Vector3d toEye = new Vector3d(path.direction()).normalize(-1);
        SurfacePoint surface = level.surface(path, place, toEye);
        Vector3d radiance =
                bounced == null ? level.light().radiance(surface, shadows, sample) : bounced.radiance(surface, sample);
        return level.arriving(radiance, place, path, sample.random());
    }
}
