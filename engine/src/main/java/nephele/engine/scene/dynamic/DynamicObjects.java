package nephele.engine.scene.dynamic;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials;
import nephele.engine.scene.SceneMaterials.Slot;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.SolidBatch;
import nephele.engine.scene.SolidGeometry;
import nephele.engine.scene.dynamic.DynamicMesh.Builder;
import nephele.engine.scene.dynamic.DynamicMesh.Range;

/**
 * The constant data of a level's dynamic objects: shapes, meshes, materials and groups.
 *
 * @param materials materials of all dynamic objects; a kind's material block is an index into these
 * @param members for each group the bodies in it; {@link #FIGURE} for the player's character
 * @param shapes for each body
 * @param materialOf for each body its index in its block of {@code materials}
 */
public record DynamicObjects(
        DynamicMesh mesh,
        List<DynamicGroup> groups,
        List<Surface> materials,
        List<int[]> members,
        List<DynamicShape> shapes,
        int[] materialOf) {
    /** Stands for the character instead of a body's index. */
    static final int FIGURE = -1;

    /** Fineness of the character's meshes: 2 for the full number of sides of its rounded shapes, 1 for half. */
    private static final int FINE = 2;

    private static final int COARSE = 1;
    /** The flatness of the coarse mesh, in radii of the character's first part. */
    private static final double COARSE_FLATNESS = 0.005;

    /** The two materials of an observer's sphere: blue while it touches no bounding volume, red in contact. */
    private static final List<Material> OBSERVER_MATERIALS =
            List.of(observerMaterial(0.06, 0.2, 0.62), observerMaterial(0.9, 0.1, 0.02));

    private static Material observerMaterial(double r, double g, double b) {
        return new Material("observer", new Vec3(r, g, b), null, 0.35, 0.0, null, Vec3.ZERO, 1);
    }

    public static DynamicObjects of(Level level, SceneMaterials known, CharacterPresence character) {
        Builder mesh = new Builder();
        Range[] box = {BodyMeshes.box(mesh)};
        Range[] round = BodyMeshes.round(mesh);
        List<DynamicShape> shapes =
                level.bodies().stream().map(DynamicShape::of).toList();
        int[] materialOf = new int[shapes.size()];
        List<DynamicGroup> groups = new ArrayList<>();
        List<List<Integer>> sorted = new ArrayList<>();
        for (int i = 0; i < shapes.size(); i++) {
            Body body = level.bodies().get(i);
            int material = known.indexOf(body.material());
            materialOf[i] = material % SolidGeometry.MATERIALS_PER_BLOCK;
            boolean isRound = shapes.get(i).kind() != DynamicShape.BOX;
            Range[] steps = isRound ? round : box;
            SolidBatch.Kind kind = kind(known.surfaces().get(material), material);
            int group = 0;
            while (group < groups.size() && !groups.get(group).has(steps, kind)) {
                group++;
            }
            if (group == groups.size()) {
                groups.add(new DynamicGroup(steps, isRound ? BodyMeshes.flatness() : new double[1], kind));
                sorted.add(new ArrayList<>());
            }
            sorted.get(group).add(i);
        }
        List<int[]> members = new ArrayList<>();
        sorted.forEach(bodies -> members.add(bodies.stream().mapToInt(i -> i).toArray()));
        List<Surface> materials = new ArrayList<>(known.surfaces());
        if (character == CharacterPresence.POSSIBLE) {
            members.add(new int[] {FIGURE});
            groups.add(
                    level.observerStart() == null ? characterGroup(mesh, materials) : observerGroup(round, materials));
        }
        return new DynamicObjects(
                mesh.finished(), List.copyOf(groups), List.copyOf(materials), List.copyOf(members), shapes, materialOf);
    }

    /** Appends the character's materials, all in one block. */
    private static DynamicGroup characterGroup(Builder mesh, List<Surface> materials) {
        int first = append(CharacterMesh.MATERIALS, materials);
        Range[] fine = CharacterMesh.add(mesh, FINE);
        Range[] coarse = CharacterMesh.add(mesh, COARSE);
        return new DynamicGroup(
                new Range[] {fine[0], coarse[0]},
                new Range[] {fine[1], coarse[1]},
                new Range[] {fine[2], coarse[2]},
                new double[] {0, COARSE_FLATNESS},
                new SolidBatch.Kind(false, -1, -1, first / SolidGeometry.MATERIALS_PER_BLOCK),
                CharacterPart.ALL.length);
    }

    private static DynamicGroup observerGroup(Range[] round, List<Surface> materials) {
        int first = append(OBSERVER_MATERIALS, materials);
        return new DynamicGroup(
                round,
                BodyMeshes.flatness(),
                new SolidBatch.Kind(false, -1, -1, first / SolidGeometry.MATERIALS_PER_BLOCK));
    }

    /** Appends materials, all in one block, and returns the index of the first. */
    private static int append(List<Material> more, List<Surface> materials) {
        int perBlock = SolidGeometry.MATERIALS_PER_BLOCK;
        while (materials.size() % perBlock + more.size() > perBlock) {
            materials.add(materials.get(0));
        }
        int first = materials.size();
        more.forEach(material -> materials.add(new Surface(material, Slot.NONE, Slot.NONE)));
        return first;
    }

    /** Returns the index in their block of the character's first material. */
    int characterMaterial() {
        return (materials.size() - CharacterMesh.MATERIALS.size()) % SolidGeometry.MATERIALS_PER_BLOCK;
    }

    /** Returns the index in its block of the material of an observer's sphere. */
    int observerMaterial(boolean touches) {
        return (materials.size() - (touches ? 1 : 2)) % SolidGeometry.MATERIALS_PER_BLOCK;
    }

    private static SolidBatch.Kind kind(Surface surface, int material) {
        return new SolidBatch.Kind(
                surface.material().lambert(),
                surface.colour().array(),
                surface.normal().array(),
                material / SolidGeometry.MATERIALS_PER_BLOCK);
    }
}
