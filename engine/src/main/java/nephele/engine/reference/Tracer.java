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
    private final ShadowRays shadows;

    Tracer(TracedLevel level, Pinhole eye, EyePath path, ShadowRays shadows) {
        this.level = level;
        this.eye = eye;
        this.path = path;
        this.shadows = shadows;
        from = eye.eye().toVector();
    }

    /** Returns the radiance that reaches the eye along a ray, see {@link Pinhole#direction}. */
    Vector3d radiance(Vector3d direction, PixelSample sample) {
        Vector3d radiance = fromSurface(direction, sample);
        level.exits().addTo(radiance, path, level);
        return radiance;
    }

    private Vector3d fromSurface(Vector3d direction, PixelSample sample) {
        if (path.trace(from, direction, eye.nearMetres(), eye.farMetres())) {
            Vec3 place = path.ray().at(path.end());
            Vector3d toEye = new Vector3d(path.direction()).normalize(-1);
            SurfacePoint surface = level.surface(path, place, toEye);
            Vector3d seen = level.throughAir(level.light().radiance(surface, shadows, sample), place, path);
            return mirrored(level.throughFog(seen, path.metres()));
        }
        Vector3d away = new Vector3d(path.direction()).normalize();
        return mirrored(level.throughFog(level.sky(from.y(), away), Double.POSITIVE_INFINITY));
    }

    /**
     * Applies the mirrors to radiance that has passed all the fog: the fog in front of a mirror is not tinted by it.
     */
    private Vector3d mirrored(Vector3d radiance) {
        radiance.mul(path.tint());
        for (EyePath.Reflected mirror : path.reflected()) {
            radiance.add(level.throughFog(new Vector3d(), mirror.metres()).mul(mirror.lost()));
        }
        return radiance;
    }
}
