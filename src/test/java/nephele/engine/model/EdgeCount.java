package nephele.engine.model;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.joml.Vector3d;

/** Counts directed edges between positions; on a closed surface each has its opposite. */
public final class EdgeCount {
    private EdgeCount() {}

    /**
     * Returns the number of a mesh's edges without exactly one opposite edge; positions must be equal to the last bit.
     */
    public static long open(Mesh mesh) {
        Map<List<Vector3d>, Integer> edges = new HashMap<>();
        for (int i = 0; i < mesh.indices().length; i++) {
            int next = i % 3 == 2 ? i - 2 : i + 1;
            Vector3d from = Triangles.position(mesh, mesh.indices()[i]);
            Vector3d to = Triangles.position(mesh, mesh.indices()[next]);
            edges.merge(List.of(from, to), 1, Integer::sum);
        }
        return edges.entrySet().stream()
                .filter(edge -> edge.getValue()
                        != edges.getOrDefault(
                                        List.of(
                                                edge.getKey().get(1),
                                                edge.getKey().get(0)),
                                        0)
                                .intValue())
                .count();
    }
}
