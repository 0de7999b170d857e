package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;

/**
 * A convex part of a face over which the sky visibility is continuous, because no other solid's footprint divides it.
 *
 * @param cover the kind of cover
 * @param outline counter-clockwise from outside
 * @param corners the outline with the corners of all neighbouring fragments on its edges; if there are any, the
 *     centroid follows as the last entry
 * @param triangles indices into {@code corners}
 */
public record FaceFragment(Cover cover, List<Vec3> outline, List<Vec3> corners, int[] triangles) {
    /** The way in which another solid covers a part of a face. */
    public enum Cover {
        NONE,
        /** A face of the other solid touches all of it: it is never visible and not drawn. */
        TOUCHING,
        /**
         * It is inside the other solid; drawn, because its border crosses the other's faces, where cracks would appear.
         */
        INSIDE
    }

    public boolean isCovered() {
        return cover != Cover.NONE;
    }

    /** Returns true if two lists of fragments, by face, are equal bit by bit. */
    static boolean areSame(List<List<FaceFragment>> faces, List<List<FaceFragment>> others) {
        for (int face = 0; face < faces.size(); face++) {
            List<FaceFragment> some = faces.get(face);
            List<FaceFragment> same = others.get(face);
            if (some.size() != same.size()
                    || !IntStream.range(0, some.size())
                            .allMatch(i -> some.get(i).isSame(same.get(i)))) {
                return false;
            }
        }
        return true;
    }

    /** Compares all but the triangles, which follow from the corners. */
    private boolean isSame(FaceFragment other) {
        return cover == other.cover && outline.equals(other.outline) && corners.equals(other.corners);
    }

    /** Returns the fragment of an undivided face. */
    public static FaceFragment whole(List<Vec3> polygon) {
        return new FaceFragment(Cover.NONE, polygon, polygon, fan(polygon.size()));
    }

    static FaceFragment of(Cover cover, List<Vec3> outline, List<Vec3> outlineWithNeighbours) {
        if (outline.size() == outlineWithNeighbours.size()) {
            return new FaceFragment(cover, outline, outline, fan(outline.size()));
        }
        List<Vec3> corners = new ArrayList<>(outlineWithNeighbours);
        corners.add(PolygonClipping.centroid(outline));
        return new FaceFragment(cover, outline, List.copyOf(corners), wheel(outlineWithNeighbours.size()));
    }

    private static int[] fan(int corners) {
        int[] triangles = new int[3 * (corners - 2)];
        for (int i = 0; i < corners - 2; i++) {
            triangles[3 * i + 1] = i + 1;
            triangles[3 * i + 2] = i + 2;
        }
        return triangles;
    }

    /** Returns triangles around a hub: a fan would omit the corners on an edge next to its first one. */
    private static int[] wheel(int rim) {
        int[] triangles = new int[3 * rim];
        for (int i = 0; i < rim; i++) {
            triangles[3 * i] = rim;
            triangles[3 * i + 1] = i;
            triangles[3 * i + 2] = (i + 1) % rim;
        }
        return triangles;
    }
}
