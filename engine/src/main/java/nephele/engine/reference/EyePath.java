package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Hash64;
import nephele.engine.math.Ray;
import nephele.engine.math.Reflection;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.PortalCrossing;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Traces an eye ray through every portal and off every mirror to the first other surface. Use one per thread, for any
 * number of rays; the accessors refer to the last one.
 */
final class EyePath {
    /**
     * The greatest number of portals and mirrors on a path. Between portals that face each other a ray may go on for
     * ever; what it sees beyond this number is smaller than a pixel of any picture, and the sky is used instead.
     */
    static final int MOST_CROSSINGS = 4096;

    /** Tolerance for a wall and the portal in it, which coincide: the portal has priority within it. */
    private static final double FLUSH_METRES = 1e-6;

    private static final Vector3dc STRAIGHT = new Vector3d();

    private final TracedItems surfaces;
    private final Portals portals;
    private final FaceMaterials solids;
    private final List<Reflected> reflected = new ArrayList<>();
    private final List<Segment> segments = new ArrayList<>();
    private final Vector3d tint = new Vector3d();
    private final PortalCrossing crossing = new PortalCrossing();
    private final RayHit hit = new RayHit();
    private final Vector3d origin = new Vector3d();
    private final Vector3d direction = new Vector3d();
    private Ray ray;
    private int item = -1;
    private double metres;
    private boolean endsInTheOpen;
    private long pathHash;

    /**
     * A mirror on the path.
     *
     * @param before the part of the path that ends at it
     * @param lost fraction of light that all mirrors before it transmit and that it absorbs
     */
    record Reflected(Segment before, Vector3dc lost) {
        /** Returns the length of the path from the eye to the mirror. */
        double metres() {
            return before.metresBefore() + before.metres();
        }
    }

    /**
     * A straight part of the path.
     *
     * @param direction unit vector
     * @param metresBefore length of the path from the eye to the origin
     * @param tint product of the tints of the mirrors before it
     */
    record Segment(Vec3 origin, Vec3 direction, double metres, double metresBefore, Vector3dc tint) {
        /** Returns where the path would begin if it were as straight as this part. */
        Vec3 straightEye() {
            return origin.addScaled(-metresBefore, direction);
        }

        private Segment endless() {
            return new Segment(origin, direction, Double.POSITIVE_INFINITY, metresBefore, tint);
        }

        /** Returns its part up to a distance from its origin; empty if that is negative. */
        Segment shortened(double most) {
            return most < metres ? new Segment(origin, direction, most, metresBefore, tint) : this;
        }
    }

    EyePath(TracedItems surfaces, Portals portals, FaceMaterials solids) {
        this.surfaces = surfaces;
        this.solids = solids;
        this.portals = portals;
    }

    /**
     * Traces until a solid, a body or a model is entered.
     *
     * @param along direction of depth 1: parameters are depths
     * @return true if there is one between {@code near} and {@code far}
     */
    boolean trace(Vector3dc eye, Vector3dc along, double near, double far) {
        return trace(eye, along, near, far, -1);
    }

    /**
     * Traces on from a vertex of a path of light. Up to its first portal or mirror it passes the vertex's own item if
     * that is convex, as shadow rays do: a billboard, which turns to each ray, would else be met by half of its own.
     */
    boolean leave(PathVertex vertex, Vector3dc unit) {
        int own = vertex instanceof SurfacePoint surface ? surfaces.withoutOwnShade(surface.item()) : -1;
        return trace(vertex.rayOrigin(), unit, 0, Double.POSITIVE_INFINITY, own);
    }

