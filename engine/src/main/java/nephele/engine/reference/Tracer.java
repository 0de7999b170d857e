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
    private final Vector3dc from;
    private final EyePath path;
    private final Shafts.ShadowRays shadows;
    /** {@code null} without clouds. */
    private final CloudSight clouds;

    Tracer(TracedLevel level, Pinhole eye, EyePath path, Shafts.ShadowRays shadows) {
        this.level = level;
        this.eye = eye;
        this.path = path;
        this.shadows = shadows;
        clouds = level.cloudSight().orElse(null);
        from = eye.eye().toVector();
    }

    /** Returns the radiance that reaches the eye along a ray, see {@link Pinhole#direction}. */
    Vector3d radiance(Vector3d direction, PixelSample sample) {
        boolean isMet = path.trace(from, direction, eye.nearMetres(), eye.farMetres());
        CloudSight.Met cloud = clouds == null ? null : clouds.first(path, sample.random());
        if (cloud != null) {
            Vector3d radiance = fromCloud(cloud, sample);
            level.exits().addTo(radiance, path, cloud.metres(), level);
            return radiance;
        }
        Vector3d radiance = isMet ? fromSurface(sample) : fromSky(sample);
        level.exits().addTo(radiance, path, Double.POSITIVE_INFINITY, level);
        return radiance;
    }

    private Vector3d fromSurface(PixelSample sample) {
        Vec3 place = path.ray().at(path.end());
        Vector3d toEye = new Vector3d(path.direction()).normalize(-1);
        SurfacePoint surface = level.surface(path, place, toEye);
        Vector3d throughAir =
                level.throughAir(level.light().radiance(surface, shadows, sample), place, path, sample.random());
        Vector3d radiance = level.throughFog(throughAir, path.lastSegment(), path.metres());
        return mirrored(radiance, path.tint(), path.reflected());
    }

    private Vector3d fromSky(PixelSample sample) {
        Vector3d throughAir = level.sky(from.y(), path, sample.random());
        Vector3d radiance = level.throughFog(throughAir, path.lastSegment(), Double.POSITIVE_INFINITY);
        return mirrored(radiance, path.tint(), path.reflected());
    }

    private Vector3d fromCloud(CloudSight.Met cloud, PixelSample sample) {
        Vec3 place = cloud.ray().at(cloud.collision().metres());
        Vector3d scattered = clouds.radiance(cloud, sample.random());
        Vector3d throughAir =
                level.throughAir(scattered, place, cloud.segment().direction(), cloud.metres(), sample.random());
        Vector3d radiance = level.throughFog(throughAir, cloud.segment(), cloud.metres());
        List<EyePath.Reflected> mirrors = path.reflected().stream()
                .filter(mirror -> mirror.metres() <= cloud.segment().metresBefore())
                .toList();
        return mirrored(radiance, cloud.segment().tint(), mirrors);
    }

    /**
     * Applies the mirrors to radiance that has passed all the fog: the fog in front of a mirror is not tinted by it.
     */
    private Vector3d mirrored(Vector3d radiance, Vector3dc tint, List<EyePath.Reflected> mirrors) {
        radiance.mul(tint);
        for (EyePath.Reflected mirror : mirrors) {
            radiance.add(level.throughFog(new Vector3d(), mirror.before(), mirror.metres())
                    .mul(mirror.lost()));
        }
        return radiance;
    }
}
