package nephele.engine.reference;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Ray;
import nephele.engine.reference.EyePath.Segment;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.VolumeTracer;
import org.joml.Vector3d;

/**
 * Clouds on the paths of eye rays: each straight part of a path is tracked where it is, behind portals and mirrors too.
 * Behind a path's first collision its light walks on in the world, where portals are walls. Use one per thread.
 */
final class CloudSight {
    private final CloudMedia media;
    private final LevelSurroundings around;
    private final VolumeTracer tracer;

    CloudSight(CloudMedia media, LevelSurroundings around) {
        this.media = media;
        this.around = around;
        tracer = new VolumeTracer(media, around);
    }

    /**
     * The first collision on a path.
     *
     * @param segment of the path that it is on
     * @param ray along the segment
     */
    record Met(CloudMedia.Collision collision, Segment segment, Ray ray) {
        /** Returns the length of the path from the eye. */
        double metres() {
            return segment.metresBefore() + collision.metres();
        }
    }

    /** Returns a random first collision, or {@code null} if the path passes all clouds. */
    Met first(EyePath path, SplittableRandom random) {
        List<Segment> segments = path.segments();
        for (int i = 0; i < segments.size(); i++) {
            Segment segment = segments.get(i);
            boolean isEndless = path.endsInTheOpen() && i == segments.size() - 1;
            Ray ray = Ray.of(segment.origin(), segment.direction());
            double end = isEndless ? around.reachMetres(ray) : segment.metres();
            CloudMedia.Collision collision = media.collision(ray, 0, end, random);
            if (collision != null) {
                return new Met(collision, segment, ray);
            }
        }
        return null;
    }

    /** Returns a random RGB radiance whose mean is what comes from the place of a collision. */
    Vector3d radiance(Met met, SplittableRandom random) {
        return tracer.radianceAt(met.collision, met.ray, random).toVector();
    }
}
