package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.BitHash;
import nephele.engine.math.Ray;
import nephele.engine.math.RayHit;
import nephele.engine.math.Reflection;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Crossing;
import nephele.engine.portal.Passage;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Follows a ray of the eye through every portal and off every mirror on it to the first other surface. One for each thread, used again for every
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
    private final ReflectingFaces mirrors;
    private final List<Reflected> reflected = new ArrayList<>();
    private final Vector3d tint = new Vector3d();
    private final Crossing crossing = new Crossing();
    private final RayHit hit = new RayHit();
    private final Vector3d origin = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private Ray ray;
    private int item = -1;
    private double metres;
    private long passed;

    /**
     * A mirror on the way.
     *
     * @param metres from the eye to it, along the way
     * @param lost share of light that all mirrors up to it keep, and those before it do not
     */
    record Reflected(double metres, Vector3dc lost) {}

    EyePath(SurfaceRays surfaces, Portals portals, ReflectingFaces mirrors) {
        this.surfaces = surfaces;
        this.mirrors = mirrors;
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
        reflected.clear();
        tint.set(1);
        for (int crossings = 0; crossings < MOST_CROSSINGS; crossings++) {
            ray = SurfaceRays.ray(origin, direction);
            double left = far - walked;
            boolean isMet = surfaces.nearest(ray, Math.max(near - walked, 0), left, likely, hit);
            double free = (isMet ? hit.distance() : left) + FLUSH_METRES / length;
            if (!crossing.find(portals, origin, direction, STRAIGHT, free)) {
                if (isMet && isReflected(walked * length, length)) {
                    walked += hit.distance();
                    continue;
                }
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

    /** Turns the way where what it meets is a mirror. */
    private boolean isReflected(double metresBefore, double length) {
        if (!mirrors.mayBe(hit.item())) {
            return false;
        }
        int face = ((TracedSolid) surfaces.shape(hit.item())).face(ray);
        ReflectingFaces.Face mirror = mirrors.at(hit.item(), face);
        if (mirror == null) {
            return false;
        }
        Vector3d before = new Vector3d(tint);
        tint.mul(mirror.tint().toVector());
        reflected.add(new Reflected(metresBefore + hit.distance() * length, before.sub(tint)));
        passed = BitHash.join(BitHash.join(passed, ~hit.item()), face);
        origin.set(ray.at(hit.distance()).toVector());
        new Reflection(Vec3.ZERO, mirror.normal()).direction(direction);
        return true;
    }

    /** What the mirrors on the way multiply radiance by, linear RGB. */
    Vector3dc tint() {
        return tint;
    }

    /** The mirrors on the way, the first one first. */
    List<Reflected> reflected() {
        return reflected;
    }

    /** The last piece of the way: its parameter counts from the last portal or mirror. */
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

    /** How long the way is, portals and mirrors included; infinite where it ends on nothing. */
    double metres() {
        return metres;
    }

    /** Stands for the portals and mirrors on the way, in their order; 0 where there is none. */
    long passed() {
        return passed;
    }

    /** Parameter of the last piece at its end. */
    double end() {
        return hit.distance();
    }
}
