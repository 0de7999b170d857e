package nephele.engine.reference;

import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.reference.SampleSequence.PixelSample;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** Traces radiance for one thread. */
final class Tracer {
    private final TracedLevel level;
    private final Pinhole eye;
    private final int width;
    private final Vector3dc from;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;
    /** {@code null} for direct light alone. */
    private final PathIntegrator bounced;

    /** @param width of the picture in pixels */
    Tracer(TracedLevel level, Pinhole eye, int width, EyePath path, Shafts.ShadowRays shadows, PathIntegrator bounced) {
        this.level = level;
        this.eye = eye;
        this.width = width;
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
        Vector3d radiance = bounced != null
                ? withBounces(isMet, cloud, eye.pixelRadians(direction, width), sample)
                : cloud != null
                        ? level.fromCloud(cloud, clouds, path, sample.random())
                        : isMet ? fromSurface(sample) : level.fromSky(path, sample.random());
        level.exits().addTo(radiance, path, cloud == null ? Double.POSITIVE_INFINITY : cloud.metres(), level);
        return radiance;
    }

    private SurfacePoint surface() {
        Vec3 place = path.ray().at(path.end());
        return level.surface(path, place, new Vector3d(path.direction()).normalize(-1));
    }

    private Vector3d fromSurface(PixelSample sample) {
        SurfacePoint surface = surface();
        Vector3d radiance = level.light().radiance(surface, shadows, sample);
        return level.arriving(radiance, surface.place(), path, sample.random());
    }

    private Vector3d withBounces(boolean isMet, CloudSight.Met cloud, double pixelRadians, PixelSample sample) {
        List<EyePath.Segment> parts = cloud == null ? path.partsToEnd() : cloud.parts();
        double metres = cloud == null ? path.metres() : cloud.metres();
        Vector3d seen = cloud != null
                ? bounced.radiance(cloud.vertex(), sample)
                : isMet
                        ? bounced.radiance(surface(), sample)
                        : level.sky(path.lastSegment()).add(level.discs(path.lastSegment(), pixelRadians));
        return level.arrivingByParts(seen, path, parts, metres, sample.random())
                .add(bounced.lampsAlong(parts, level::attenuation, sample.random()));
    }
}
