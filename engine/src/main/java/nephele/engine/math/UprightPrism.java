package nephele.engine.math;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * A prism between two horizontal planes, in closed form. The planes that meet in each corner are known, so no weld
 * tolerance, which would be relative to the longest edge, can merge the corners of a needle.
 */
public final class UprightPrism {
    private final List<Plane> planes;
    private final int sides;
    /** Corner i is between sides i and i + 1. */
    private final Vec3[] top;

    private final Vec3[] bottom;

    private UprightPrism(List<Plane> planes) {
        this.planes = planes;
        sides = planes.size() - 2;
        top = ring(planes.get(0));
        bottom = ring(planes.get(1));
    }

    /**
     * Returns the prism with the same corners, to the last bit, as {@link ConvexPolyhedron#fromPlanes} where that can
     * separate them.
     *
     * @param planes the upper, the lower, then three or more upright ones ordered by their angle from +x towards +z
     */
    public static ConvexPolyhedron of(List<Plane> planes) {
        return new UprightPrism(planes).polyhedron();
    }

    private Vec3[] ring(Plane end) {
        Vec3[] ring = new Vec3[sides];
        for (int i = 0; i + 1 < sides; i++) {
            ring[i] = ConvexPolyhedron.intersection(end, side(i), side(i + 1));
        }
        ring[sides - 1] = ConvexPolyhedron.intersection(end, side(0), side(sides - 1));
        return ring;
    }

    private Plane side(int i) {
        return planes.get(2 + i);
    }

    private ConvexPolyhedron polyhedron() {
        List<ConvexPolyhedron.Face> faces = new ArrayList<>();
        List<Vec3> fromAbove = new ArrayList<>(List.of(top));
        Collections.reverse(fromAbove);
        addFace(0, fromAbove, faces);
        addFace(1, new ArrayList<>(List.of(bottom)), faces);
        for (int i = 0; i < sides; i++) {
            int before = (i + sides - 1) % sides;
            addFace(2 + i, new ArrayList<>(List.of(bottom[i], bottom[before], top[before], top[i])), faces);
        }
        List<Vec3> corners = new ArrayList<>();
        addCorners(top, corners);
        addCorners(bottom, corners);
        return new ConvexPolyhedron(List.copyOf(faces), List.copyOf(corners), Aabb.of(corners));
    }

    private void addFace(int plane, List<Vec3> ring, List<ConvexPolyhedron.Face> faces) {
        Collections.rotate(ring, -ring.indexOf(ConvexPolyhedron.lowest(ring)));
        faces.add(new ConvexPolyhedron.Face(plane, planes.get(plane), List.copyOf(ring)));
    }

    /**
     * Adds corners in the order of plane triples: the corner of side 0 and the last side precedes that of sides 1 and
     * 2.
     */
    private void addCorners(Vec3[] ring, List<Vec3> corners) {
        corners.add(ring[0]);
        corners.add(ring[sides - 1]);
        for (int i = 1; i < sides - 1; i++) {
            corners.add(ring[i]);
        }
    }
}
