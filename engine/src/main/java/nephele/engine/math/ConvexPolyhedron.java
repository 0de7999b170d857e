package nephele.engine.math;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A bounded convex solid, stored as its bounding planes and the polygons on them. */
public record ConvexPolyhedron(List<Face> faces, List<Vec3> vertices, Aabb bounds) {
    /** The maximum number of planes; every triple of planes is intersected. */
    public static final int MAX_PLANES = 64;

    /** Corners closer than this are merged; relative to the solid's extent. */
    private static final double RELATIVE_WELD_DISTANCE = 1e-9;

    /**
     * Fraction of the weld distance, above rounding. Tests whether the planes enclose a volume with unmerged corners.
     */
    private static final double FINER_WELD_SHARE = 1e-4;

    /** The corners of a box's faces; bits 0, 1 and 2 of a corner are set if it has the greater x, y, z. */
    private static final int[][] BOX_FACES = {
        {5, 1, 3, 7}, {0, 4, 6, 2}, {6, 7, 3, 2}, {0, 1, 5, 4}, {4, 5, 7, 6}, {1, 0, 2, 3}
    };

    /**
     * A face of the solid.
     *
     * @param planeIndex index of the plane among the given planes
     * @param polygon corners, counter-clockwise seen from outside; shared corners have the same bits in all faces
     */
    public record Face(int planeIndex, Plane plane, List<Vec3> polygon) {}

    /** Hashes the bounds only, because few solids share them. */
    @Override
    public int hashCode() {
        return bounds.hashCode();
    }

