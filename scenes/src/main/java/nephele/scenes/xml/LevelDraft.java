package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.PortalGun;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.scenes.xml.XmlScene.XmlWarning;

/**
 * A scene at time 0 as a playable level: under the black that is behind a scene, over a floor where it
 * has no ground of its own. A unit is a metre.
 *
 * @param warnings features that a level cannot hold, in the order of lines
 */
public record LevelDraft(Level level, List<XmlWarning> warnings) {
    private static final int LONGEST_NAME = 200;
    private static final Vec3 GREY = new Vec3(0.25, 0.26, 0.28);

    /** The colour behind a scene, so that a floor that only catches what falls is not seen. */
    private static final Vec3 BLACK = Vec3.ZERO;

    /**
     * A model's files as a level names them.
     *
     * @param file asset id of the mesh
     * @param texture asset id, {@code null} for none
     * @param tint the texture's mean in linear light, white for none; needed because a level's emission has no texture
     * @param box bounds of the mesh, in its own frame
     */
    public record Part(String file, String texture, Vec3 tint, Aabb box) {}

    /**
     * Converts a scene.
     *
     * @param name of the level
     * @param parts in the order of models in {@link PosedScene}; {@code null} to leave one out
     */
    public static LevelDraft of(String name, XmlScene scene, List<Part> parts) {
        PosedScene posed = PosedScene.of(scene);
        List<XmlWarning> warnings = new ArrayList<>();
        DraftLooks looks = new DraftLooks();
        DraftPlacements placements = DraftPlacements.of(scene, parts, looks, warnings);
        DraftGround ground = DraftGround.around(boxes(posed, parts, placements), scene.eye());
        DraftLights lights = DraftLights.of(posed, ground, scene, warnings);
        Environment environment = lights.environment(looks.ambientFraction());
        Level level = Level.of(printable(name), "an XML scene at time 0", environment, List.of(ground.camera()))
                .with(ground.player(), new PortalGun(1.2, 2.1, PortalShape.ARCH, 500))
                .with(
                        looks.materials(ground.hasGround() ? BLACK : GREY),
                        List.of(ground.floor()),
                        List.of(),
                        placements.placed())
                .with(environment, lights.lights());
        warnings.sort(Comparator.comparingInt(XmlWarning::line));
        return new LevelDraft(level, List.copyOf(warnings));
    }

    /**
     * Returns the models that a level can place if their meshes can be shown, by their numbers in {@link PosedScene}.
     */
    public static Set<Integer> placeable(XmlScene scene) {
        Part any = new Part("", null, new Vec3(1, 1, 1), Aabb.EMPTY);
        List<Part> parts = Collections.nCopies(PosedScene.of(scene).modelCount(), any);
        return Set.copyOf(DraftPlacements.of(scene, parts, new DraftLooks(), new ArrayList<>())
                .numbers());
    }

    private static List<Aabb> boxes(PosedScene posed, List<Part> parts, DraftPlacements placements) {
        List<Aabb> boxes = new ArrayList<>();
        for (int number : placements.numbers()) {
            boxes.add(DraftGround.box(parts.get(number).box(), posed.worldFromModel(number)));
        }
        return boxes;
    }

    private static String printable(String name) {
        String clean = name.replaceAll("\\p{Cntrl}", "?");
        return clean.substring(0, Math.min(clean.length(), LONGEST_NAME));
    }
}
