package nephele.lab.generate;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.model.Mesh;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/** A builder of a mesh whose corners pick their colours from the palette. */
final class PlantMesh {
    private static final double TREE_METRES = 3;
    private static final double LEAST_DOUBLE_AREA = 2e-6;

    private final List<Vector3d> points = new ArrayList<>();
    private final List<Vector3d> normals = new ArrayList<>();
    private final List<double[]> colours = new ArrayList<>();
    private final List<int[]> triangles = new ArrayList<>();

    /** Adds a vertex and returns its index; the normal may have any length but 0. */
    int vertex(Vector3dc point, Vector3dc normal, PlantPaint paint, double shade) {
        points.add(new Vector3d(point));
        normals.add(new Vector3d(normal).normalize());
        colours.add(new double[] {PlantPaint.across(shade), paint.up()});
        return points.size() - 1;
    }

    /** Adds a triangle, counter-clockwise seen from outside. */
    void triangle(int a, int b, int c) {
        triangles.add(new int[] {a, b, c});
    }

    /** Adds a quadrilateral, counter-clockwise seen from outside. */
    void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    /** Adds a triangle that is seen from both sides. */
    void leaf(int a, int b, int c) {
        triangle(a, b, c);
        triangle(a, c, b);
    }

    /** Adds a triangle with its own flat normal. */
    void facet(Vector3dc a, Vector3dc b, Vector3dc c, PlantPaint paint, double shade) {
        Vector3d normal = new Vector3d(b).sub(a).cross(new Vector3d(c).sub(a));
        if (normal.length() > LEAST_DOUBLE_AREA) {
            triangle(vertex(a, normal, paint, shade), vertex(b, normal, paint, shade), vertex(c, normal, paint, shade));
        }
    }

    /**
     * Returns the mesh scaled so that its top is at the height, without vertices that no triangle uses and without
     * triangles that have no area. So that files are short, points are in whole millimetres, those of trees in
     * centimetres, and normals in hundredths, which readers bring to unit length.
     */
    Mesh mesh(double heightMetres) {
        double top = points.stream().mapToDouble(p -> p.y).max().orElseThrow();
        double parts = heightMetres > TREE_METRES ? 100 : 1000;
        points.forEach(p -> rounded(p.mul(heightMetres / top), parts));
        int[] place = new int[points.size()];
        Arrays.fill(place, -1);
        List<Integer> used = new ArrayList<>();
        List<Integer> corners = new ArrayList<>();
        for (int[] triangle : triangles) {
            if (doubleArea(triangle) > LEAST_DOUBLE_AREA) {
                for (int corner : triangle) {
                    if (place[corner] < 0) {
                        place[corner] = used.size();
                        used.add(corner);
                    }
                    corners.add(place[corner]);
                }
            }
        }
        return mesh(used, corners);
    }

    private Mesh mesh(List<Integer> used, List<Integer> corners) {
        float[] position = new float[3 * used.size()];
        float[] normal = new float[3 * used.size()];
        float[] texture = new float[2 * used.size()];
        for (int i = 0; i < used.size(); i++) {
            put(position, 3 * i, points.get(used.get(i)));
            put(normal, 3 * i, rounded(normals.get(used.get(i)), 100));
            texture[2 * i] = (float) rounded(colours.get(used.get(i))[0], 100);
            texture[2 * i + 1] = (float) rounded(colours.get(used.get(i))[1], 100);
        }
        return new Mesh(
                position,
                normal,
                texture,
                corners.stream().mapToInt(corner -> corner).toArray());
    }

    private double doubleArea(int[] triangle) {
        Vector3d a = points.get(triangle[0]);
        Vector3d across = new Vector3d(points.get(triangle[1])).sub(a);
        return across.cross(new Vector3d(points.get(triangle[2])).sub(a)).length();
    }

    private static void put(float[] to, int at, Vector3d v) {
        to[at] = (float) v.x;
        to[at + 1] = (float) v.y;
        to[at + 2] = (float) v.z;
    }

    private static Vector3d rounded(Vector3d v, double parts) {
        return v.set(rounded(v.x, parts), rounded(v.y, parts), rounded(v.z, parts));
    }

    /** Returns the nearest fraction with a denominator; adding 0 turns −0 into 0. */
    private static double rounded(double value, double parts) {
        return Math.rint(value * parts) / parts + 0.0;
    }
}
