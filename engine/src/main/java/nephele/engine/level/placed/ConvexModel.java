package nephele.engine.level.placed;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Decides whether a mesh is the surface of a convex solid, and derives the solid. */
final class ConvexModel {
    /** Distance, relative to the mesh's extent, below which two positions are one; files hold floats. */
    private static final double SAME = 4e-6;

    private static final double SAME_AREA = 1e-3;

    private final WorldTriangles mesh;
    private final double tolerance;
    private final List<Vec3> corners = new ArrayList<>();
    private final List<Plane> planes = new ArrayList<>();
    private final List<Double> areas = new ArrayList<>();

    private ConvexModel(WorldTriangles mesh, double extent) {
        this.mesh = mesh;
        tolerance = SAME * extent;
    }

    /**
     * Returns the solid; {@code null} for a mesh that is hollow, open, flat or has more faces than a solid may have.
     */
    static Brush solid(ModelPlacement authored, WorldTriangles mesh) {
        var box = mesh.bounds();
        double extent = Math.max(box.maxX() - box.minX(), Math.max(box.maxY() - box.minY(), box.maxZ() - box.minZ()));
        ConvexModel model = new ConvexModel(mesh, extent);
        if (mesh.count() < 4 || !model.gatherPlanes() || !model.gatherCorners()) {
            return null;
        }
        List<ConvexPolyhedron.Face> faces = model.faces();
        if (faces.isEmpty() || !isClosed(faces)) {
            return null;
        }
        List<BrushFace> named = new ArrayList<>();
        for (ConvexPolyhedron.Face face : faces) {
            String name = "face " + face.planeIndex();
            named.add(new BrushFace(
                    name,
                    face.plane(),
                    face.polygon(),
                    authored.material(),
                    authored.portalable(),
                    TextureMapping.WORLD,
                    null));
        }
        Set<Vec3> used = new HashSet<>();
        faces.forEach(face -> used.addAll(face.polygon()));
        List<Vec3> vertices = model.corners.stream().filter(used::contains).toList();
        return new Brush(authored.id(), new ConvexPolyhedron(faces, vertices, box), List.copyOf(named));
    }

    /**
     * Assigns every triangle to a plane, together with its neighbours; returns false if a vertex is in front of a
     * plane.
     */
    private boolean gatherPlanes() {
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            Vec3 normal = mesh.faceNormal(triangle);
            Vec3 a = mesh.corner(triangle, 0);
            int plane = plane(triangle);
            if (plane < 0) {
                plane = planes.size();
                planes.add(Plane.through(normal, a));
                areas.add(0.0);
                if (plane == ConvexPolyhedron.MAX_PLANES || isAnythingBefore(planes.get(plane))) {
                    return false;
                }
            }
            areas.set(plane, areas.get(plane) + area(triangle));
        }
        return planes.size() >= 4;
    }

    private int plane(int triangle) {
        Vec3 normal = mesh.faceNormal(triangle);
        for (int i = 0; i < planes.size(); i++) {
            boolean on = normal.dot(planes.get(i).normal()) > 0.9;
            for (int corner = 0; corner < 3 && on; corner++) {
                on = Math.abs(planes.get(i).signedDistance(mesh.corner(triangle, corner))) <= tolerance;
            }
            if (on) {
                return i;
            }
        }
        return -1;
    }

    private boolean isAnythingBefore(Plane plane) {
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                if (plane.signedDistance(mesh.corner(triangle, corner)) > tolerance) {
                    return true;
                }
            }
        }
        return false;
    }

    private double area(int triangle) {
        Vec3 a = mesh.corner(triangle, 0);
        return mesh.corner(triangle, 1)
                        .minus(a)
                        .cross(mesh.corner(triangle, 2).minus(a))
                        .length()
                / 2;
    }

    /** Collects each position once; returns false if there are more than the planes can have (Euler). */
    private boolean gatherCorners() {
        for (int triangle = 0; triangle < mesh.count(); triangle++) {
            for (int corner = 0; corner < 3; corner++) {
                Vec3 p = mesh.corner(triangle, corner);
                if (planesAt(p) >= 3 && corners.stream().noneMatch(known -> isSame(known, p))) {
                    corners.add(p);
                }
            }
        }
        return corners.size() >= 4 && corners.size() <= 2 * planes.size() - 4;
    }

    private int planesAt(Vec3 p) {
        int count = 0;
        for (Plane plane : planes) {
            count += Math.abs(plane.signedDistance(p)) <= tolerance ? 1 : 0;
        }
        return count;
    }

    private boolean isSame(Vec3 a, Vec3 b) {
        return b.minus(a).length() <= tolerance;
    }

    /** Returns the faces; empty if a plane's triangles do not fill the polygon of its corners. */
    private List<ConvexPolyhedron.Face> faces() {
        List<ConvexPolyhedron.Face> faces = new ArrayList<>();
        for (int i = 0; i < planes.size(); i++) {
            Plane plane = planes.get(i);
            List<Vec3> on = corners.stream()
                    .filter(p -> Math.abs(plane.signedDistance(p)) <= tolerance)
                    .toList();
            if (on.size() < 3) {
                return List.of();
            }
            List<Vec3> ring = ConvexPolyhedron.counterClockwise(plane, on);
            if (Math.abs(area(ring) - areas.get(i)) > SAME_AREA * areas.get(i)) {
                return List.of();
            }
            faces.add(new ConvexPolyhedron.Face(i, plane, ring));
        }
        return List.copyOf(faces);
    }

    private static double area(List<Vec3> ring) {
        var sum = Vec3.ZERO.toVector();
        for (int i = 2; i < ring.size(); i++) {
            Vec3 doubled = ring.get(i - 1).minus(ring.get(0)).cross(ring.get(i).minus(ring.get(0)));
            sum.add(doubled.x(), doubled.y(), doubled.z());
        }
        return sum.length() / 2;
    }

    /** Returns true if every edge belongs to two faces, in opposite directions. */
    private static boolean isClosed(List<ConvexPolyhedron.Face> faces) {
        Set<List<Vec3>> edges = new HashSet<>();
        for (ConvexPolyhedron.Face face : faces) {
            List<Vec3> polygon = face.polygon();
            for (int i = 0; i < polygon.size(); i++) {
                edges.add(List.of(polygon.get(i), polygon.get((i + 1) % polygon.size())));
            }
        }
        return edges.stream().allMatch(edge -> edges.contains(List.of(edge.get(1), edge.get(0))));
    }
}
