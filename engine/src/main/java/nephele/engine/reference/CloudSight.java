package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.Portals;
import nephele.engine.reference.EyePath.Segment;
import nephele.engine.reference.volume.CloudMedia;
import nephele.engine.reference.volume.DistantLight;
import nephele.engine.reference.volume.Surroundings;
import nephele.engine.reference.volume.VolumeTracer;
import org.joml.Vector3d;
import org.joml.Vector3dc;

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
     * @param parts of the path up to it
     * @param ray along the last of them
     */
    record Met(CloudMedia.Collision collision, List<Segment> parts, Ray ray) {
        /** Returns the part of the path that ends at it. */
        Segment segment() {
            return parts.get(parts.size() - 1);
        }

        Vec3 place() {
            return ray.at(collision.metres());
        }

        PathVertex.InCloud vertex() {
            return new PathVertex.InCloud(place(), segment().direction(), collision.medium());
        }

        /** Returns the length of the path from the eye. */
        double metres() {
            return segment().metresBefore() + collision.metres();
        }
    }

    /** Returns a random first collision, or {@code null} if the path passes all clouds. */
    Met first(EyePath path, SplittableRandom random) {
        List<Segment> segments = path.partsToEnd();
        for (int i = 0; i < segments.size(); i++) {
            Segment segment = segments.get(i);
            Ray ray = Ray.of(segment.origin(), segment.direction());
            double end = Double.isInfinite(segment.metres()) ? around.reachMetres(ray) : segment.metres();
            CloudMedia.Collision collision = media.collision(ray, 0, end, random);
            if (collision != null) {
                List<Segment> parts = new ArrayList<>(segments.subList(0, i));
                parts.add(segment.shortened(collision.metres()));
                return new Met(collision, parts, ray);
            }
        }
        return null;
    }

    /** Returns a random RGB radiance whose mean is what comes from the place of a collision. */
    Vector3d radiance(Met met, SplittableRandom random) {
        return tracer.radianceAt(met.collision, met.ray, random).toVector();
    }

    /**
     * The surroundings of the clouds of a level: light from outside, and every solid, body, model and open portal, seen from its
     * front, as a black wall. Use one per thread.
     */
    static final class LevelSurroundings implements Surroundings {
        private static final Vector3dc STRAIGHT = new Vector3d();

        private final Surroundings open;
        private final TracedItems surfaces;
        private final Portals portals;
        private final boolean hasPortals;
        private final boolean castShadows;
        private final PortalCrossing crossing = new PortalCrossing();
        private final Vector3d origin = new Vector3d();
        private final Vector3d direction = new Vector3d();

        /** @param castShadows false if sun and moon cast no shadows */
        LevelSurroundings(Surroundings open, TracedItems surfaces, Portals portals, boolean castShadows) {
            this.open = open;
            this.surfaces = surfaces;
            this.portals = portals;
            this.castShadows = castShadows;
            hasPortals = IntStream.range(0, portals.size()).anyMatch(portals::isOpen);
        }

        @Override
        public List<DistantLight> lights() {
            return open.lights();
        }

        @Override
        public Vec3 skylight(Vec3 from, Vec3 along) {
            return open.skylight(from, along);
        }

        @Override
        public double reachMetres(Ray ray) {
            return open.reachMetres(ray);
        }

        @Override
        public boolean isLightBlocked(Ray ray) {
            return castShadows && isPathBlocked(ray, Double.POSITIVE_INFINITY);
        }

        @Override
        public boolean isPathBlocked(Ray ray, double toMetres) {
            return surfaces.blocker(ray, toMetres, -1) >= 0 || hasPortals && crossesPortal(ray, toMetres);
        }

        private boolean crossesPortal(Ray ray, double toMetres) {
            origin.set(ray.originX(), ray.originY(), ray.originZ());
            direction.set(ray.directionX(), ray.directionY(), ray.directionZ());
            return crossing.find(portals, origin, direction, STRAIGHT, toMetres);
        }
    }
}