    private boolean trace(Vector3dc eye, Vector3dc along, double near, double far, int except) {
        origin.set(eye);
        direction.set(along);
        double length = along.length();
        double walked = 0;
        int likely = item;
        item = -1;
        metres = Double.POSITIVE_INFINITY;
        endsInTheOpen = false;
        pathHash = 0;
        reflected.clear();
        segments.clear();
        tint.set(1);
        for (int crossings = 0; crossings < MOST_CROSSINGS; crossings++) {
            ray = TracedItems.ray(origin, direction);
            double left = far - walked;
            boolean isMet =
                    surfaces.nearest(ray, Math.max(near - walked, 0), left, crossings == 0 ? except : -1, likely, hit);
            double free = (isMet ? hit.distance() : left) + FLUSH_METRES / length;
            boolean isCrossing = crossing.find(portals, origin, direction, STRAIGHT, free);
            addSegment(isCrossing ? crossing.seconds() : isMet ? hit.distance() : left, walked, length);
            if (!isCrossing) {
                if (isMet && isReflected()) {
                    walked += hit.distance();
                    continue;
                }
                if (isMet) {
                    item = hit.item();
                    metres = (walked + hit.distance()) * length;
                }
                endsInTheOpen = !isMet;
                return isMet;
            }
            walked += crossing.seconds();
            pathHash = Hash64.combine(pathHash, crossing.portal());
            PortalTransform transform = portals.transform(crossing.portal());
            transform.point(origin.set(crossing.place()));
            transform.direction(direction);
        }
        return false;
    }

    private void addSegment(double depth, double depthBefore, double length) {
        Vec3 unit = Vec3.of(direction).scaled(1 / length);
        segments.add(new Segment(Vec3.of(origin), unit, depth * length, depthBefore * length, new Vector3d(tint)));
    }

    /** Reflects the path if it hits a mirror. */
    private boolean isReflected() {
        if (!solids.has(hit.item())) {
            return false;
        }
        int face = ((TracedSolid) surfaces.shape(hit.item())).face(ray);
        if (!solids.isMirror(hit.item(), face)) {
            return false;
        }
        Vector3d before = new Vector3d(tint);
        tint.mul(solids.mirrorTint(hit.item(), face).toVector());
        reflected.add(new Reflected(lastSegment(), before.sub(tint)));
        pathHash = hashOfMirror(pathHash, hit.item(), face);
        origin.set(ray.at(hit.distance()).toVector());
        new Reflection(Vec3.ZERO, solids.normal(hit.item(), face)).direction(direction);
        return true;
    }

    /** Returns the hash of a path that goes on to a mirror. */
    static long hashOfMirror(long hash, int solid, int face) {
        return Hash64.combine(Hash64.combine(hash, ~solid), face);
    }

    /** Returns the product of the tints of the mirrors on the path, linear RGB. */
    Vector3dc tint() {
        return tint;
    }

    /** Returns the mirrors on the path in order. */
    List<Reflected> reflected() {
        return reflected;
    }

    /** Returns the straight parts of the path in order, to its end or to the far limit. */
    List<Segment> segments() {
        return segments;
    }

    /** Returns the straight parts of the path in order; one that ends in the open has no end. */
    List<Segment> partsToEnd() {
        if (!endsInTheOpen) {
            return segments;
        }
        List<Segment> parts = new ArrayList<>(segments);
        parts.set(parts.size() - 1, lastSegment().endless());
        return parts;
    }

    Segment lastSegment() {
        return segments.get(segments.size() - 1);
    }

    /** Returns the last segment of the path; its parameter starts at the last portal or mirror. */
    Ray ray() {
        return ray;
    }

    /** Returns the direction of the last segment. */
    Vector3dc direction() {
        return direction;
    }

    /** Returns the item at the end of the path, −1 if there is none. */
    int item() {
        return item;
    }

    /** Returns the length of the path through portals and mirrors; infinite if it hits nothing. */
    double metres() {
        return metres;
    }

    /** Returns true if nothing is on the last segment up to the far limit. */
    boolean endsInTheOpen() {
        return endsInTheOpen;
    }

    /** Returns a hash of the portals and mirrors on the path, in order; 0 if there are none. */
    long pathHash() {
        return pathHash;
    }

    /** Returns the parameter of the last segment at its end. */
    double end() {
        return hit.distance();
    }
}
