package nephele.editor.tool.vertex;

import java.util.List;
import nephele.editor.record.EntityRef;
import nephele.engine.math.Vec3;

/**
 * A vertex of a solid, or an edge by its middle.
 *
 * @param vertices the vertex, or both ends of the edge
 */
record VertexGrip(EntityRef solid, List<Vec3> vertices) {
    private static final double SAME_METRES = 1e-6;

    Vec3 at() {
        return vertices.get(0).lerp(vertices.get(vertices.size() - 1), 0.5);
    }

    boolean isVertex() {
        return vertices.size() == 1;
    }

    /** Returns true if another grip of the solid is where this one is after a movement, but for rounding. */
    boolean isAt(VertexGrip other, Vec3 by) {
        boolean isSame = solid.equals(other.solid) && vertices.size() == other.vertices.size();
        for (int i = 0; isSame && i < vertices.size(); i++) {
            isSame = isIn(vertices.get(i).plus(by), other.vertices);
        }
        return isSame;
    }

    /** Returns true for a grip of any solid at the same place, but for rounding. */
    boolean isBeside(VertexGrip other) {
        return at().minus(other.at()).length() < SAME_METRES;
    }

    private static boolean isIn(Vec3 vertex, List<Vec3> others) {
        return others.stream().anyMatch(other -> other.minus(vertex).length() < SAME_METRES);
    }
}
