package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.joml.Vector3d;

/**
 * The models of a level that are drawn as impostors, single ones and those of fields. A plant is its kind, turned about
 * the vertical, scaled and moved.
 *
 * @param kinds the different meshes with their materials
 * @param plants in the order of the level
 */
public record PlantedModels(List<Kind> kinds, List<Plant> plants) {
    /** The most impostors of a level. */
    public static final int MOST = 200_000;

    /** The most kinds of a level: each has pictures of some 6 MB. */
    public static final int MOST_KINDS = 500;

    private static final int SIZE = 0;
    private static final int TURN = 2;
    private static final double TURN_RADIANS = 2 * StrictMath.PI;
    private static final double ROUNDING = 1e-9;

    public PlantedModels {
        kinds = List.copyOf(kinds);
        plants = List.copyOf(plants);
    }

    /**
     * A mesh with its material. Equal kinds look the same.
     *
     * @param mesh the content of its file
     * @param plantFromModel to metres from the plant's foot
     * @param material {@code null} for grey
     */
    public record Kind(Mesh mesh, Matrix4dc plantFromModel, String material) {
        // A mesh is read once for a level, and too large to compare.
        @Override
        public boolean equals(Object other) {
            return other instanceof Kind kind
                    && kind.mesh == mesh
                    && kind.plantFromModel.equals(plantFromModel)
                    && Objects.equals(kind.material, material);
        }

        @Override
        public int hashCode() {
            return System.identityHashCode(mesh) + 31 * plantFromModel.hashCode();
        }
    }

    /**
     * A model at a place.
     *
     * @param kind its index
     * @param model its index in the level's list
     * @param turn about the vertical, radians
     */
    public record Plant(int kind, int model, Vec3 foot, double turn, double scale) {
        /** Returns the plant's own frame in the world. */
        public Matrix4d worldFromPlant() {
            double cos = StrictMath.cos(turn) * scale;
            double sin = StrictMath.sin(turn) * scale;
            return new Matrix4d(cos, 0, -sin, 0, 0, scale, 0, 0, sin, 0, cos, 0, foot.x(), foot.y(), foot.z(), 1);
        }
    }

    /** Returns true if a level has any. */
    public static boolean isIn(Level level) {
        return level.models().stream().anyMatch(ModelPlacement::impostor);
    }

    /**
     * Plants the models of a level.
     *
     * @throws AssetException that names a density map that cannot be used, or a mesh of which there is one kind too many
     */
    public static PlantedModels of(Level level, StaticShapes statics, AssetSource assets) {
        List<Plant> plants = new ArrayList<>();
        Map<Kind, Integer> kinds = new HashMap<>();
        List<Kind> inOrder = new ArrayList<>();
        FieldPlanting planting = new FieldPlanting(statics);
        for (PlacedModel model : statics.models().all()) {
            ModelPlacement authored = model.authored();
            if (!authored.impostor()) {
                continue;
            }
            Plant alone = authored.isPlanted() ? null : alone(model);
            int kind = kinds.computeIfAbsent(kind(model, alone), added -> {
                inOrder.add(added);
                return inOrder.size() - 1;
            });
            requireFew(inOrder.size(), authored);
            if (alone != null) {
                plants.add(new Plant(kind, model.index(), alone.foot(), alone.turn(), alone.scale()));
            } else {
                SeededNoise noise = new SeededNoise(authored.id().hashCode());
                List<Vec3> feet = planting.plant(authored.field(), assets);
                for (int i = 0; i < feet.size(); i++) {
                    double scale = 1 - authored.heightVariation() * noise.unit(i, SIZE, 0);
                    double turn = TURN_RADIANS * noise.unit(i, TURN, 0);
                    plants.add(new Plant(kind, model.index(), feet.get(i), turn, scale));
                }
            }
        }
        return new PlantedModels(inOrder, plants);
    }

    /** @param alone {@code null} for the models of a field */
    private static Kind kind(PlacedModel model, Plant alone) {
        Matrix4dc shape = alone == null ? model.worldFromModel() : shape(model, alone);
        return new Kind(model.mesh(), shape, model.authored().material());
    }

    private static void requireFew(int kinds, ModelPlacement last) {
        if (kinds > MOST_KINDS) {
            throw new AssetException(
                    last.file(),
                    "a level has at most " + MOST_KINDS + " kinds of impostors, and '" + last.id() + "' is one more",
                    "let more models have the same mesh, material and form, or leave out impostor");
        }
    }

    /**
     * Returns how many kinds a level has, without planting any.
     *
     * @throws AssetException if they are too many
     */
    public static int kinds(StaticShapes statics) {
        Set<Kind> kinds = new HashSet<>();
        for (PlacedModel model : statics.models().all()) {
            if (model.authored().impostor()) {
                kinds.add(kind(model, model.authored().isPlanted() ? null : alone(model)));
                requireFew(kinds.size(), model.authored());
            }
        }
        return kinds.size();
    }

    /** Returns the place, turn and size of a single model, as far as its frame has them; its kind is not known yet. */
    private static Plant alone(PlacedModel model) {
        Matrix4dc frame = model.worldFromModel();
        double size = StrictMath.cbrt(Math.abs(frame.determinant3x3()));
        double turn = StrictMath.atan2(-frame.m02(), frame.m00());
        return new Plant(0, model.index(), new Vec3(frame.m30(), frame.m31(), frame.m32()), turn, size);
    }

    /** Returns the frame of a single model without place, turn and size; rounded, so that equal ones are found. */
    private static Matrix4d shape(PlacedModel model, Plant alone) {
        Matrix4d shape = alone.worldFromPlant().invertAffine().mul(model.worldFromModel());
        double[] values = shape.get(new double[16]);
        for (int i = 0; i < values.length; i++) {
            // Adding 0 makes 0 of −0.
            values[i] = Math.rint(values[i] / ROUNDING) * ROUNDING + 0.0;
        }
        return new Matrix4d().set(values);
    }

    /** Returns corners between which all plants of fields are, without planting them. */
    public static List<Vec3> reach(StaticShapes statics) {
        List<Vec3> corners = new ArrayList<>();
        double reach = 0;
        for (PlacedModel model : statics.models().all()) {
            if (model.authored().isPlanted()) {
                reach = Math.max(reach, farthest(model));
            }
        }
        Aabb box = statics.bounds().grown(reach);
        for (int i = 0; i < 8 && reach > 0 && !box.isEmpty(); i++) {
            corners.add(box.corner(i));
        }
        return corners;
    }

    /** Returns the greatest distance of a planted model's points from its place. */
    private static double farthest(PlacedModel model) {
        float[] at = model.mesh().positions();
        double square = 0;
        var p = new Vector3d();
        for (int i = 0; i < at.length; i += 3) {
            square = Math.max(
                    square,
                    model.worldFromModel()
                            .transformPosition(p.set(at[i], at[i + 1], at[i + 2]))
                            .lengthSquared());
        }
        return Math.sqrt(square);
    }
}
