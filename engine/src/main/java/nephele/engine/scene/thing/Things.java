package nephele.engine.scene.thing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.SolidGeometry;
import nephele.engine.scene.thing.ThingMesh.Builder;
import nephele.engine.scene.thing.ThingMesh.Range;

/**
 * Everything of a level that moves, as it never changes: shapes, meshes, materials, and who is drawn with whom.
 *
 * @param materials of all things; a kind's material block counts in these
 * @param members for each group the bodies in it; {@link #FIGURE} for the player's figure
 * @param shapes for each body
 * @param materialOf for each body its index in its block of {@code materials}
 */
public record Things(
        ThingMesh mesh,
        List<ThingGroup> groups,
        List<Surface> materials,
        List<int[]> members,
        List<ThingShape> shapes,
        int[] materialOf) {
    /** In place of a body's number. */
    static final int FIGURE = -1;

    private record Key(boolean round, SolidBatch.Kind kind) {}

    public static Things of(Level level, SceneMaterials known, FigurePresence figure) {
        Builder mesh = new Builder();
        Range[] box = {BodyMeshes.box(mesh)};
        Range[] round = BodyMeshes.round(mesh);
        List<ThingShape> shapes = level.bodies().stream().map(ThingShape::of).toList();
        int[] materialOf = new int[shapes.size()];
        Map<Key, List<Integer>> sorted = new LinkedHashMap<>();
        for (int i = 0; i < shapes.size(); i++) {
            Body body = level.bodies().get(i);
            int material = known.indexOf(body.material());
            materialOf[i] = material % SolidGeometry.MATERIALS_PER_BLOCK;
            boolean isRound = shapes.get(i).kind() != ThingShape.BOX;
            Key key = new Key(isRound, kind(known.surfaces().get(material), material));
            sorted.computeIfAbsent(key, k -> new ArrayList<>()).add(i);
        }
        List<ThingGroup> groups = new ArrayList<>();
        List<int[]> members = new ArrayList<>();
        sorted.forEach((key, bodies) -> {
            groups.add(new ThingGroup(key.round ? round : box, key.kind, 1, null));
            members.add(bodies.stream().mapToInt(i -> i).toArray());
        });
        return new Things(
                mesh.finished(), List.copyOf(groups), known.surfaces(), List.copyOf(members), shapes, materialOf);
    }

    private static SolidBatch.Kind kind(Surface surface, int material) {
        return new SolidBatch.Kind(
                surface.material().lambert(),
                surface.colour().array(),
                surface.normal().array(),
                material / SolidGeometry.MATERIALS_PER_BLOCK);
    }
}