    /** Returns the box in closed form, with its faces in the order +x −x +y −y +z −z. */
    public static ConvexPolyhedron box(Aabb b) {
        Vec3[] c = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            c[i] = b.corner(i);
        }
        List<Face> faces = List.of(
                boxFace(0, c, new Plane(1, 0, 0, b.maxX())),
                boxFace(1, c, new Plane(-1, 0, 0, -b.minX())),
                boxFace(2, c, new Plane(0, 1, 0, b.maxY())),
                boxFace(3, c, new Plane(0, -1, 0, -b.minY())),
                boxFace(4, c, new Plane(0, 0, 1, b.maxZ())),
                boxFace(5, c, new Plane(0, 0, -1, -b.minZ())));
        return new ConvexPolyhedron(faces, List.of(c), b);
    }

    /**
     * Returns an oriented box in closed form from its half edges, which form a right-handed set. The faces have the
     * same order as above.
     */
    public static ConvexPolyhedron box(Vec3 centre, Vec3 halfX, Vec3 halfY, Vec3 halfZ) {
        Vec3[] c = new Vec3[8];
        for (int i = 0; i < 8; i++) {
            int x = (i & 1) == 0 ? -1 : 1;
            int y = (i & 2) == 0 ? -1 : 1;
            int z = (i & 4) == 0 ? -1 : 1;
            c[i] = new Vec3(
                    centre.x() + x * halfX.x() + y * halfY.x() + z * halfZ.x(),
                    centre.y() + x * halfX.y() + y * halfY.y() + z * halfZ.y(),
                    centre.z() + x * halfX.z() + y * halfY.z() + z * halfZ.z());
        }
        Vec3[] outward = {halfX, halfX.negated(), halfY, halfY.negated(), halfZ, halfZ.negated()};
        List<Face> faces = new ArrayList<>();
        for (int face = 0; face < 6; face++) {
            Plane flat = Plane.of(outward[face], 0);
            Vec3 corner = c[BOX_FACES[face][0]];
            faces.add(boxFace(face, c, new Plane(flat.nx(), flat.ny(), flat.nz(), flat.signedDistance(corner))));
        }
        return new ConvexPolyhedron(List.copyOf(faces), List.of(c), Aabb.of(List.of(c)));
    }

    private static Face boxFace(int face, Vec3[] c, Plane plane) {
        int[] at = BOX_FACES[face];
        return new Face(face, plane, List.of(c[at[0]], c[at[1]], c[at[2]], c[at[3]]));
    }

    /** Returns four numbers for each face, for frequent queries: its unit normal and its distance. */
    public double[] flatPlanes() {
        double[] flat = new double[4 * faces.size()];
        for (int i = 0; i < faces.size(); i++) {
            Plane p = faces.get(i).plane();
            flat[4 * i] = p.nx();
            flat[4 * i + 1] = p.ny();
            flat[4 * i + 2] = p.nz();
            flat[4 * i + 3] = p.distance();
        }
        return flat;
    }

    /**
     * Returns the intersection of the half spaces behind {@code planes}. A plane that touches it in less than a face
     * yields no face.
     *
     * @throws IllegalArgumentException with the reason if the intersection is empty, flat or unbounded
     */
    public static ConvexPolyhedron fromPlanes(List<Plane> planes) {
        if (planes.size() < 4 || planes.size() > MAX_PLANES) {
            throw new IllegalArgumentException("a solid needs 4 to " + MAX_PLANES + " planes, not " + planes.size());
        }
        double epsilon = RELATIVE_WELD_DISTANCE * extent(planes);
        List<Vec3> corners = corners(planes, epsilon);
        List<Face> faces = faces(planes, corners, epsilon);
        if (!isClosed(faces)) {
            throw new IllegalArgumentException(whyOpen(planes, faces, epsilon));
        }
        return new ConvexPolyhedron(List.copyOf(faces), List.copyOf(corners), Aabb.of(corners));
    }

    private static List<Face> faces(List<Plane> planes, List<Vec3> corners, double epsilon) {
        List<Face> faces = new ArrayList<>();
        for (int i = 0; i < planes.size(); i++) {
            List<Vec3> polygon = polygon(planes.get(i), corners, epsilon * 4);
            if (polygon.size() >= 3 && notSeen(faces, polygon)) {
                faces.add(new Face(i, planes.get(i), polygon));
            }
        }
        return faces;
    }

    /** Explains why the planes enclose nothing; planes that do with finer welding are too close to each other. */
    private static String whyOpen(List<Plane> planes, List<Face> faces, double epsilon) {
        double finer = epsilon * FINER_WELD_SHARE;
        if (isClosed(faces(planes, corners(planes, finer), finer))) {
            return "the solid is too thin for its size and its distance from the origin: corners less than "
                    + 8 * epsilon + " m apart are not told apart; make it thicker or shorter, or move it nearer";
        }
        return faces.size() < 4
                ? "the planes enclose no volume: check that every normal points outwards"
                : "the planes leave the solid open on one side: add the missing plane";
    }

    private static double extent(List<Plane> planes) {
        double extent = 1;
        for (Plane plane : planes) {
            extent = Math.max(extent, Math.abs(plane.distance()));
        }
        return extent;
    }

    private static List<Vec3> corners(List<Plane> planes, double epsilon) {
        List<Vec3> corners = new ArrayList<>();
        int cutting = 0;
        for (int i = 0; i < planes.size(); i++) {
            for (int j = i + 1; j < planes.size(); j++) {
                for (int k = j + 1; k < planes.size(); k++) {
                    Vec3 p = intersection(planes.get(i), planes.get(j), planes.get(k));
                    // The plane that cut the last point off mostly cuts the next one off, too.
                    if (p == null || planes.get(cutting).signedDistance(p) > epsilon) {
                        continue;
                    }
                    int other = cutting(planes, p, epsilon);
                    if (other >= 0) {
                        cutting = other;
                    } else if (!near(corners, p, epsilon * 2)) {
                        corners.add(p);
                    }
                }
            }
        }
        return corners;
    }

    /** Solves the three plane equations by Cramer's rule; {@code null} if the determinant is below 1e-9. */
    static Vec3 intersection(Plane a, Plane b, Plane c) {
        double bcX = b.ny() * c.nz() - b.nz() * c.ny();
        double bcY = b.nz() * c.nx() - b.nx() * c.nz();
        double bcZ = b.nx() * c.ny() - b.ny() * c.nx();
        double determinant = a.nx() * bcX + a.ny() * bcY + a.nz() * bcZ;
        if (Math.abs(determinant) < 1e-9) {
            return null;
        }
        double caX = c.ny() * a.nz() - c.nz() * a.ny();
        double caY = c.nz() * a.nx() - c.nx() * a.nz();
        double caZ = c.nx() * a.ny() - c.ny() * a.nx();
        double abX = a.ny() * b.nz() - a.nz() * b.ny();
        double abY = a.nz() * b.nx() - a.nx() * b.nz();
        double abZ = a.nx() * b.ny() - a.ny() * b.nx();
        return new Vec3(
                (a.distance() * bcX + b.distance() * caX + c.distance() * abX) / determinant,
                (a.distance() * bcY + b.distance() * caY + c.distance() * abY) / determinant,
                (a.distance() * bcZ + b.distance() * caZ + c.distance() * abZ) / determinant);
    }

    /** Returns the index of the first plane with the point in front; −1 if it is behind all. */
    private static int cutting(List<Plane> planes, Vec3 p, double epsilon) {
        for (int i = 0; i < planes.size(); i++) {
            if (planes.get(i).signedDistance(p) > epsilon) {
                return i;
            }
        }
        return -1;
    }

    private static boolean near(List<Vec3> corners, Vec3 p, double epsilon) {
        for (Vec3 c : corners) {
            if (Math.abs(c.x() - p.x()) <= epsilon
                    && Math.abs(c.y() - p.y()) <= epsilon
                    && Math.abs(c.z() - p.z()) <= epsilon) {
                return true;
            }
        }
        return false;
    }

    private static List<Vec3> polygon(Plane plane, List<Vec3> corners, double epsilon) {
        List<Vec3> on = new ArrayList<>();
        for (Vec3 c : corners) {
            if (Math.abs(plane.signedDistance(c)) <= epsilon) {
                on.add(c);
            }
        }
        return on.size() < 3 ? on : counterClockwise(plane, on);
    }

    /**
     * Returns the convex hull of points on a plane by gift wrapping: each next corner has all others on its left, seen
     * from outside. Points on an edge are dropped.
     */
    public static List<Vec3> counterClockwise(Plane plane, List<Vec3> points) {
        List<Vec3> ring = new ArrayList<>();
        Vec3 first = lowest(points);
        Vec3 current = first;
        do {
            ring.add(current);
            Vec3 next = null;
            for (Vec3 candidate : points) {
                if (candidate != current && (next == null || isBetter(plane, current, next, candidate))) {
                    next = candidate;
                }
            }
            current = next;
        } while (current != first && ring.size() <= points.size());
        return List.copyOf(ring);
    }

    static Vec3 lowest(List<Vec3> points) {
        Vec3 lowest = points.get(0);
        for (Vec3 p : points) {
            if (Arrays.compare(new double[] {p.x(), p.y(), p.z()}, new double[] {lowest.x(), lowest.y(), lowest.z()})
                    < 0) {
                lowest = p;
            }
        }
        return lowest;
    }

    private static boolean isBetter(Plane plane, Vec3 from, Vec3 best, Vec3 candidate) {
        double ax = best.x() - from.x();
        double ay = best.y() - from.y();
        double az = best.z() - from.z();
        double bx = candidate.x() - from.x();
        double by = candidate.y() - from.y();
        double bz = candidate.z() - from.z();
        double turn =
                plane.nx() * (ay * bz - az * by) + plane.ny() * (az * bx - ax * bz) + plane.nz() * (ax * by - ay * bx);
        double a2 = ax * ax + ay * ay + az * az;
        double b2 = bx * bx + by * by + bz * bz;
        double collinear = 1e-12 * Math.sqrt(a2 * b2);
        return turn < -collinear || (Math.abs(turn) <= collinear && b2 > a2);
    }

    /** Merges equal planes into one face. */
    private static boolean notSeen(List<Face> faces, List<Vec3> polygon) {
        return faces.stream().noneMatch(f -> f.polygon().equals(polygon));
    }

    /**
     * Returns true if the area vectors cancel, as on a closed surface; those of an unbounded or flat intersection do
     * not.
     */
    private static boolean isClosed(List<Face> faces) {
        double x = 0;
        double y = 0;
        double z = 0;
        double total = 0;
        for (Face face : faces) {
            double area = area(face);
            x += area * face.plane().nx();
            y += area * face.plane().ny();
            z += area * face.plane().nz();
            total += area;
        }
        return faces.size() >= 4 && Math.sqrt(x * x + y * y + z * z) <= 1e-6 * total;
    }

    private static double area(Face face) {
        Vec3 o = face.polygon().get(0);
        double doubled = 0;
        for (int i = 2; i < face.polygon().size(); i++) {
            Vec3 a = face.polygon().get(i - 1);
            Vec3 b = face.polygon().get(i);
            double ax = a.x() - o.x();
            double ay = a.y() - o.y();
            double az = a.z() - o.z();
            double bx = b.x() - o.x();
            double by = b.y() - o.y();
            double bz = b.z() - o.z();
            Plane n = face.plane();
            doubled += n.nx() * (ay * bz - az * by) + n.ny() * (az * bx - ax * bz) + n.nz() * (ax * by - ay * bx);
        }
        return doubled / 2;
    }

    /** Returns the volume in m³, as the sum of tetrahedra from one corner, so that the place does not matter. */
    public double volumeCubicMetres() {
        Vec3 origin = vertices.get(0);
        double sixfold = 0;
        for (Face face : faces) {
            List<Vec3> ring = face.polygon();
            Vec3 a = ring.get(0).minus(origin);
            for (int i = 2; i < ring.size(); i++) {
                Vec3 b = ring.get(i - 1).minus(origin);
                Vec3 c = ring.get(i).minus(origin);
                sixfold += a.dot(b.cross(c));
            }
        }
        return sixfold / 6;
    }

    /** Returns the least extent in metres perpendicular to a face. */
    public double thicknessMetres() {
        double thickness = Double.POSITIVE_INFINITY;
        for (Face face : faces) {
            double depth = 0;
            for (Vec3 corner : vertices) {
                depth = Math.max(depth, -face.plane().signedDistance(corner));
            }
            thickness = Math.min(thickness, depth);
        }
        return thickness;
    }

    /** Returns the area of all faces in m². */
    public double surfaceSquareMetres() {
        return faces.stream()
                .mapToDouble(face -> areaSquareMetres(face.polygon()))
                .sum();
    }

    /** Returns the area of a convex polygon in m². */
    public static double areaSquareMetres(List<Vec3> ring) {
        Vec3 doubled = Vec3.ZERO;
        Vec3 origin = ring.get(0);
        for (int i = 2; i < ring.size(); i++) {
            doubled =
                    doubled.plus(ring.get(i - 1).minus(origin).cross(ring.get(i).minus(origin)));
        }
        return doubled.length() / 2;
    }
}
