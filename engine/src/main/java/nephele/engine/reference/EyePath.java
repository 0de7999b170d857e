package nephele.engine.reference;

import nephele.engine.math.BitHash;
import nephele.engine.math.Ray;
import nephele.engine.math.RayHit;
import nephele.engine.portal.Crossing;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Follows a ray of the eye through every portal on it to the first surface. One for each thread, used again for every
 * ray; the accessors speak of the last one.
 */
final class EyePath {
    /**
     * Between facing portals a ray may go on for ever; what it sees after so many crossings is smaller than a pixel of
     * any picture, and the sky stands for it.
     */
    static final int MOST_CROSSINGS = 4096;

    /** A wall and the portal in it are met at one place: the portal wins by this. */
    private static final double FLUSH_METRES = 1e-6;

    private static final Vector3dc STRAIGHT = new Vector3d();

    private final SurfaceRays surfaces;
    private final Portals portals;
    private final Crossing crossing = new Crossing();
    private final RayHit hit = new RayHit();
    private final Vector3d origin = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private Ray ray;
    private int item = -1;
    private double metres;
    private long passed;

    EyePath(SurfaceRays surfaces, Portals portals) {
        this.surfaces = surfaces;
        this.portals = portals;
    }

    /**
     * Walks on until a solid or a body is entered.
     *
     * @param along depth 1: parameters are depths
     * @return whether there is one between {@code near} and {@code far}
     */
    boolean walk(Vector3dc eye, Vector3dc along, double near, double far) {
        origin.set(eye);
        direction.set(along);
        double length = along.length();
        double walked = 0;
        int likely = item;
        item = -1;
        metres = Double.POSITIVE_INFINITY;
        passed = 0;
        for (int crossings = 0; crossings < MOST_CROSSINGS; crossings++) {
            ray = SurfaceRays.ray(origin, direction);
            double left = far - walked;
            boolean isMet = surfaces.nearest(ray, Math.max(near - walked, 0), left, likely, hit);
            double free = (isMet ? hit.distance() : left) + FLUSH_METRES / length;
            if (!crossing.find(portals, origin, direction, STRAIGHT, free)) {
                if (isMet) {
                    item = hit.item();
                    metres = (walked + hit.distance()) * length;
                }
                return isMet;
            }
            walked += crossing.seconds();
            passed = BitHash.join(passed, crossing.portal());
            Passage passage = portals.passage(crossing.portal());
            passage.point(origin.set(crossing.place()));
            passage.direction(direction);
        }
        return false;
    }

    /** The last piece of the way: its parameter counts from the last portal. */
    Ray ray() {
        return ray;
    }

    /** Where the way goes in the end. */
    Vector3dc direction() {
        return direction;
    }

    /** What it ends on. */
    int item() {
        return item;
    }

    /** How long the way is, portals included; infinite where it ends on nothing. */
    double metres() {
        return metres;
    }

    /** Stands for the portals on the way, in their order; 0 where there is none. */
    long passed() {
        return passed;
    }

    /** Parameter of the last piece at its end. */
    double end() {
        return hit.distance();
    }
}
