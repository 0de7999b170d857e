package nephele.engine.model.file;

import java.util.Arrays;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.model.Mesh;
import org.joml.Vector3d;

/**
 * The triangles of an OBJ file. Corners with the same position, texture coordinates and normal become one vertex. Where
 * the file gives no normal, all corners of a smoothing group at one position share the mean of their triangles.
 */
final class ObjMeshBuilder {
    /** The index of missing texture coordinates. */
    static final int NONE = -1;

    private final FloatList places;
    private final FloatList textures;
    private final FloatList normals;
    private final TripleIndex vertices = new TripleIndex();
    private final ItemList indices = new ItemList();

    /** Position and smoothing group of each normal that is to be computed. */
    private final TripleIndex smoothed = new TripleIndex();

    private double[] sums = new double[48];

    ObjMeshBuilder(FloatList places, FloatList textures, FloatList normals) {
        this.places = places;
        this.textures = textures;
        this.normals = normals;
    }

    int triangles() {
        return indices.size() / 3;
    }

    /**
     * Returns the normal index, for {@link #addTriangle}, of the computed normal of a smoothing group at a position.
     */
    int computedNormal(int place, int smoothingGroup) {
        int number = smoothed.numberOf(place, smoothingGroup, 0);
        if (3 * number + 3 > sums.length) {
            sums = Arrays.copyOf(sums, 2 * sums.length);
        }
        return -1 - number;
    }

    /**
     * Adds a triangle unless it has no area. Each corner has a position, texture coordinates or {@link #NONE}, and a
     * normal.
     */
    void addTriangle(int[] a, int[] b, int[] c) {
        if (edge(a, b).cross(edge(a, c)).lengthSquared() > 0) {
            addCorner(a, b, c);
            addCorner(b, c, a);
            addCorner(c, a, b);
        }
    }

    Mesh mesh() {
        int count = vertices.size();
        float[] positions = new float[3 * count];
        float[] unit = new float[3 * count];
        float[] pictures = new float[2 * count];
        for (int i = 0; i < count; i++) {
            copy(places, vertices.first(i), positions, i, 3);
            if (vertices.second(i) != NONE) {
                copy(textures, vertices.second(i), pictures, i, 2);
            }
            normal(vertices.third(i), unit, i);
        }
        int[] corners = indices.toArray();
        MissingNormals.fill(positions, unit, corners);
        return new Mesh(positions, unit, pictures, corners);
    }

    private void addCorner(int[] corner, int[] next, int[] last) {
        indices.accept(vertices.numberOf(corner[0], corner[1], corner[2]));
        if (corner[2] < 0) {
            Vector3d a = edge(corner, next);
            Vector3d b = edge(corner, last);
            Vector3d normal = a.cross(b, new Vector3d());
            double length = normal.length();
            normal.mul(StrictMath.atan2(length, a.dot(b)) / length);
            int at = 3 * (-1 - corner[2]);
            sums[at] += normal.x;
            sums[at + 1] += normal.y;
            sums[at + 2] += normal.z;
        }
    }

    private Vector3d edge(int[] from, int[] to) {
        return place(to[0]).sub(place(from[0]));
    }

    private Vector3d place(int i) {
        return new Vector3d(places.at(3 * i), places.at(3 * i + 1), places.at(3 * i + 2));
    }

    private void normal(int code, float[] unit, int vertex) {
        if (code >= 0) {
            copy(normals, code, unit, vertex, 3);
            return;
        }
        int at = 3 * (-1 - code);
        double length = Math.sqrt(sums[at] * sums[at] + sums[at + 1] * sums[at + 1] + sums[at + 2] * sums[at + 2]);
        for (int axis = 0; axis < 3 && length > 0; axis++) {
            unit[3 * vertex + axis] = (float) (sums[at + axis] / length);
        }
    }

    private static void copy(FloatList from, int row, float[] to, int vertex, int width) {
        for (int column = 0; column < width; column++) {
            to[width * vertex + column] = from.at(width * row + column);
        }
    }

    /** Numbers integer triples in the order of their first occurrence, without an object for each. */
    private static final class TripleIndex {
        private final ItemList first = new ItemList();
        private final ItemList second = new ItemList();
        private final ItemList third = new ItemList();

        /** A hash table of triple numbers plus one; 0 for an empty slot. */
        private int[] slots = new int[64];

        int size() {
            return first.size();
        }

        int first(int number) {
            return first.get(number);
        }

        int second(int number) {
            return second.get(number);
        }

        int third(int number) {
            return third.get(number);
        }

        /** Returns the number of a triple; for a new one, {@link #size} before the call. */
        int numberOf(int a, int b, int c) {
            int slot = slot(a, b, c);
            if (slots[slot] != 0) {
                return slots[slot] - 1;
            }
            first.accept(a);
            second.accept(b);
            third.accept(c);
            slots[slot] = size();
            if (2 * size() > slots.length) {
                grow();
            }
            return size() - 1;
        }

        private int slot(int a, int b, int c) {
            int slot = mix(a, b, c) & (slots.length - 1);
            while (slots[slot] != 0 && !isAt(slots[slot] - 1, a, b, c)) {
                slot = (slot + 1) & (slots.length - 1);
            }
            return slot;
        }

        private boolean isAt(int number, int a, int b, int c) {
            return first.get(number) == a && second.get(number) == b && third.get(number) == c;
        }

        private void grow() {
            slots = new int[2 * slots.length];
            for (int number = 0; number < size(); number++) {
                slots[slot(first.get(number), second.get(number), third.get(number))] = number + 1;
            }
        }

        private static int mix(int a, int b, int c) {
            long mixed = (a * 0x9E3779B97F4A7C15L) ^ (b * 0xC2B2AE3D27D4EB4FL) ^ (c * 0x165667B19E3779F9L);
            mixed = (mixed ^ (mixed >>> 29)) * 0xBF58476D1CE4E5B9L;
            return (int) (mixed >>> 32);
        }
    }
}
